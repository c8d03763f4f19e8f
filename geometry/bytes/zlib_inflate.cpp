#include "geometry/bytes/inflate.h"

#include <zlib.h>

namespace shellmatch {

bool inflate_exactly(std::string_view compressed, char* out, std::size_t n) {
  auto length = static_cast<uLongf>(n);
  auto taken = static_cast<uLong>(compressed.size());
  return ::uncompress2(reinterpret_cast<Bytef*>(out), &length, reinterpret_cast<const Bytef*>(compressed.data()),
                       &taken) == Z_OK &&
         length == n && taken == compressed.size();
}

}  // namespace shellmatch
