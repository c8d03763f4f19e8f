// Writing: what is written reads back the same; what cannot be written leaves nothing.
#include "base/replace_file.h"
#include "geometry/io/read_shape.h"
#include "geometry/io/write_shape.h"
#include "tests/geometry/io/files.h"

#include <sys/resource.h>

#include <cmath>
#include <csignal>
#include <random>

namespace shellmatch::testing {
namespace {

// Quads, odd coordinates, and attributes of every type with the extreme values of each.
OriginalShape<3> rich_cube() {
  OriginalShape<3> shape = cube({0.1, -1e-30, 1e5}, 1.0 / 3);
  const auto add = [&](const char* name, const char* type, std::vector<double> values) {
    shape.attributes.push_back({name, type, std::move(values)});
  };
  add("a", "char", {-128, 127, 0, 1, 2, 3, 4, 5});
  add("red", "uchar", {0, 255, 1, 2, 3, 4, 5, 6});
  add("c", "short", {-32768, 32767, 0, 1, 2, 3, 4, 5});
  add("d", "ushort", {0, 65535, 1, 2, 3, 4, 5, 6});
  add("e", "int", {-2147483648.0, 2147483647, 0, 1, 2, 3, 4, 5});
  add("f", "uint", {0, 4294967295, 1, 2, 3, 4, 5, 6});
  add("quality", "float", {0.5, -0.25, 1e20f, 0, 1, 2, 3, 4});
  add("g", "double", {0.1, 1e300, -1e-300, 0, 1, 2, 3, std::nan("")});
  return shape;
}

void expect_same(const OriginalShape<3>& a, const OriginalShape<3>& b) {
  EXPECT_EQ(a.vertices, b.vertices);
  EXPECT_EQ(a.polygons, b.polygons);
  ASSERT_EQ(a.attributes.size(), b.attributes.size());
  for (std::size_t k = 0; k < a.attributes.size(); ++k) {
    EXPECT_EQ(a.attributes[k].name, b.attributes[k].name);
    EXPECT_EQ(a.attributes[k].type, b.attributes[k].type);
    for (std::size_t v = 0; v < a.vertices.size(); ++v) {
      const double x = a.attributes[k].values[v], y = b.attributes[k].values[v];
      EXPECT_TRUE(x == y || (std::isnan(x) && std::isnan(y))) << a.attributes[k].name << " " << v;
    }
  }
}

std::ptrdiff_t partial_files(const std::string& folder) {
  return std::count_if(std::filesystem::directory_iterator(folder), std::filesystem::directory_iterator(),
                       [](const auto& entry) { return is_partial_file_name(entry.path().filename().string()); });
}

TEST(Write, PlyReadsBackToTheBit) {
  const TempFolder folder;
  const OriginalShape<3> shape = rich_cube();
  write_ply(folder.path("a.ply"), shape);
  expect_same(shape, read_mesh(folder.path("a.ply")).original);
  EXPECT_EQ(partial_files(folder.path("")), 0);
  OriginalShape<3> points = shape;
  points.polygons.clear();
  write_ply(folder.path("p.ply"), points);
  expect_same(points, read_points_or_mesh_3d(folder.path("p.ply")));
}

TEST(Write, PlyTakesPolygonsOfAnyLengthAndClampsIntegers) {
  const TempFolder folder;
  OriginalShape<3> disc;
  disc.polygons.resize(1);
  for (Index i = 0; i < 300; ++i) {
    disc.vertices.emplace_back(std::cos(0.02 * i), std::sin(0.02 * i), 0);
    disc.polygons[0].push_back(i);
  }
  disc.attributes.push_back({"two words", "uchar", std::vector<double>(300, 300.0)});
  write_ply(folder.path("a.ply"), disc);
  const OriginalShape<3> read = read_points_or_mesh_3d(folder.path("a.ply"));
  EXPECT_EQ(read.polygons, disc.polygons);
  EXPECT_EQ(read.attributes.at(0).name, "two_words");
  EXPECT_EQ(read.attributes[0].values[7], 255);
}

TEST(Write, OtherMeshFormats) {
  const TempFolder folder;
  OriginalShape<3> shape = cube({0.1, 0.2, 0.3}, 0.7);
  for (const char* name : {"red", "green", "blue"})
    shape.attributes.push_back({name, "uchar", std::vector<double>(8, 51)});
  for (const char* name : {"a.obj", "a.off"}) {
    write_shape(folder.path(name), shape);
    const Shape<3> read = read_mesh(folder.path(name));
    EXPECT_EQ(read.original.vertices, shape.vertices);
    EXPECT_EQ(read.original.polygons, shape.polygons);
  }
  EXPECT_DOUBLE_EQ(read_mesh(folder.path("a.obj")).original.attributes.at(1).values.at(3), 0.2);
  write_shape(folder.path("a.STL"), shape);
  EXPECT_NEAR(volume(read_mesh(folder.path("a.STL")).surface), 0.343, 1e-6);
  write_shape(folder.path("a.csv"), shape);
  EXPECT_EQ(read_points_or_mesh_3d(folder.path("a.csv")).attributes.at(2).name, "blue");
  EXPECT_TRUE(contains(input_error_of([&] { write_shape(folder.path("a.wrl"), shape); }), ".ply, .obj"));
}

TEST(Write, OutlinesReadBackToTheBit) {
  const TempFolder folder;
  OriginalShape<2> shape;
  std::mt19937 random(5);
  std::uniform_real_distribution<double> small(-1e-3, 1e-3);
  for (const double side : {10.0, 1.0}) {
    shape.polygons.emplace_back();
    for (const auto& [x, y] : {std::pair{-1, -1}, {1, -1}, {1, 1}, {-1, 1}}) {
      shape.polygons.back().push_back(static_cast<Index>(shape.vertices.size()));
      shape.vertices.emplace_back(side * x + small(random), side * y + small(random));
    }
  }
  shape.attributes.push_back({"label", "double", {1, 2, 3, 4, 0.1, 6, 7, 8}});
  write_outline_csv(folder.path("a.csv"), shape);
  for (const OriginalShape<2>& read :
       {read_outline(folder.path("a.csv")).original, read_points_or_outline_2d(folder.path("a.csv"))}) {
    EXPECT_EQ(read.vertices, shape.vertices);
    EXPECT_EQ(read.polygons, shape.polygons);
    EXPECT_EQ(read.attributes.at(0).name, "label");
    EXPECT_EQ(read.attributes.at(0).values, shape.attributes[0].values);
  }
}

TEST(Write, WhatCannotBeWrittenLeavesNothing) {
  const TempFolder folder;
  EXPECT_THROW(write_ply(folder.path("none/a.ply"), cube()), EnvironmentError);
  std::filesystem::create_directory(folder.path("b.ply"));
  EXPECT_THROW(write_ply(folder.path("b.ply"), cube()), EnvironmentError);
  EXPECT_EQ(partial_files(folder.path("")), 0);
  // A disk that is full: no file grows beyond 100 bytes.
  const auto handler = std::signal(SIGXFSZ, SIG_IGN);
  rlimit before{};
  getrlimit(RLIMIT_FSIZE, &before);
  const rlimit small{100, before.rlim_max};
  setrlimit(RLIMIT_FSIZE, &small);
  EXPECT_THROW(write_ply(folder.path("c.ply"), cube()), EnvironmentError);
  setrlimit(RLIMIT_FSIZE, &before);
  std::signal(SIGXFSZ, handler);
  EXPECT_FALSE(std::filesystem::exists(folder.path("c.ply")));
  EXPECT_EQ(partial_files(folder.path("")), 0);
}

}  // namespace
}  // namespace shellmatch::testing
