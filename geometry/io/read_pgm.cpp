// Portable grey map: https://netpbm.sourceforge.net/doc/pgm.html
#include "geometry/picture/read_mask.h"
#include "geometry/mesh_text/read_text.h"

#include <optional>

namespace shellmatch {
namespace {

constexpr std::string_view white_space = " \t\r\n\v\f";

// Words separated by blanks; comments run to the end of the line.
std::int64_t next_count(std::string_view& rest, const std::string& path, std::string_view what) {
  while (true) {
    rest.remove_prefix(std::min(rest.find_first_not_of(white_space), rest.size()));
    if (!rest.starts_with('#')) break;
    rest.remove_prefix(std::min(rest.find_first_of("\r\n"), rest.size()));
  }
  if (rest.empty()) throw_input_error("{}: the PGM image is cut off: {} is missing", path, what);
  const std::optional<std::int64_t> value = to_integer(next_word(rest, white_space));
  if (!value || *value < 0) throw_input_error("{}: {} of the PGM image is not a whole number from 0", path, what);
  return *value;
}

}  // namespace

Picture read_pgm(const std::string& path, std::string_view bytes) {
  const bool text = bytes.starts_with("P2"), binary = bytes.starts_with("P5");
  if (!text && !binary) throw_input_error("{}: not a PGM image (it should start with P2 or P5)", path);
  std::string_view rest = bytes.substr(2);
  const std::int64_t width = next_count(rest, path, "the width");
  const std::int64_t height = next_count(rest, path, "the height");
  const std::int64_t white = next_count(rest, path, "the largest value");
  check_picture_size(width, height, path);
  if (white < 1 || white > 65535)
    throw_input_error("{}: the largest value of a PGM image is 1 to 65535, not {}", path, white);
  Picture picture{{static_cast<int>(width), static_cast<int>(height), {}}, {}};
  const auto n = static_cast<std::size_t>(width * height);
  const std::size_t bytes_per_value = white > 255 ? 2 : 1;
  // Exactly one blank ends the header of the binary form. A text needs a digit and a blank for each value.
  if (binary && !rest.empty()) rest.remove_prefix(1);
  const std::size_t needed = binary ? n * bytes_per_value : 2 * n - 1;
  if (rest.size() < needed)
    throw_input_error("{}: the PGM image is cut off: {} x {} pixels take {} bytes, {} are there", path, width, height,
                      needed, rest.size());
  picture.values.reserve(n);
  picture.brightness.values.reserve(n);
  for (std::size_t i = 0; i < n; ++i) {
    std::int64_t value = 0;
    if (text) {
      value = next_count(rest, path, "a pixel");
    } else {
      for (std::size_t k = 0; k < bytes_per_value; ++k)
        value = value << 8 | static_cast<unsigned char>(rest[i * bytes_per_value + k]);
    }
    if (value > white)
      throw_input_error("{}: pixel {} (counted from 0) is {}, above the largest value {}", path, i, value, white);
    picture.values.push_back(static_cast<float>(value));
    picture.brightness.values.push_back(static_cast<float>(value) / static_cast<float>(white));
  }
  return picture;
}

}  // namespace shellmatch
