// What the readers of mesh files take, keep and refuse.
#include "geometry/io/read_shape.h"
#include "tests/geometry/io/files.h"

#include <bit>
#include <cmath>
#include <cstring>

namespace shellmatch::testing {
namespace {

const char* const cube_faces = "f 1 3 4 2\nf 5 6 8 7\nf 1 2 6 5\nf 3 7 8 4\nf 1 5 7 3\nf 2 4 8 6\n";
const char* const cube_vertices = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 0\nv 0 0 1\nv 1 0 1\nv 0 1 1\nv 1 1 1\n";

std::string message(const TempFolder& folder, const std::string& name, std::string_view bytes) {
  return input_error_of([&] { read_mesh(folder.write(name, bytes)); });
}

template <class T>
std::string bytes_of(T value, bool big_endian) {
  std::string bytes(reinterpret_cast<const char*>(&value), sizeof value);
  return big_endian ? std::string(bytes.rbegin(), bytes.rend()) : bytes;
}

TEST(MeshFiles, ObjOddities) {
  const TempFolder folder;
  const std::string header = "# comment\r\nmtllib x.mtl\r\n";
  for (const std::string& text :
       {header + cube_vertices + cube_faces, std::string("\xEF\xBB\xBF") + cube_vertices + "\n\t \n" + cube_faces,
        std::string(cube_faces) + cube_vertices,  // faces before the vertices
        std::string(cube_vertices) + "f -8 -6 -5 -7\nf -4 -3 -1 -2\nf 1/1 2/2 6/3 5/4\nf 3//1 7//1 \\\n8//2 4//1\n"
                                     "f 1/1/1 5/2/3 7/2/1 3/1/1\n  f\t2\t4\t8\t6  # last"}) {
    const Shape<3> shape = read_mesh(folder.write("würfel größe.OBJ", text));
    EXPECT_EQ(shape.original.polygons.size(), 6u);
    EXPECT_EQ(shape.original.polygons[0], (std::vector<Index>{0, 2, 3, 1}));
    EXPECT_EQ(shape.surface.facets.size(), 12u);
    EXPECT_NEAR(volume(shape.surface), 1, 1e-15);
  }
  std::string old_mac = std::string(cube_vertices) + cube_faces;
  std::replace(old_mac.begin(), old_mac.end(), '\n', '\r');
  EXPECT_NEAR(volume(read_mesh(folder.write("mac.obj", old_mac)).surface), 1, 1e-15);
}

TEST(MeshFiles, ObjColoursAreKeptEvenWhereTheyAreNoNumbers) {
  const TempFolder folder;
  std::string text;
  for (int i = 0; i < 8; ++i)
    text += fmt::format("v {} {} {} {} 0.5 {}\n", i & 1, i >> 1 & 1, i >> 2 & 1, i == 3 ? "nan" : "0.25", 0.1 * i);
  const Shape<3> shape = read_mesh(folder.write("a.obj", text + cube_faces));
  ASSERT_EQ(shape.original.attributes.size(), 3u);
  EXPECT_EQ(shape.original.attributes[2].name, "blue");
  EXPECT_DOUBLE_EQ(shape.original.attributes[2].values[7], 0.1 * 7);
  EXPECT_TRUE(std::isnan(shape.original.attributes[0].values[3]));
}

TEST(MeshFiles, ObjErrorsNameTheLine) {
  const TempFolder folder;
  const std::string good = std::string(cube_vertices) + cube_faces;
  EXPECT_TRUE(contains(message(folder, "a.obj", good + "f 1 2 9\n"), "a.obj, line 15: a face names vertex 8"));
  EXPECT_TRUE(contains(message(folder, "a.obj", good + "f 1 2 0\n"),
                       "line 15: a corner of a face should be a vertex number from 1"));
  EXPECT_TRUE(contains(message(folder, "a.obj", good + "f 1 2 -9\n"), "line 15"));
  EXPECT_TRUE(contains(message(folder, "a.obj", good + "f 1 x 2\n"), "line 15"));
  EXPECT_TRUE(contains(message(folder, "a.obj", good + "v 1 2\n"), "line 15"));
  EXPECT_TRUE(contains(message(folder, "a.obj", good + "v 1 2 nan\n"), "line 15: vertex 8"));
  EXPECT_TRUE(contains(message(folder, "a.obj", good + "v 1 2 1e999\n"), "line 15: vertex 8"));
  EXPECT_TRUE(contains(message(folder, "a.obj", cube_vertices), "no faces"));
  EXPECT_TRUE(contains(message(folder, "a.obj", "<html>"), "no vertices"));
}

TEST(MeshFiles, OffHeadersAndColours) {
  const TempFolder folder;
  const std::string text = off_text(cube());
  const std::string body = text.substr(text.find('\n') + 1);
  for (const std::string& variant : {"OFF " + body, "\t OFF" + body, body, "# c\n\nOFF # d\n\n" + body + "\n\n"})
    EXPECT_NEAR(volume(read_mesh(folder.write("a.off", variant)).surface), 1, 1e-15);
  std::string coloured = "COFF\n8 6 0\n";
  for (int i = 0; i < 8; ++i) coloured += fmt::format("{} {} {} {} 2 3 255\n", i & 1, i >> 1 & 1, i >> 2 & 1, 10 * i);
  const Shape<3> shape = read_mesh(folder.write("b.off", coloured + body.substr(body.find("4 0 2 3 1"))));
  ASSERT_EQ(shape.original.attributes.size(), 4u);
  EXPECT_EQ(shape.original.attributes[0].type, "uchar");
  EXPECT_EQ(shape.original.attributes[0].values[5], 50);
  EXPECT_FALSE(has_note(shape, "faces dropped"));
  std::string red = text;
  red.replace(red.find("4 0 2 3 1"), 9, "4 0 2 3 1 255 0 0");
  EXPECT_TRUE(has_note(read_mesh(folder.write("c.off", red)), "colours of faces dropped"));
}

TEST(MeshFiles, OffErrorsNameTheLine) {
  const TempFolder folder;
  const std::string text = off_text(cube());
  EXPECT_TRUE(contains(message(folder, "a.off", text + "3 0 1 2\n"), "line 17: the header declares"));
  EXPECT_TRUE(
      contains(message(folder, "a.off", text.substr(0, text.size() - 10)), "declares 6 faces, the file ends after 5"));
  EXPECT_TRUE(contains(message(folder, "a.off", "OFF\n99999999999 3 0\n0 0 0\n"), "ends after 1"));
  EXPECT_TRUE(contains(message(folder, "a.off", "OFF\n1 -3 0\n0 0 0\n"), "line 2"));
  EXPECT_TRUE(contains(message(folder, "a.off", "OFF\n1 1 0\n0 0 0\n99999999999 0\n"), "line 4"));
  EXPECT_TRUE(contains(message(folder, "a.off", "4OFF\n1 1 0\n0 0 0 1\n"), "not supported"));
  EXPECT_TRUE(contains(message(folder, "a.off", "OFF BINARY\n1 1 0\n"), "binary OFF"));
  EXPECT_TRUE(contains(message(folder, "a.off", "solid\n"), "line 1"));
}

class PlyForms : public ::testing::TestWithParam<const char*> {};

TEST_P(PlyForms, KeepAttributesWithTheirTypes) {
  const TempFolder folder;
  const std::string form = GetParam();
  const bool big = form == "binary_big_endian";
  std::string bytes = "ply\nformat " + form +
                      " 1.0\ncomment é\nelement camera 1\nproperty list uchar int who\nelement vertex 8\n"
                      "property uchar red\nproperty float x\nproperty double y\nproperty float32 z\nproperty float nx\n"
                      "property float ny\nproperty float nz\nproperty int16 label\nproperty double quality\n"
                      "element face 6\nproperty uint8 flag\nproperty list uint8 uint32 vertex_index\nend_header\n";
  const OriginalShape<3> shape = cube();
  if (form == "ascii") {
    bytes += "2 5 6\n";
    for (int i = 0; i < 8; ++i)
      bytes += fmt::format("{} {} {} {} 0 0 1 {} {}\n", 30 * i, i & 1, i >> 1 & 1, i >> 2 & 1, -7 * i, 0.1 * i);
    for (const auto& p : shape.polygons) bytes += fmt::format("9 4 {} {} {} {}\n", p[0], p[1], p[2], p[3]);
  } else {
    bytes += bytes_of(std::uint8_t{2}, big) + bytes_of(std::int32_t{5}, big) + bytes_of(std::int32_t{6}, big);
    for (int i = 0; i < 8; ++i) {
      bytes += bytes_of(static_cast<std::uint8_t>(30 * i), big) + bytes_of(static_cast<float>(i & 1), big);
      bytes += bytes_of(static_cast<double>(i >> 1 & 1), big) + bytes_of(static_cast<float>(i >> 2 & 1), big);
      for (int k = 0; k < 3; ++k) bytes += bytes_of(1.0f, big);
      bytes += bytes_of(static_cast<std::int16_t>(-7 * i), big) + bytes_of(0.1 * i, big);
    }
    for (const auto& p : shape.polygons) {
      bytes += bytes_of(std::uint8_t{9}, big) + bytes_of(std::uint8_t{4}, big);
      for (const Index v : p) bytes += bytes_of(static_cast<std::uint32_t>(v), big);
    }
  }
  const Shape<3> read = read_mesh(folder.write("a.ply", bytes));
  EXPECT_NEAR(volume(read.surface), 1, 1e-15);
  EXPECT_EQ(read.original.polygons, shape.polygons);
  EXPECT_TRUE(has_note(read, "normals dropped"));
  ASSERT_EQ(read.original.attributes.size(), 3u);
  const char* const names[] = {"red", "label", "quality"};
  const char* const types[] = {"uchar", "short", "double"};
  const double steps[] = {30, -7, 0.1};
  for (std::size_t k = 0; k < 3; ++k) {
    EXPECT_EQ(read.original.attributes[k].name, names[k]);
    EXPECT_EQ(read.original.attributes[k].type, types[k]);
    for (int i = 0; i < 8; ++i) EXPECT_DOUBLE_EQ(read.original.attributes[k].values[i], steps[k] * i);
  }
}

INSTANTIATE_TEST_SUITE_P(AllForms, PlyForms, ::testing::Values("ascii", "binary_little_endian", "binary_big_endian"));

TEST(MeshFiles, PlyErrorsNameTheElement) {
  const TempFolder folder;
  const auto header = [](const char* form, std::int64_t n_vertices, std::int64_t n_faces,
                         const char* count_type = "uchar") {
    return fmt::format(
        "ply\nformat {} 1.0\nelement vertex {}\nproperty float x\nproperty float y\nproperty float z\n"
        "element face {}\nproperty list {} int vertex_indices\nend_header\n",
        form, n_vertices, n_faces, count_type);
  };
  const std::string points = "0 0 0\n1 0 0\n0 1 0\n0 0 1\n", faces = "3 0 2 1\n3 0 1 3\n3 1 2 3\n3 2 0 3\n";
  EXPECT_EQ(message(folder, "a.ply", header("ascii", 4, 4) + points + faces), "");
  EXPECT_TRUE(contains(message(folder, "a.ply", header("ascii", 4, 3) + points + faces),
                       "line 17: the header declares 4 vertex"));
  EXPECT_TRUE(contains(message(folder, "a.ply", header("ascii", 4, 5) + points + faces),
                       "5 elements of kind 'face', the file ends in number 5"));
  EXPECT_TRUE(contains(message(folder, "a.ply", header("ascii", 4, 4) + points + "3 0 2 4\n" + faces),
                       "line 14: a face names vertex 4"));
  EXPECT_TRUE(
      contains(message(folder, "a.ply", header("ascii", 4, 4) + "0 0 inf\n" + points + faces), "line 10: vertex 0"));
  EXPECT_TRUE(contains(message(folder, "a.ply", header("ascii", 4, 4) + "0 0\n" + points + faces),
                       "line 10: a value of the vertex is missing"));
  for (const char* form : {"ascii", "binary_little_endian"})
    EXPECT_TRUE(
        contains(message(folder, "a.ply", header(form, 1'000'000'000'000'000, 4) + points), "which do not fit into"));
  EXPECT_TRUE(contains(message(folder, "a.ply", header("ascii", 4, 1, "char") + points + "-3 0 1 2\n"), "negative"));
  EXPECT_TRUE(
      contains(message(folder, "a.ply",
                       header("binary_little_endian", 1, 1, "uint") + std::string(12, '\0') + std::string(4, '\x7f')),
               "kind 'face', the file ends in number 1"));
  EXPECT_TRUE(contains(message(folder, "a.ply", header("ascii", -4, 4)), "line 3"));
  // Twice x and no z are three coordinates, but none in space.
  EXPECT_TRUE(
      contains(message(folder, "a.ply",
                       "ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\nproperty float x\nproperty float y\n"
                       "end_header\n0 0 0\n"),
               "need the properties x, y and z"));
  EXPECT_TRUE(contains(message(folder, "a.ply", "ply\nformat ascii 1.0\nelement vertex 3\n"), "end_header"));
  EXPECT_TRUE(contains(message(folder, "a.ply", "ply\nformat ebcdic 1.0\n"), "line 2"));
  EXPECT_TRUE(contains(message(folder, "a.ply", "OFF\n"), "starts with the line 'ply'"));
}

std::string stl_text(const OriginalShape<3>& shape) {
  std::string text = "solid thing é\r\n";
  for (const auto& p : shape.polygons)
    for (std::size_t k = 1; k + 1 < p.size(); ++k) {
      text += "  FACET normal 0 nan 1\r\n outer loop\r\n";
      for (const Index v : {p[0], p[k], p[k + 1]}) {
        const Vec<3>& x = shape.vertices[v];
        text += fmt::format("  vertex {} {} {}\r\n", x.x(), x.y() == 0 && k == 1 ? -0.0 : x.y(), x.z());
      }
      text += "endloop\r\nendfacet\r\n";
    }
  return text + "endsolid thing é\r\n";
}

TEST(MeshFiles, StlIsWeldedAndItsSizeChecked) {
  const TempFolder folder;
  const std::string text = stl_text(cube());
  const Shape<3> shape = read_mesh(folder.write("a.STL", text));
  EXPECT_EQ(shape.surface.vertices.size(), 8u);
  EXPECT_EQ(shape.original.vertices.size(), 8u);
  EXPECT_NEAR(volume(shape.surface), 1, 1e-15);
  EXPECT_FALSE(has_note(shape, "read as one shape"));
  EXPECT_TRUE(has_note(read_mesh(folder.write("two.stl", text + text)), "2 solids read as one shape"));
  EXPECT_TRUE(contains(message(folder, "a.stl", text.substr(0, text.rfind("endsolid"))), "cut off"));
  EXPECT_TRUE(contains(message(folder, "a.stl", text.substr(0, text.size() / 2)), "line"));
  const std::string of_empty = message(folder, "a.stl", "solid a\nendsolid a\n");
  EXPECT_TRUE(contains(of_empty, "no faces") && !contains(of_empty, "precision")) << of_empty;
  // Binary files may start with 'solid'.
  std::string binary = "solid" + std::string(75, ' ') + bytes_of(std::uint32_t{12}, false);
  const OriginalShape<3> box = cube();
  for (const auto& p : box.polygons)
    for (std::size_t k = 1; k < 3; ++k) {
      binary += std::string(12, '\0');
      for (const Index v : {p[0], p[k], p[k + 1]})
        for (int c = 0; c < 3; ++c) binary += bytes_of(static_cast<float>(box.vertices[v][c]), false);
      binary += "ab";
    }
  EXPECT_NEAR(volume(read_mesh(folder.write("b.stl", binary)).surface), 1, 1e-15);
  EXPECT_TRUE(contains(message(folder, "b.stl", binary.substr(0, binary.size() - 1)), "declares 12 triangles"));
  EXPECT_TRUE(has_note(read_mesh(folder.write("b.stl", binary + "xyz")), "3 bytes after the last triangle"));
  std::string bad = binary;
  const std::string nan = bytes_of(std::nanf(""), false);
  std::copy(nan.begin(), nan.end(), bad.begin() + 84 + 50 * 7 + 12);
  EXPECT_TRUE(contains(message(folder, "b.stl", bad), "triangle 7"));
}

TEST(MeshFiles, WhatIsNoFile) {
  const TempFolder folder;
  std::filesystem::create_directory(folder.path("folder.ply"));
  EXPECT_TRUE(contains(input_error_of([&] { read_mesh(folder.path("none.ply")); }), "no such file"));
  EXPECT_TRUE(contains(input_error_of([&] { read_mesh(folder.path("none.ply/x.ply")); }), "no such file"));
  EXPECT_TRUE(contains(input_error_of([&] { read_mesh(folder.path("folder.ply")); }), "is a folder"));
  EXPECT_TRUE(contains(message(folder, "a.ply", ""), "empty"));
  EXPECT_TRUE(contains(message(folder, "a.blend", "x"), ".obj .off .ply .stl"));
  EXPECT_TRUE(contains(message(folder, "noending", "x"), "no ending"));
  EXPECT_TRUE(contains(message(folder, "a.csv", "1,2\n"), "shape of the plane"));
  EXPECT_TRUE(contains(input_error_of([&] { read_outline(folder.write("a.obj", "v 1 2 3\n")); }), "shape of space"));
}

TEST(MeshFiles, ThingsToMoveNeedNotBeClosed) {
  const TempFolder folder;
  EXPECT_EQ(read_points_or_mesh_3d(folder.write("a.obj", cube_vertices)).vertices.size(), 8u);
  const OriginalShape<3> table = read_points_or_mesh_3d(folder.write("a.csv", "name,z,y,x\n1,2,3,4\n5,6,7,8\n"));
  EXPECT_EQ(table.vertices[1], Vec<3>(8, 7, 6));
  ASSERT_EQ(table.attributes.size(), 1u);
  EXPECT_EQ(table.attributes[0].values[1], 5);
  EXPECT_EQ(read_points_or_mesh_3d(folder.write("a.xyz", "# c\n1 2 3\n4\t5\t6\n")).vertices[1], Vec<3>(4, 5, 6));
  EXPECT_TRUE(
      contains(input_error_of([&] { read_points_or_mesh_3d(folder.write("b.txt", "1 2\n")); }), "line 1: 2 columns"));
  EXPECT_EQ(read_points_or_outline_2d(folder.write("c.txt", "0 0\n1 0\n0 0\n")).vertices.size(), 3u);
}

}  // namespace
}  // namespace shellmatch::testing
