// What goes through `apply` comes out as it went in, but for positions; frames of coordinates are kept apart.

#include "geometry/io/read_shape.h"
#include "geometry/io/write_shape.h"
#include "matching/pairs/slicer_points.h"
#include "tests/apps/cli_harness.h"
#include "tests/matching/output/temporary_folder.h"

#include <fmt/core.h>
#include <gtest/gtest.h>

namespace shellmatch {
namespace {

using testing::contents_of;
using testing::put;
using testing::TemporaryFolder;

/// A small matching whose shapes name this frame, or none.
struct CarriedFiles : ::testing::Test {
  TemporaryFolder tmp;

  void match(Space space) {
    for (const auto& [shape, file] :
         {std::pair{"generate:ellipsoid/long", "a.ply"}, std::pair{"generate:sphere", "b.ply"}}) {
      ASSERT_EQ(run_program({"generate", std::string(shape).substr(9), "-o", tmp / "plain.ply", "--force",
                             "--edge-length", "0.05"})
                    .exit_code,
                0);
      OriginalShape<3> s = read_points_or_mesh_3d(tmp / "plain.ply");
      s.space = space;
      write_ply(tmp / file, s);
    }
    const ProgramResult result = run_program({"match", tmp / "a.ply", tmp / "b.ply", "-o", tmp / "out", "--levels",
                                              "3:4", "--align", "none", "--set", "pictures=none", "-q"});
    ASSERT_EQ(result.exit_code, 0) << result.err;
  }
  std::string apply(const std::string& from, const std::string& to) {
    const ProgramResult result = run_program({"apply", tmp / "out", tmp / from, "-o", tmp / to, "--force"});
    EXPECT_EQ(result.exit_code, 0) << result.err;
    return result.err;
  }
  Vec<3> moved_point(const std::string& file) { return read_slicer_points(tmp / file).points.at(0).position; }
};

TEST_F(CarriedFiles, PointsKeepTheirFrame) {
  match(Space::unsaid);
  put(tmp / "p.csv", "x,y,z\n0.3,0.6,0.7\n");
  apply("p.csv", "q.csv");
  const Vec<3> y = read_points_or_mesh_3d(tmp / "q.csv").vertices[0];
  EXPECT_GT((y - Vec<3>(0.3, 0.6, 0.7)).norm(), 1e-3);
  put(tmp / "ras.fcsv", "# CoordinateSystem = 0\n# columns = label,x,y,z\na,0.3,0.6,0.7\n");
  EXPECT_TRUE(has(apply("ras.fcsv", "ras_moved.fcsv"), "names no frame; taken to be RAS, in which"));
  EXPECT_EQ(moved_point("ras_moved.fcsv"), y);
  // The same point in the other frame.
  put(tmp / "lps.fcsv", "# CoordinateSystem = 1\n# columns = label,x,y,z\na,-0.3,-0.6,0.7\n");
  EXPECT_TRUE(has(apply("lps.fcsv", "lps_moved.fcsv"), "1 point from LPS to RAS"));
  EXPECT_EQ(moved_point("lps_moved.fcsv"), Vec<3>(-y.x(), -y.y(), y.z()));
  put(tmp / "p.mrk.json",
      "{\"markups\": [{\"coordinateSystem\": \"LPS\", \"controlPoints\": [{\"label\": \"a\", \"position\": [-0.3, "
      "-0.6, 0.7]}]}]}");
  apply("p.mrk.json", "q.mrk.json");
  EXPECT_EQ(moved_point("q.mrk.json"), Vec<3>(-y.x(), -y.y(), y.z()));
  // Points that lie on the shapes as they are: of meshes as Slicer takes them.
  put(tmp / "as_they_are.fcsv", "# CoordinateSystem = LPS\n# columns = label,x,y,z\na,0.3,0.6,0.7\n");
  EXPECT_TRUE(has(apply("as_they_are.fcsv", "lps_moved.fcsv"), "taken to be LPS, in which"));
  EXPECT_EQ(moved_point("lps_moved.fcsv"), y);
  put(tmp / "inside.fcsv", "# CoordinateSystem = LPS\n# columns = label,x,y,z\na,0.5,0.5,0.5\n");
  EXPECT_TRUE(has(apply("inside.fcsv", "inside_moved.fcsv"), "taken to be LPS, as 3D Slicer does"));
  const ProgramResult back =
      run_program({"apply", tmp / "out", tmp / "lps_moved.fcsv", "-o", tmp / "back.fcsv", "--inverse"});
  EXPECT_TRUE(has(back.err, "taken to be LPS, in which")) << back.err;
  EXPECT_LT((moved_point("back.fcsv") - Vec<3>(0.3, 0.6, 0.7)).norm(), 1e-6);
}

TEST_F(CarriedFiles, PointsGoOutInTheFormatOfTheName) {
  match(Space::lps);
  put(tmp / "p.csv", "label,x,y,z,weight\nnose,0.3,0.6,0.7,2\n\"chin, left\",0.5,0.5,0.2,1\n");
  apply("p.csv", "q.csv");
  const std::vector<Vec<3>> moved = read_points_or_mesh_3d(tmp / "q.csv").vertices;
  for (const char* name : {"q.fcsv", "q.mrk.json"}) {
    apply("p.csv", name);
    const SlicerPoints file = read_slicer_points(tmp / name);
    ASSERT_EQ(file.points.size(), 2u);
    EXPECT_EQ(file.points[1].name, "chin, left");
    EXPECT_EQ(file.points[1].position, moved[1]);
    EXPECT_EQ(file.points[1].space, Space::lps);
  }
  EXPECT_TRUE(has(apply("p.csv", "q.tps"), "without the names of points"));
  put(tmp / "n.csv", "x,y,z\n0.3,0.6,0.7\n");
  EXPECT_FALSE(has(apply("n.csv", "n.tps"), "names of points")) << "it has none";
  EXPECT_EQ(contents_of(tmp / "q.tps"),
            fmt::format("LM3=2\n{} {} {}\n{} {} {}\nID=q\nCOMMENT=SPACE=LPS\n", moved[0].x(), moved[0].y(),
                        moved[0].z(), moved[1].x(), moved[1].y(), moved[1].z()));
  apply("p.csv", "q.txt");
  EXPECT_TRUE(has(contents_of(tmp / "q.txt"),
                  "[dimensions]\n3\n[names]\nq\n[labels]\nSPACE\n[labelvalues]\nLPS\n[rawpoints]\n'q\n"));
  // Slicer's points in the other of its formats keep their frame and what is missing, in others they are in that of the
  // map.
  put(tmp / "r.fcsv",
      "# CoordinateSystem = RAS\n# columns = label,x,y,z,positionStatus\nnose,-0.3,-0.6,0.7,2\nchin,0,0,0,3\n");
  EXPECT_TRUE(has(apply("r.fcsv", "r.mrk.json"), "they are written in their own frame"));
  const SlicerPoints file = read_slicer_points(tmp / "r.mrk.json");
  EXPECT_EQ(file.points[0].space, Space::ras);
  EXPECT_EQ(file.points[0].position, Vec<3>(-moved[0].x(), -moved[0].y(), moved[0].z()));
  EXPECT_FALSE(file.points[1].has_position);
  EXPECT_TRUE(has(apply("r.fcsv", "r.csv"), "1 point without position left out"));
  EXPECT_EQ(contents_of(tmp / "r.csv"),
            fmt::format("name,x,y,z\nnose,{},{},{}\n", moved[0].x(), moved[0].y(), moved[0].z()));
  EXPECT_TRUE(has(apply("r.fcsv", "r.ply"), "without the names of points"));
  EXPECT_EQ(read_points_or_mesh_3d(tmp / "r.ply").space, Space::lps);
  apply("r.fcsv", "r.tps");
  EXPECT_TRUE(has(contents_of(tmp / "r.tps"), "\nNA NA NA\nID=r\n"));
}

TEST_F(CarriedFiles, MapsAreInTheFrameOfTheirShapes) {
  match(Space::lps);
  EXPECT_EQ(read_points_or_mesh_3d(tmp / "out/deformed.ply").space, Space::lps);
  put(tmp / "p.csv", "x,y,z\n0.3,0.6,0.7\n");  // names none: that of the map
  apply("p.csv", "q.csv");
  const Vec<3> y = read_points_or_mesh_3d(tmp / "q.csv").vertices[0];
  put(tmp / "lps.fcsv", "# CoordinateSystem = LPS\n# columns = label,x,y,z\na,0.3,0.6,0.7\n");
  EXPECT_EQ(apply("lps.fcsv", "lps_moved.fcsv"), "");
  EXPECT_EQ(moved_point("lps_moved.fcsv"), y);
  put(tmp / "ras.obj", "# SPACE=RAS\nv -0.3 -0.6 0.7\n");
  EXPECT_TRUE(has(apply("ras.obj", "ras_moved.ply"), "from RAS to LPS"));
  const OriginalShape<3> ras = read_points_or_mesh_3d(tmp / "ras_moved.ply");
  EXPECT_EQ(ras.space, Space::ras);
  EXPECT_EQ(ras.vertices[0], Vec<3>(-y.x(), -y.y(), y.z()));
}

TEST_F(CarriedFiles, ShapesOfTwoFramesAreBroughtIntoThatOfTheTemplate) {
  match(Space::lps);
  const auto same = read_points_or_mesh_3d(tmp / "out/deformed.ply").vertices;
  OriginalShape<3> reference = read_points_or_mesh_3d(tmp / "a.ply");
  change_space(reference.vertices, Space::lps, Space::ras);
  reference.space = Space::ras;
  write_ply(tmp / "a_ras.ply", reference);
  const ProgramResult result = run_program({"match", tmp / "a_ras.ply", tmp / "b.ply", "-o", tmp / "other", "--levels",
                                            "3:4", "--align", "none", "--set", "pictures=none"});
  ASSERT_EQ(result.exit_code, 0) << result.err;
  EXPECT_TRUE(has(result.err, "from RAS to LPS, the frame of")) << result.err;
  EXPECT_EQ(read_points_or_mesh_3d(tmp / "other/deformed.ply").vertices, same);
}

TEST_F(CarriedFiles, WhatAFileHoldsGoesOutInItsFormat) {
  match(Space::unsaid);
  put(tmp / "a.obj",
      "# mine\nmtllib m.mtl\nv 0.3 0.6 0.7\nv 0.4 0.6 0.7\nv 0.3 0.5 0.7\nvt 0 0\nvn 0 0 1\ng part\nusemtl skin\nf "
      "1/1/1 2/1/1 3/1/1\n");
  EXPECT_TRUE(has(apply("a.obj", "b.obj"), "vertex normals dropped"));
  const std::string text = contents_of(tmp / "b.obj");
  EXPECT_EQ(text.find("# mine\nmtllib m.mtl\nv "), 0u) << text;
  EXPECT_TRUE(has(text, "\nvt 0 0\ng part\nusemtl skin\nf 1/1 2/1 3/1\n")) << text;
  EXPECT_TRUE(
      has(apply("a.obj", "b.vtp"), "without texture coordinates, groups, materials, which this format does not hold"));
  EXPECT_EQ(read_points_or_mesh_3d(tmp / "b.vtp").vertices, read_points_or_mesh_3d(tmp / "b.obj").vertices);
  put(tmp / "p.csv", "name,x,y,z,weight\n\"left, upper\",0.3,0.6,0.7,2\n");
  EXPECT_EQ(apply("p.csv", "q.csv"), "");
  EXPECT_EQ(contents_of(tmp / "q.csv").find("name,x,y,z,weight\n\"left, upper\",0."), 0u) << contents_of(tmp / "q.csv");
  EXPECT_TRUE(has(apply("p.csv", "q.ply"), "without the columns name"));
}

TEST_F(CarriedFiles, AResultThatIsMatchedAgainHasItsColumnsOnce) {
  match(Space::unsaid);
  const auto names_of = [&](const std::string& file) {
    Words names;
    for (const VertexAttribute& a : read_points_or_mesh_3d(tmp / file).attributes) names.push_back(a.name);
    return names;
  };
  const Words names = names_of("out/deformed.ply");
  EXPECT_EQ(names, (Words{"distance_to_template", "area_ratio", "template_face", "template_v0", "template_v1",
                          "template_v2", "template_b0", "template_b1", "template_b2"}));
  const ProgramResult result =
      run_program({"match", tmp / "out/deformed.ply", tmp / "out/template.ply", "-o", tmp / "again", "--levels", "3:4",
                   "--align", "none", "--set", "pictures=none", "-q"});
  ASSERT_EQ(result.exit_code, 0) << result.err;
  EXPECT_EQ(names_of("again/deformed.ply"), names);
  EXPECT_EQ(names_of("again/template.ply"), Words{"distance_to_deformed"});
}

}  // namespace
}  // namespace shellmatch
