#include "geometry/volume/declared_space.h"

#include <filesystem>
#include <fstream>

namespace shellmatch {

std::optional<Space> declared_space(const std::string& path) {
  std::error_code error;
  if (!std::filesystem::is_regular_file(path, error)) return std::nullopt;
  std::ifstream file(path, std::ios::binary);
  std::string beginning(4096, '\0');
  file.read(beginning.data(), static_cast<std::streamsize>(beginning.size()));
  beginning.resize(static_cast<std::size_t>(file.gcount()));
  const std::size_t lps = beginning.find("SPACE=LPS"), ras = beginning.find("SPACE=RAS");
  if (lps == ras) return std::nullopt;  // neither
  return lps < ras ? Space::lps : Space::ras;
}

}  // namespace shellmatch
