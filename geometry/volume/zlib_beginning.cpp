#include "base/error.h"
#include "geometry/volume/volume_header.h"

#include <zlib.h>

#include <memory>

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

}  // namespace shellmatch
