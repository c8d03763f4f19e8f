#include "base/error.h"
#include "geometry/volume/volume_header.h"

#include <zlib.h>

#include <algorithm>
#include <fstream>
#include <ios>
#include <memory>
#include <new>
#include <vector>

namespace shellmatch {

std::string inflated_beginning(const std::string& path, std::size_t n_bytes) {
  // Reads files that are not compressed as they are.
  const std::unique_ptr<gzFile_s, int (*)(gzFile)> file(gzopen(path.c_str(), "rb"), gzclose);
  if (!file) throw_input_error("{}: cannot be opened", path);
  std::string bytes(n_bytes, '\0');
  const int n = gzread(file.get(), bytes.data(), static_cast<unsigned>(n_bytes));
  bytes.resize(n > 0 ? static_cast<std::size_t>(n) : 0);
  return bytes;
}

std::uintmax_t inflated_bytes(const std::string& path, std::uintmax_t offset, std::uintmax_t enough) {
  std::ifstream file(path, std::ios::binary);
  file.seekg(static_cast<std::streamoff>(offset));
  z_stream stream{};
  constexpr int zlib_or_gzip = 15 + 32;
  if (inflateInit2(&stream, zlib_or_gzip) != Z_OK) throw std::bad_alloc();
  std::vector<unsigned char> in(1 << 16), out(1 << 18);
  std::uintmax_t n = 0;
  bool is_good = true;
  while (is_good && n < enough) {
    file.read(reinterpret_cast<char*>(in.data()), static_cast<std::streamsize>(in.size()));
    stream.avail_in = static_cast<unsigned>(file.gcount());
    stream.next_in = in.data();
    if (stream.avail_in == 0) break;
    while (is_good && stream.avail_in > 0 && n < enough) {
      stream.next_out = out.data();
      stream.avail_out = static_cast<unsigned>(out.size());
      const int status = inflate(&stream, Z_NO_FLUSH);
      n += out.size() - stream.avail_out;
      // A file may be several streams one after another.
      is_good = status == Z_OK || (status == Z_STREAM_END && inflateReset(&stream) == Z_OK);
    }
  }
  inflateEnd(&stream);
  return std::min(n, enough);
}

}  // namespace shellmatch
