#include "geometry/bytes/inflate.h"

#include <zlib.h>

#include <algorithm>
#include <limits>

namespace shellmatch {

std::optional<std::string> inflate_stream(std::string_view packed, StreamForm form, std::size_t size) {
  if (size / max_expansion > packed.size()) return {};
  std::string bytes(size, '\0');
  z_stream stream{};
  if (inflateInit2(&stream, form == StreamForm::raw ? -15 : 47) != Z_OK) return {};
  // Their lengths are 32 bits wide: both go in pieces.
  constexpr std::size_t piece = std::numeric_limits<uInt>::max();
  std::size_t taken = 0, given = 0;
  int state = Z_OK;
  while (state == Z_OK) {
    const std::size_t in = std::min(piece, packed.size() - taken), out = std::min(piece, size - given);
    stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(packed.data() + taken));
    stream.avail_in = static_cast<uInt>(in);
    stream.next_out = reinterpret_cast<Bytef*>(bytes.data() + given);
    stream.avail_out = static_cast<uInt>(out);
    state = ::inflate(&stream, Z_NO_FLUSH);
    taken += in - stream.avail_in;
    given += out - stream.avail_out;
  }
  inflateEnd(&stream);
  if (state != Z_STREAM_END || taken != packed.size() || given != size) return {};
  return bytes;
}

}  // namespace shellmatch
