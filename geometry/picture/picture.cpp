#include "geometry/picture/picture.h"

#include "base/error.h"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <cstddef>

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

namespace {

// A number of n bytes, the highest first where `is_big`. \pre they are there
std::size_t number(std::string_view bytes, std::size_t at, std::size_t n, bool is_big) {
  std::size_t value = 0;
  for (std::size_t k = 0; k < n; ++k)
    value = value << 8 | static_cast<unsigned char>(bytes[at + (is_big ? k : n - 1 - k)]);
  return value;
}

// Of the first directory of a TIFF structure, in which EXIF is.
int orientation_in(std::string_view tiff) {
  if (tiff.size() < 8) return 1;
  const bool is_big = tiff.starts_with("MM");
  const std::size_t directory = number(tiff, 4, 4, is_big);
  if (directory > tiff.size() || tiff.size() - directory < 2) return 1;
  const std::size_t n = number(tiff, directory, 2, is_big);
  for (std::size_t i = 0, at = directory + 2; i < n && at + 12 <= tiff.size(); ++i, at += 12) {
    if (number(tiff, at, 2, is_big) != 0x0112) continue;
    const std::size_t value = number(tiff, at + 8, 2, is_big);
    return value >= 1 && value <= 8 ? static_cast<int>(value) : 1;
  }
  return 1;
}

// The segments of a JPEG up to its first scan; bytes between them do not count.
int orientation_of_jpeg(std::string_view bytes) {
  constexpr std::string_view mark("Exif\0\0", 6);
  for (std::size_t at = 2; at + 4 <= bytes.size();) {
    if (bytes[at] != '\xff' || bytes[at + 1] == '\xff') {
      ++at;
      continue;
    }
    if (bytes[at + 1] == '\xda') break;
    const std::size_t size = number(bytes, at + 2, 2, true);
    const std::string_view segment = bytes.substr(at + 4, size - 2);
    if (bytes[at + 1] == '\xe1' && segment.starts_with(mark)) return orientation_in(segment.substr(mark.size()));
    at += 2 + size;
  }
  return 1;
}

int orientation_of_png(std::string_view bytes) {
  for (std::size_t at = 8; at + 12 <= bytes.size();) {
    const std::size_t size = number(bytes, at, 4, true);
    if (bytes.substr(at + 4, 4) == "eXIf") return orientation_in(bytes.substr(at + 8, size));
    at += 12 + size;
  }
  return 1;
}

}  // namespace

int exif_orientation(std::string_view bytes) {
  return bytes.starts_with("\xff\xd8") ? orientation_of_jpeg(bytes) : orientation_of_png(bytes);
}

void note_orientation(int orientation, Picture& picture) {
  static constexpr std::array words{"",
                                    "mirrored",
                                    "turned by 180 degrees",
                                    "mirrored and turned by 180 degrees",
                                    "mirrored and turned by 90 degrees to the left",
                                    "turned by 90 degrees to the right",
                                    "mirrored and turned by 90 degrees to the right",
                                    "turned by 90 degrees to the left"};
  if (orientation <= 1 || orientation > 8) return;
  picture.notes.push_back(
      fmt::format("the file asks for its picture to be shown {} (orientation {}), as OpenCV and browsers do: it is "
                  "read as it is stored, as by ImageJ",
                  words[static_cast<std::size_t>(orientation) - 1], orientation));
}

}  // namespace shellmatch
