#include "tests/support/picture_files.h"

#include <algorithm>
#include <vector>

namespace shellmatch::testing {

namespace {

// PNG, appendix D.
std::uint32_t crc32(const std::string& bytes) {
  std::uint32_t crc = 0xffffffff;
  for (const char c : bytes) {
    crc ^= static_cast<unsigned char>(c);
    for (int k = 0; k < 8; ++k) crc = crc & 1 ? 0xedb88320 ^ crc >> 1 : crc >> 1;
  }
  return ~crc;
}

// RFC 1950 and 1951: stored blocks.
std::string stored(const std::string& data) {
  std::string bytes = "\x78\x01";
  std::uint32_t a = 1, b = 0;
  for (const char c : data) {
    a = (a + static_cast<unsigned char>(c)) % 65521;
    b = (b + a) % 65521;
  }
  for (std::size_t at = 0; at < data.size(); at += 65535) {
    const std::size_t n = std::min<std::size_t>(65535, data.size() - at);
    bytes += std::string(1, at + n == data.size() ? '\1' : '\0') + little(n, 2) + little(~n, 2) + data.substr(at, n);
  }
  return bytes + big(b << 16 | a, 4);
}

}  // namespace

std::string png_chunk(const std::string& kind, const std::string& data) {
  return big(static_cast<std::uint32_t>(data.size()), 4) + kind + data + big(crc32(kind + data), 4);
}

std::string tiff_bytes(int width, int height, int bits, const PixelValue& value, int format, int photometric,
                       int tile) {
  std::string pixels;
  const int side_x = tile ? tile : width, side_y = tile ? tile : height;
  std::vector<std::size_t> starts;
  for (int top = 0; top < height; top += side_y)
    for (int left = 0; left < width; left += side_x) {
      starts.push_back(8 + pixels.size());
      for (int row = top; row < top + side_y; ++row)
        for (int column = left; column < left + side_x; ++column)
          pixels += little(row < height && column < width ? value(column, row) : 0, bits / 8);
    }
  if (pixels.size() % 2) pixels.push_back('\0');
  const std::size_t n = starts.size(), bytes_of_tile = static_cast<std::size_t>(side_x) * side_y * bits / 8;
  std::string lists;
  const std::size_t lists_at = 8 + pixels.size();
  for (const std::size_t s : starts) lists += little(s, 4);
  for (std::size_t i = 0; i < n; ++i) lists += little(bytes_of_tile, 4);
  const std::size_t map_at = lists_at + lists.size();
  if (photometric == 3)
    for (int part = 0; part < 3; ++part)
      for (int c = 0; c < 1 << bits; ++c) lists += little(static_cast<std::uint64_t>(c) * 65535 / ((1 << bits) - 1), 2);
  std::vector<std::string> entries;
  const auto entry = [&](int tag, int type, std::size_t count, std::size_t v) {
    entries.push_back(little(tag, 2) + little(type, 2) + little(count, 4) + little(v, 4));
  };
  entry(256, 4, 1, width);
  entry(257, 4, 1, height);
  entry(258, 3, 1, bits);
  entry(259, 3, 1, 1);
  entry(262, 3, 1, photometric);
  if (!tile) entry(273, 4, 1, starts[0]);
  entry(277, 3, 1, 1);
  if (!tile) entry(278, 4, 1, height);
  if (!tile) entry(279, 4, 1, bytes_of_tile);
  if (photometric == 3) entry(320, 3, 3u << bits, map_at);
  if (tile) entry(322, 4, 1, tile);
  if (tile) entry(323, 4, 1, tile);
  if (tile) entry(324, 4, n, n == 1 ? starts[0] : lists_at);
  if (tile) entry(325, 4, n, n == 1 ? bytes_of_tile : lists_at + 4 * n);
  entry(339, 3, 1, format);
  std::string bytes =
      std::string("II*\0", 4) + little(lists_at + lists.size(), 4) + pixels + lists + little(entries.size(), 2);
  for (const std::string& e : entries) bytes += e;
  return bytes + little(0, 4);
}

std::string bmp_bytes(int width, int height, int bits, const PixelValue& value, int palette_step, bool downward) {
  std::string palette, pixels;
  if (bits == 8)
    for (int c = 0; c < 256; ++c) palette += std::string(3, static_cast<char>(c * palette_step)) + '\0';
  for (int line = 0; line < height; ++line) {
    std::string bytes;
    for (int column = 0; column < width; ++column)
      bytes += little(value(column, downward ? line : height - 1 - line), bits / 8);
    bytes.resize((bytes.size() + 3) / 4 * 4);
    pixels += bytes;
  }
  const std::size_t start = 54 + palette.size();
  return "BM" + little(start + pixels.size(), 4) + little(0, 4) + little(start, 4) + little(40, 4) + little(width, 4) +
         little(static_cast<std::uint32_t>(downward ? -height : height), 4) + little(1, 2) + little(bits, 2) +
         little(0, 4) + little(pixels.size(), 4) + little(0, 16) + palette + pixels;
}

std::string png_bytes(int width, int height, int bits, const PixelValue& value, const std::string& palette) {
  std::string rows;
  for (int row = 0; row < height; ++row) {
    rows.push_back('\0');
    for (int column = 0; column < width; ++column) rows += big(value(column, row), bits / 8);
  }
  const std::string head = big(width, 4) + big(height, 4) + std::string(1, static_cast<char>(bits)) +
                           std::string(1, palette.empty() ? '\0' : '\3') + std::string(3, '\0');
  return "\x89PNG\r\n\x1a\n" + png_chunk("IHDR", head) + (palette.empty() ? "" : png_chunk("PLTE", palette)) +
         png_chunk("IDAT", stored(rows)) + png_chunk("IEND", "");
}

}  // namespace shellmatch::testing
