#pragma once
/// \file
/// A raster image, and its input and output as PNG.

#include "matching/render/canvas/color.h"

#include <cstdint>
#include <string>
#include <vector>

namespace shellmatch {

/// Pixels by rows from top to bottom, three bytes each (sRGB red, green, blue).
struct Image {
  int width = 0, height = 0;
  std::vector<std::uint8_t> pixels;

  Image() = default;
  /// \pre width and height > 0
  Image(int image_width, int image_height, const Color& color = white);

  std::uint8_t* at(int x, int y) { return &pixels[3 * (static_cast<std::size_t>(y) * width + x)]; }
  const std::uint8_t* at(int x, int y) const { return &pixels[3 * (static_cast<std::size_t>(y) * width + x)]; }
  void set(int x, int y, const Color& color);
  bool operator==(const Image&) const = default;
};

/// \throws EnvironmentError if the file cannot be written.
void write_png(const Image& image, const std::string& path);

/// Transparent parts are composited over white. \throws InputError if the file is not a readable PNG.
Image read_png(const std::string& path);

}  // namespace shellmatch
