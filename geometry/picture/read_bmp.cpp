// Windows bitmaps: https://learn.microsoft.com/windows/win32/api/wingdi/ns-wingdi-bitmapinfoheader
#include "base/error.h"
#include "geometry/picture/picture.h"

#include <array>
#include <cmath>

namespace shellmatch {

Picture read_bmp(const std::string& path, std::string_view bytes) {
  const auto number = [&](std::size_t at, int n_bytes) {
    std::uint32_t value = 0;
    for (int k = n_bytes - 1; k >= 0; --k)
      value = value << 8 | static_cast<unsigned char>(bytes[at + static_cast<std::size_t>(k)]);
    return value;
  };
  constexpr std::size_t head = 54;
  if (!bytes.starts_with("BM")) throw_input_error("{}: not a BMP image (it should start with BM)", path);
  if (bytes.size() < head || number(14, 4) < 40)
    throw_input_error("{}: the BMP image is cut off, or of before 1990; save it again", path);
  const std::int64_t width = static_cast<std::int32_t>(number(18, 4)), tall = static_cast<std::int32_t>(number(22, 4)),
                     height = std::abs(tall);
  const std::uint32_t bits = number(28, 2), compression = number(30, 4);
  check_picture_size(width, height, path);
  // 3: masks that say where the colours lie, which are those of plain 32 bits in what programs write.
  if (!(compression == 0 || (compression == 3 && bits == 32)) ||
      !(bits == 1 || bits == 4 || bits == 8 || bits == 24 || bits == 32))
    throw_input_error(
        "{}: BMP images are read with 1, 4, 8, 24 or 32 bits, not compressed; this one has {} (compression {}): save "
        "it as PNG",
        path, bits, compression);
  const std::size_t start = number(10, 4), line = (static_cast<std::size_t>(width) * bits + 31) / 32 * 4,
                    palette = 14 + std::size_t{number(14, 4)};
  const std::size_t n_colours = bits > 8 ? 0 : number(46, 4) == 0 ? std::size_t{1} << bits : std::size_t{number(46, 4)};
  if (n_colours > 256 || palette + 4 * n_colours > bytes.size() || start > bytes.size() ||
      bytes.size() - start < line * static_cast<std::size_t>(height))
    throw_input_error("{}: the BMP image is cut off: {} x {} pixels with {} bits take {} bytes; save it again", path,
                      width, height, bits, start + line * static_cast<std::size_t>(height));
  const auto byte = [&](std::size_t at) { return static_cast<unsigned char>(bytes[at]); };
  const auto colour_at = [&](std::size_t at) { return luminance(byte(at + 2), byte(at + 1), byte(at)); };
  std::array<float, 256> tones{};
  // A palette that is a ramp of grey is grey values.
  bool is_ramp = bits == 8 && n_colours == 256;
  for (std::size_t c = 0; c < n_colours; ++c) {
    tones[c] = colour_at(palette + 4 * c);
    for (std::size_t k = 0; k < 3; ++k) is_ramp = is_ramp && byte(palette + 4 * c + k) == c;
  }
  Picture picture{{static_cast<int>(width), static_cast<int>(height), {}},
                  {},
                  bits > 8  ? PictureKind::colour
                  : is_ramp ? PictureKind::grey
                            : PictureKind::palette};
  for (std::int64_t row = 0; row < height; ++row) {
    const std::size_t from =
        start + line * static_cast<std::size_t>(tall > 0 ? height - 1 - row : row);  // most run upward
    for (std::size_t i = 0; i < static_cast<std::size_t>(width); ++i) {
      const std::size_t at = from + i * bits / 8;
      if (bits > 8) {
        picture.brightness.values.push_back(colour_at(at));
        picture.values.push_back(std::round(255 * picture.brightness.values.back()));
        continue;
      }
      const std::size_t index = byte(at) >> (8 - bits - i * bits % 8) & ((1u << bits) - 1);
      if (index >= n_colours)
        throw_input_error("{}: a pixel of the BMP image has the colour {} of {}; save it again", path, index,
                          n_colours);
      picture.brightness.values.push_back(tones[index]);
      picture.values.push_back(static_cast<float>(index));
    }
  }
  return picture;
}

}  // namespace shellmatch
