#include "matching/input/shape_source.h"

#include "geometry/repair/make_shape.h"
#include "geometry/volume/volume_name.h"
#include "geometry/label/volume_shape.h"
#include "matching/experiment/generated_source.h"

#include <utility>

namespace shellmatch {

AnyShape open_shape(const std::string& source, Closing closing, Space space) {
  if (const auto volume = parse_volume_name(source)) return volume_shape(*volume, source, space);
  if (!is_generated_source(source)) return read_shape(source, closing);
  return std::visit([&](auto original) -> AnyShape { return make_shape(std::move(original), source); },
                    generated_original(source));
}

std::string file_of_shape(const std::string& source) { return file_of(source); }

}  // namespace shellmatch
