// In place of zlib: a block that is stored as it is, of exactly the length that is asked for, is taken so. Others are
// expanded by zlib.
#include "geometry/bytes/inflate.h"

#include <zlib.h>

#include <cstring>

namespace shellmatch {

bool inflate_exactly(std::string_view compressed, char* out, std::size_t n) {
  if (compressed.size() == n) {
    std::memcpy(out, compressed.data(), n);
    return true;
  }
  auto length = static_cast<uLongf>(n);
  auto taken = static_cast<uLong>(compressed.size());
  return ::uncompress2(reinterpret_cast<Bytef*>(out), &length, reinterpret_cast<const Bytef*>(compressed.data()),
                       &taken) == Z_OK &&
         length == n && taken == compressed.size();
}

}  // namespace shellmatch
