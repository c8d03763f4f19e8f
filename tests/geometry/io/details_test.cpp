// What comes in goes out: of OBJ all statements, of PLY properties of faces, further elements and comments, of tables
// texts.

#include "geometry/io/read_shape.h"
#include "geometry/io/write_shape.h"
#include "geometry/surface/mesh_details.h"
#include "tests/geometry/io/files.h"

#include <fmt/ranges.h>
#include <gtest/gtest.h>

#include <fstream>
#include <sstream>

namespace shellmatch {
namespace {

using testing::contains;
using testing::TempFolder;

std::string contents(const std::string& path) {
  std::stringstream text;
  text << std::ifstream(path, std::ios::binary).rdbuf();
  return text.str();
}

/// The file after each x has been doubled, in the format of the other name.
std::string with_doubled_x(const TempFolder& folder, const std::string& from, const std::string& bytes,
                           const std::string& to) {
  OriginalShape<3> shape = read_points_or_mesh_3d(folder.write(from, bytes));
  for (Vec<3>& x : shape.vertices) x.x() *= 2;
  write_shape(folder.path(to), shape);
  return contents(folder.path(to));
}

TEST(Details, ObjKeepsItsLinesAndTheirOrder) {
  const TempFolder folder;
  const std::string text =
      "# made by hand\nmtllib a.mtl\n\no body\nv 1 0 0 0.1 0.2 0.3 # red\nv 0.5\t1 0\nvt 0 0\nvt 1 0.5\nv 0 0 1\ng "
      "left right\nusemtl skin\ns off\n"
      "f 1/1 2/2 3/1\nf 1 2 3 # back\nf 1 2 \\\n3\nl 1 2\nf 1 2\nv 3 3 3 1\n";
  const std::string expected =
      "# made by hand\nmtllib a.mtl\n\no body\nv 2 0 0 0.1 0.2 0.3\nv 1 1 0\nvt 0 0\nvt 1 0.5\nv 0 0 1\ng left "
      "right\nusemtl skin\ns off\n"
      "f 1/1 2/2 3/1\nf 1 2 3 # back\nf 1 2  3\nl 1 2\nf 1 2\nv 6 3 3 1\n";
  EXPECT_EQ(with_doubled_x(folder, "a.obj", text, "b.obj"), expected);
}

TEST(Details, ObjLosesNormalsAndNothingElse) {
  const TempFolder folder;
  const std::string text =
      "# SPACE=LPS\nv 1 0 0\r\nv 0 1 0\r\nv 0 0 1\r\nvn 0 0 1\r\nvt 0 0\r\nusemtl a\\\nv 9 9 9\nf 1//1 2//1 3//1\r\nf "
      "1/1/1 2/1/1 3/1/1\r\n";
  EXPECT_EQ(with_doubled_x(folder, "a.obj", text, "b.obj"),
            "# SPACE=LPS\nv 2 0 0\nv 0 1 0\nv 0 0 1\nvt 0 0\nusemtl a v 9 9 9\nf 1 2 3\nf 1/1 2/1 3/1\n");
  std::vector<std::string> notes;
  read_points_or_mesh_3d(folder.path("a.obj"), &notes);
  ASSERT_EQ(notes.size(), 1u);
  EXPECT_TRUE(contains(notes[0], "vertex normals dropped"));
}

TEST(Details, PlyKeepsPropertiesOfFacesElementsAndComments) {
  const TempFolder folder;
  const std::string text =
      "ply\nformat ascii 1.0\ncomment TextureFile a.png\nobj_info scanned\ncomment SPACE=RAS\nelement vertex "
      "4\nproperty float x\nproperty float y\nproperty float z\n"
      "property short label\nelement face 3\nproperty uchar flags\nproperty list uchar int vertex_indices\nproperty "
      "list uchar float texcoord\n"
      "element edge 2\nproperty int vertex1\nproperty int vertex2\nproperty list int short more\nend_header\n"
      "1 0 0 -7\n0 1 0 8\n0 0 1 9\n0 0 0 10\n5 3 0 1 2 2 0.5 0.25\n6 2 0 1 1 0.125\n7 4 0 1 2 3 0\n0 1 0\n2 3 2 -1 "
      "-2\n";
  with_doubled_x(folder, "a.ply", text, "b.ply");
  with_doubled_x(folder, "c.ply", contents(folder.path("b.ply")), "d.ply");
  std::vector<std::string> notes;
  const OriginalShape<3> shape = read_points_or_mesh_3d(folder.path("d.ply"), &notes);
  EXPECT_TRUE(notes.empty());  // the face with two corners went the first time
  EXPECT_EQ(shape.vertices[0], Vec<3>(4, 0, 0));
  EXPECT_EQ(shape.space, Space::ras);
  EXPECT_EQ(shape.polygons, (std::vector<std::vector<Index>>{{0, 1, 2}, {0, 1, 2, 3}}));
  EXPECT_EQ(shape.attributes.at(0).type, "short");
  const MeshDetails& d = *shape.details;
  EXPECT_EQ(d.ply_comments, (std::vector<std::string>{"comment TextureFile a.png", "obj_info scanned"}));
  ASSERT_EQ(d.ply_faces.size(), 2u);
  EXPECT_EQ(d.ply_faces[0].name, "flags");
  EXPECT_EQ(d.ply_faces[0].type, "uchar");
  EXPECT_EQ(d.ply_faces[0].values, (std::vector<double>{5, 7}));
  EXPECT_EQ(d.ply_faces[1].count_type, "uchar");
  EXPECT_EQ(d.ply_faces[1].values, (std::vector<double>{0.5, 0.25}));
  EXPECT_EQ(d.ply_faces[1].ends, (std::vector<std::size_t>{2, 2}));
  ASSERT_EQ(d.ply_elements.size(), 1u);
  EXPECT_EQ(d.ply_elements[0].name, "edge");
  EXPECT_EQ(d.ply_elements[0].columns.at(1).values, (std::vector<double>{1, 3}));
  EXPECT_EQ(d.ply_elements[0].columns.at(2).values, (std::vector<double>{-1, -2}));
  EXPECT_EQ(d.ply_elements[0].columns.at(2).ends, (std::vector<std::size_t>{0, 2}));
}

TEST(Details, TablesKeepNames) {
  const TempFolder folder;
  EXPECT_EQ(
      with_doubled_x(folder, "a.csv",
                     "name,x,y,z,weight\nnose tip,1,2,3,0.5\n\"ear, \"\"left\"\"\",4,5,6,1\n7,7,8,9,2\n", "b.csv"),
      "name,x,y,z,weight\nnose tip,2,2,3,0.5\n\"ear, \"\"left\"\"\",8,5,6,1\n7,14,8,9,2\n");
  EXPECT_EQ(with_doubled_x(folder, "c.csv", "label x y z\na 1 2 3\n", "d.csv"), "label,x,y,z\na,2,2,3\n");
  EXPECT_TRUE(
      contains(testing::input_error_of([&] { with_doubled_x(folder, "e.csv", "name,x,y,z\na,1,2,three\n", "f.csv"); }),
               "'three'"));
}

TEST(Details, WhatAFormatCannotHoldIsSaid) {
  const TempFolder folder;
  const auto lost = [&](const std::string& name, const std::string& text, const std::string& to) {
    return fmt::format("{}", fmt::join(left_out(to, read_points_or_mesh_3d(folder.write(name, text))), "; "));
  };
  const std::string obj = "o a\nv 0 0 0 1 0 0\nv 1 0 0 1 0 0\nv 0 1 0 1 0 0\nvt 0 0\nusemtl b\nf 1/1 2/1 3/1\n";
  EXPECT_EQ(lost("a.obj", obj, "b.obj"), "");
  EXPECT_EQ(lost("a.obj", obj, "b.ply"), "texture coordinates; objects; materials");
  EXPECT_EQ(lost("a.csv", "name,x,y,z,w\na,1,2,3,4\n", "b.csv"), "");
  EXPECT_EQ(lost("a.csv", "name,x,y,z,w\na,1,2,3,4\n", "b.vtp"), "the columns name");
  EXPECT_EQ(lost("a.csv", "name,x,y,z,w\na,1,2,3,4\n", "b.off"), "the columns name, w");
  const std::string ply =
      "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\nelement face 1\n"
      "property list uchar int vertex_indices\nproperty int part\nelement edge 1\nproperty int a\nend_header\n0 0 0\n1 "
      "0 0\n0 1 0\n3 0 1 2 5\n1\n";
  EXPECT_EQ(lost("a.ply", ply, "b.ply"), "");
  EXPECT_EQ(lost("a.ply", ply, "b.csv"), "faces; the property part of the faces; the elements edge");
}

}  // namespace
}  // namespace shellmatch
