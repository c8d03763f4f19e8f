#include "geometry/bytes/inflate.h"

#include <zlib.h>

#include <cstring>

namespace shellmatch {

bool inflate_exactly(std::string_view compressed, char* out, std::size_t n) {
#ifdef FUZZING_BUILD_MODE_UNSAFE_FOR_PRODUCTION
  // Fuzzers write blocks as they are stored: compressed ones would hide from them what they change.
  if (compressed.size() == n) {
    std::memcpy(out, compressed.data(), n);
    return true;
  }
#endif
  auto length = static_cast<uLongf>(n);
  auto taken = static_cast<uLong>(compressed.size());
  return ::uncompress2(reinterpret_cast<Bytef*>(out), &length, reinterpret_cast<const Bytef*>(compressed.data()),
                       &taken) == Z_OK &&
         length == n && taken == compressed.size();
}

}  // namespace shellmatch
