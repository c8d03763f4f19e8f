#include "geometry/io/part_name.h"

#include "geometry/io/input_file.h"

namespace shellmatch {

PartName split_part(const std::string& source) {
  for (std::size_t colon = source.find(':'); colon != source.npos; colon = source.find(':', colon + 1)) {
    const std::string file = source.substr(0, colon);
    if (has_parts(format_of(file))) return {file, source.substr(colon + 1)};
  }
  return {source, {}};
}

}  // namespace shellmatch
