#include "geometry/picture/picture.h"

#include "base/error.h"

#include <array>
#include <cmath>

namespace shellmatch {

void check_picture_size(std::int64_t width, std::int64_t height, const std::string& path) {
  if (width <= 0 || height <= 0)
    throw_input_error("{}: the picture has {} x {} pixels; save it again", path, width, height);
  if (width > max_pixels || height > max_pixels || width * height > max_pixels)
    throw_input_error("{}: {} x {} pixels; up to {} million are read: scale the image", path, width, height,
                      max_pixels / 1'000'000);
}

float luminance(unsigned char red, unsigned char green, unsigned char blue) {
  if (red == green && green == blue) return static_cast<float>(red) / 255;
  static const std::array<double, 256> linear = [] {
    std::array<double, 256> table{};
    for (std::size_t i = 0; i < table.size(); ++i) {
      const double c = static_cast<double>(i) / 255;
      table[i] = c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4);
    }
    return table;
  }();
  const double y = 0.2126 * linear[red] + 0.7152 * linear[green] + 0.0722 * linear[blue];
  return static_cast<float>(y <= 0.0031308 ? 12.92 * y : 1.055 * std::pow(y, 1 / 2.4) - 0.055);
}

}  // namespace shellmatch
