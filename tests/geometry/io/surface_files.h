#pragma once
/// \file
/// Files of neuroimaging and of scenes, written in the form that their specifications define.

#include "tests/geometry/io/files.h"

#include <bit>
#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace shellmatch::testing {

/// The bytes of a number, the highest first where `is_big`.
template <class T>
std::string number_bytes(T value, bool is_big) {
  std::string bytes(reinterpret_cast<const char*>(&value), sizeof value);
  return is_big ? std::string(bytes.rbegin(), bytes.rend()) : bytes;
}

inline std::string base64(std::string_view bytes) {
  constexpr std::string_view digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    std::uint32_t group = 0;
    for (std::size_t k = 0; k < 3; ++k)
      group = group << 8 | (i + k < bytes.size() ? static_cast<unsigned char>(bytes[i + k]) : 0u);
    for (std::size_t k = 0; k < 4; ++k) text += i + k < bytes.size() + 1 ? digits[group >> (18 - 6 * k) & 63] : '=';
  }
  return text;
}

/// The cube of files.h, each face as two triangles.
inline OriginalShape<3> triangulated_cube(const Vec<3>& corner = Vec<3>::Zero(), double side = 1) {
  OriginalShape<3> shape = cube(corner, side);
  std::vector<std::vector<Index>> triangles;
  for (const auto& q : shape.polygons) {
    triangles.push_back({q[0], q[1], q[2]});
    triangles.push_back({q[0], q[2], q[3]});
  }
  shape.polygons = triangles;
  return shape;
}

/// FreeSurfer's file of triangles. \param footer what stands after them
inline std::string freesurfer_bytes(const OriginalShape<3>& shape, std::string_view footer) {
  std::string bytes =
      "\xff\xff\xfe"
      "created by a test\n\n";
  bytes += number_bytes(static_cast<std::int32_t>(shape.vertices.size()), true) +
           number_bytes(static_cast<std::int32_t>(shape.polygons.size()), true);
  for (const Vec<3>& x : shape.vertices)
    for (int k = 0; k < 3; ++k) bytes += number_bytes(static_cast<float>(x[k]), true);
  for (const auto& polygon : shape.polygons)
    for (const Index v : polygon) bytes += number_bytes(static_cast<std::int32_t>(v), true);
  return bytes + std::string(footer);
}

enum class ZipForm { narrow, wide };

/// A ZIP archive of parts that are not compressed; wide with all numbers in the records of ZIP64, as lib3mf writes it.
inline std::string zip_bytes(const std::vector<std::pair<std::string, std::string>>& parts,
                             ZipForm form = ZipForm::narrow) {
  const auto word = [](std::size_t value, std::size_t n) {
    std::string bytes;
    for (std::size_t k = 0; k < n; ++k) bytes.push_back(static_cast<char>(value >> (8 * k) & 0xff));
    return bytes;
  };
  const bool is_wide = form == ZipForm::wide;
  const auto narrow = [&](std::size_t value) { return word(is_wide ? 0xffffffff : value, 4); };
  std::string files, directory;
  for (const auto& [name, content] : parts) {
    const std::string sizes = word(0, 4) + narrow(content.size()) + narrow(content.size()) + word(name.size(), 2),
                      wide = word(content.size(), 8) + word(content.size(), 8) + word(files.size(), 8),
                      extra = is_wide ? word(0x5455, 2) + word(1, 2) + "x" + word(1, 2) + word(24, 2) + wide : "";
    directory += "PK\1\2" + word(45, 2) + word(45, 2) + word(0, 2) + word(0, 2) + word(0, 4) + sizes +
                 word(extra.size(), 2) + word(0, 2) + word(0, 2) + word(0, 2) + word(0, 4) + narrow(files.size()) +
                 name + extra;
    const std::string local = is_wide ? word(1, 2) + word(16, 2) + wide.substr(0, 16) : "";
    files += "PK\3\4" + word(45, 2) + word(0, 2) + word(0, 2) + word(0, 4) + sizes + word(local.size(), 2) + name +
             local + content;
  }
  std::string end;
  if (is_wide)
    end = "PK\6\6" + word(44, 8) + word(45, 2) + word(45, 2) + word(0, 4) + word(0, 4) + word(parts.size(), 8) +
          word(parts.size(), 8) + word(directory.size(), 8) + word(files.size(), 8) + "PK\6\7" + word(0, 4) +
          word(files.size() + directory.size(), 8) + word(1, 4);
  return files + directory + end + "PK\5\6" + word(0, 4) + word(parts.size(), 2) + word(parts.size(), 2) +
         word(directory.size(), 4) + narrow(files.size()) + word(0, 2);
}

}  // namespace shellmatch::testing
