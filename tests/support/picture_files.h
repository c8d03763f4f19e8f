#pragma once
/// \file
/// Bytes of pictures, written as their specifications say, by no library of the readers'.

#include <cstdint>
#include <functional>
#include <string>

namespace shellmatch::testing {

/// A number as `n_bytes` bytes, the lowest first.
inline std::string little(std::uint64_t value, int n_bytes) {
  std::string bytes;
  for (int k = 0; k < n_bytes; ++k) bytes.push_back(static_cast<char>(value >> 8 * k));
  return bytes;
}

/// The same, the highest first.
inline std::string big(std::uint64_t value, int n_bytes) {
  const std::string bytes = little(value, n_bytes);
  return {bytes.rbegin(), bytes.rend()};
}

/// A chunk of a PNG.
std::string png_chunk(const std::string& kind, const std::string& data);

/// The value of the pixel in a column and a row from the top.
using PixelValue = std::function<std::uint32_t(int column, int row)>;

/// TIFF 6.0 of one value per pixel: a strip, or square tiles where `tile` is their side; not compressed.
/// \param format 1 unsigned, 2 signed, 3 floating (then `value` gives its bits) \param photometric 1 grey, 3 palette of
/// grey
std::string tiff_bytes(int width, int height, int bits, const PixelValue& value, int format = 1, int photometric = 1,
                       int tile = 0);

/// BMP of 8 bits with a palette of grey (`palette_step` 1) or another one, or of 24 bits; lines run upward unless
/// `downward`.
std::string bmp_bytes(int width, int height, int bits, const PixelValue& value, int palette_step = 1,
                      bool downward = false);

/// PNG of grey values with 8 or 16 bits, or with a palette of red, green, blue bytes; stored without compression.
std::string png_bytes(int width, int height, int bits, const PixelValue& value, const std::string& palette = "");

}  // namespace shellmatch::testing
