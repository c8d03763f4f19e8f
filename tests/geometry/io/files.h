#pragma once
/// \file
/// Files made for one test, a cube to write into them, and what a message must say.

#include "base/error.h"
#include "geometry/surface/surface.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace shellmatch::testing {

/// A folder that goes away with its files.
class TempFolder {
 public:
  TempFolder() {
    std::string name = (std::filesystem::temp_directory_path() / "shellmatch-io-XXXXXX").string();
    if (!mkdtemp(name.data())) throw std::runtime_error("no temporary folder");
    path_ = name;
  }
  ~TempFolder() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
  }
  TempFolder(const TempFolder&) = delete;
  TempFolder& operator=(const TempFolder&) = delete;

  std::string path(const std::string& name) const { return (path_ / name).string(); }
  std::string write(const std::string& name, std::string_view bytes) const {
    std::ofstream(path(name), std::ios::binary).write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
    return path(name);
  }
  std::string read(const std::string& name) const {
    std::ifstream in(path(name), std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
  }

 private:
  std::filesystem::path path_;
};

/// The text of the InputError that `body` throws; empty where it throws none.
std::string input_error_of(auto&& body) {
  try {
    body();
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

inline ::testing::AssertionResult contains(const std::string& text, std::string_view part) {
  if (text.find(part) != std::string::npos) return ::testing::AssertionSuccess();
  return ::testing::AssertionFailure() << "'" << text << "' does not contain '" << part << "'";
}

/// Does one of the notes contain `part`?
template <int Dim>
bool has_note(const Shape<Dim>& shape, std::string_view part) {
  for (const std::string& note : shape.notes)
    if (note.find(part) != std::string::npos) return true;
  return false;
}

/// The cube [corner, corner + side]^3 of six quads that face outward.
inline OriginalShape<3> cube(const Vec<3>& corner = Vec<3>::Zero(), double side = 1) {
  OriginalShape<3> shape;
  for (int i = 0; i < 8; ++i) shape.vertices.push_back(corner + side * Vec<3>(i & 1, i >> 1 & 1, i >> 2 & 1));
  shape.polygons = {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}};
  return shape;
}

/// Adds the vertices and polygons of `other`, turned inside out where `turned`.
inline void append(OriginalShape<3>& shape, const OriginalShape<3>& other, bool turned = false) {
  const auto first = static_cast<Index>(shape.vertices.size());
  shape.vertices.insert(shape.vertices.end(), other.vertices.begin(), other.vertices.end());
  for (std::vector<Index> polygon : other.polygons) {
    if (turned) std::reverse(polygon.begin(), polygon.end());
    for (Index& v : polygon) v += first;
    shape.polygons.push_back(std::move(polygon));
  }
}

/// Text of an OFF file.
inline std::string off_text(const OriginalShape<3>& shape) {
  std::string text = fmt::format("OFF\n{} {} 0\n", shape.vertices.size(), shape.polygons.size());
  for (const Vec<3>& x : shape.vertices) text += fmt::format("{} {} {}\n", x.x(), x.y(), x.z());
  for (const auto& polygon : shape.polygons) {
    text += fmt::format("{}", polygon.size());
    for (const Index v : polygon) text += fmt::format(" {}", v);
    text += "\n";
  }
  return text;
}

/// Volume by the divergence theorem.
inline double volume(const Surface<3>& s) {
  double sum = 0;
  for (const auto& [a, b, c] : s.facets) {
    Mat<3> corners;
    corners << s.vertices[a], s.vertices[b], s.vertices[c];
    sum += corners(0, 0) * (corners(1, 1) * corners(2, 2) - corners(2, 1) * corners(1, 2)) -
           corners(0, 1) * (corners(1, 0) * corners(2, 2) - corners(2, 0) * corners(1, 2)) +
           corners(0, 2) * (corners(1, 0) * corners(2, 1) - corners(2, 0) * corners(1, 1));
  }
  return sum / 6;
}

/// Area by the trapezoidal formula.
inline double area(const Surface<2>& s) {
  double sum = 0;
  for (const auto& [a, b] : s.facets)
    sum += 0.5 * (s.vertices[a].x() * s.vertices[b].y() - s.vertices[a].y() * s.vertices[b].x());
  return sum;
}

/// Is every edge run through once in each direction? Then the surface is closed and consistently oriented.
inline bool is_closed_and_oriented(const Surface<3>& s) {
  std::vector<std::pair<Index, Index>> edges, opposite;
  for (const auto& facet : s.facets)
    for (std::size_t k = 0; k < 3; ++k) {
      edges.emplace_back(facet[k], facet[(k + 1) % 3]);
      opposite.emplace_back(facet[(k + 1) % 3], facet[k]);
    }
  std::sort(edges.begin(), edges.end());
  std::sort(opposite.begin(), opposite.end());
  return !edges.empty() && edges == opposite && std::adjacent_find(edges.begin(), edges.end()) == edges.end();
}

}  // namespace shellmatch::testing
