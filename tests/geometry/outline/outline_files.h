#pragma once
/// \file
/// Outlines as other programs write them, and what reading them must give.

#include "geometry/io/read_shape.h"
#include "tests/geometry/io/files.h"

#include <fmt/ranges.h>

#include <bit>
#include <cstdint>
#include <string>
#include <vector>

namespace shellmatch::testing {

/// A region of ImageJ: its header, coordinates, and a second header with the name, big-endian (ij.io.RoiEncoder).
struct Roi {
  int type = 0, version = 227, options = 0, subtype = 0, arc = 0;
  int top = 0, left = 0, bottom = 0, right = 0;
  std::vector<std::pair<double, double>> points = {};  ///< of the image
  std::vector<float> floats = {};                      ///< from byte 18 on
  float parameter = 0;
  std::vector<float> segments = {};  ///< of a composite region
  std::u16string name = {};

  static std::string half(int value) { return {static_cast<char>(value >> 8 & 255), static_cast<char>(value & 255)}; }
  static std::string word(std::uint32_t value) {
    return half(static_cast<int>(value >> 16)) + half(static_cast<int>(value & 0xffff));
  }
  static std::string real(double value) { return word(std::bit_cast<std::uint32_t>(static_cast<float>(value))); }

  std::string bytes() const {
    std::string head = "Iout" + half(version) + half(type << 8) + half(top) + half(left) + half(bottom) + half(right) +
                       half(static_cast<int>(points.size()));
    for (const float x : floats) head += real(x);
    head.resize(36, '\0');
    head += word(static_cast<std::uint32_t>(segments.size()));
    head.resize(48, '\0');
    head += half(subtype) + half(options) + (parameter != 0 ? real(parameter) : half(0) + half(arc));
    head.resize(60, '\0');
    std::string body;
    for (const float x : segments) body += real(x);
    for (const bool is_y : {false, true})
      for (const auto& [x, y] : points) body += half(static_cast<int>(is_y ? y - top : x - left));
    if ((options & 128) != 0)
      for (const bool is_y : {false, true})
        for (const auto& [x, y] : points) body += real(is_y ? y : x);
    if (name.empty()) return head + word(0) + body;
    const auto second = static_cast<std::uint32_t>(64 + body.size());
    std::string tail(64, '\0');
    tail.replace(16, 8, word(second + 64) + word(static_cast<std::uint32_t>(name.size())));
    for (const char16_t c : name) tail += half(c);
    return head + word(second) + body + tail;
  }
};

/// The vertices of ring `k`.
inline std::vector<Vec<2>> ring(const Shape<2>& shape, std::size_t k = 0) {
  std::vector<Vec<2>> points;
  for (const Index v : shape.original.polygons.at(k))
    points.push_back(shape.original.vertices[static_cast<std::size_t>(v)]);
  return points;
}

/// Notes without those of the mending.
inline std::string notes_of(const Shape<2>& shape) { return fmt::format("{}", fmt::join(shape.notes, "; ")); }

using Points = std::vector<Vec<2>>;

}  // namespace shellmatch::testing
