#include <gtest/gtest.h>

#include <fstream>
#include <random>

#include "tests/repository/include_rules.h"
#include "tests/repository/structure_rules.h"

// Every rule of the repository against planted faults, each beside a near miss that is allowed.

namespace shellmatch::repository {
namespace {

namespace fs = std::filesystem;

class Rules : public ::testing::Test {
 protected:
  void SetUp() override {
    root_ = fs::temp_directory_path() / ("shellmatch-rules-" + std::to_string(std::random_device{}()));
    fs::create_directories(root_);
  }
  void TearDown() override { fs::remove_all(root_); }

  void plant(const std::string& file, const std::string& text) {
    fs::create_directories((root_ / file).parent_path());
    std::ofstream(root_ / file) << text;
  }
  SourceTree tree() const { return read_tree(root_); }

 private:
  fs::path root_;
};

// Exactly one finding, in that file and line.
void expect_one(const std::vector<Finding>& findings, const std::string& file, int line) {
  ASSERT_EQ(findings.size(), 1u) << to_text(findings);
  EXPECT_EQ(findings[0].file, file);
  EXPECT_EQ(findings[0].line, line);
}

TEST_F(Rules, PatternsStayWithinAFolder) {
  EXPECT_TRUE(matches("geometry/cgal_read.cpp", "geometry/cgal_*.cpp"));
  EXPECT_TRUE(matches("grid/vtk_image.cpp", "*/vtk_*.cpp"));
  EXPECT_FALSE(matches("geometry/detail/cgal_read.cpp", "geometry/*.cpp"));
  EXPECT_FALSE(matches("geometry/cgal_read.h", "geometry/cgal_*.cpp"));
}

TEST_F(Rules, SiblingsDoNotIncludeEachOther) {
  plant("grid/octree/octree.h", "#include \"base/types.h\"\n");
  plant("base/types.h", "#include <vector>\n");
  plant("geometry/mesh.cpp", "#include \"base/types.h\"\n#include \"grid/octree/octree.h\"\n");
  expect_one(check_include_direction(tree()), "geometry/mesh.cpp", 2);
}

TEST_F(Rules, SolversDoNotSeeEnergies) {
  plant("energies/term.h", "");
  plant("matching/problem.cpp", "#include \"energies/term.h\"\n");
  plant("solvers/cg.cpp", "\n  #  include \"energies/term.h\"\n");
  expect_one(check_include_direction(tree()), "solvers/cg.cpp", 2);
}

TEST_F(Rules, BaseIncludesNothingAbove) {
  plant("matching/experiment/options.h", "");
  plant("base/error.cpp", "#include \"matching/experiment/options.h\"\n");
  expect_one(check_include_direction(tree()), "base/error.cpp", 1);
}

// Libraries within a folder have rules of their own.
TEST_F(Rules, RenderingDoesNotSeeMatching) {
  plant("matching/render/canvas/canvas.h", "");
  plant("matching/level.h", "#include \"matching/render/canvas/canvas.h\"\n");
  plant("matching/render/canvas/plot.cpp", "#include \"matching/level.h\"\n");
  expect_one(check_include_direction(tree()), "matching/render/canvas/plot.cpp", 1);
}

TEST_F(Rules, IncludesAreWrittenFromTheRoot) {
  plant("grid/octree/octree.h", "");
  plant("grid/octree/octree.cpp", "#include \"octree.h\"\n");
  expect_one(check_include_direction(tree()), "grid/octree/octree.cpp", 1);
}

TEST_F(Rules, IncludedFilesExist) {
  plant("grid/octree/octree.cpp", "#include \"grid/octree/octree.h\"\n");
  expect_one(check_include_direction(tree()), "grid/octree/octree.cpp", 1);
}

TEST_F(Rules, ALibraryIsIncludedByItsAdapterOnly) {
  plant("geometry/repair/cgal_read.cpp", "#include <CGAL/Surface_mesh.h>\n");
  plant("geometry/mesh.cpp", "#include <cmath>\n#include <CGAL/Surface_mesh.h>\n");
  expect_one(check_adapters(tree()), "geometry/mesh.cpp", 2);
}

TEST_F(Rules, HeadersOfAnAdapterStayWithinIt) {
  plant("geometry/repair/cgal_mesh.h", "#include <CGAL/Surface_mesh.h>\n");
  plant("geometry/repair/cgal_read.cpp", "#include \"geometry/repair/cgal_mesh.h\"\n");
  plant("geometry/mesh.h", "\n#include \"geometry/repair/cgal_mesh.h\"\n");
  expect_one(check_adapters(tree()), "geometry/mesh.h", 2);
}

TEST_F(Rules, EnergiesSeeOnlyTheDualNumbersOfCeres) {
  plant("energies/terms/check.cpp", "#include <ceres/jet.h>\n#include <ceres/ceres.h>\n");
  expect_one(check_adapters(tree()), "energies/terms/check.cpp", 2);
}

TEST_F(Rules, HeadersStayFreeOfLibraries) {
  plant("base/error.h", "#include <fmt/core.h>\n");
  plant("grid/field.cpp", "#include <fmt/core.h>\n#include <unistd.h>\n");
  plant("grid/field.h", "#include <Eigen/Core>\n#include <vector>\n#include <fmt/core.h>\n");
  expect_one(check_adapters(tree()), "grid/field.h", 3);
}

TEST_F(Rules, AnUnknownLibraryIsFound) {
  plant("grid/field.cpp", "#include <wonder/all.hpp>\n");
  expect_one(check_adapters(tree()), "grid/field.cpp", 1);
}

TEST_F(Rules, LongFilesAreFound) {
  std::string lines;
  for (int i = 0; i < 400; ++i) lines += "//\n";
  plant("grid/just.cpp", lines);
  plant("docs/long.md", lines + lines);
  plant("grid/long.cpp", lines + "//\n");
  expect_one(check_lengths(tree()), "grid/long.cpp", 401);
}

// a includes b in its source, b includes c, and c's header leads back to a; d only looks at them.
TEST_F(Rules, CyclesOfFilesAreFound) {
  plant("grid/octree/a.h", "");
  plant("grid/octree/a.cpp", "#include \"grid/octree/a.h\"\n#include \"grid/fields/b.h\"\n");
  plant("grid/fields/b.h", "#include \"base/c.h\"\n");
  plant("base/c.h", "");
  plant("grid/octree/d.cpp", "#include \"grid/octree/a.h\"\n#include \"grid/fields/b.h\"\n");
  EXPECT_TRUE(check_unit_cycles(tree()).empty()) << to_text(check_unit_cycles(tree()));
  plant("base/c.h", "\n#include \"grid/octree/a.h\"\n");
  expect_one(check_unit_cycles(tree()), "base/c.h", 2);
}

TEST_F(Rules, TwoCyclesAreTwoFindings) {
  for (const std::string folder : {"base", "grid"}) {
    plant(folder + "/x.h", "#include \"" + folder + "/y.h\"\n");
    plant(folder + "/y.h", "#include \"" + folder + "/x.h\"\n");
  }
  const auto findings = check_unit_cycles(tree());
  ASSERT_EQ(findings.size(), 2u) << to_text(findings);
  EXPECT_EQ(findings[0].file, "base/x.h");
  EXPECT_EQ(findings[1].file, "grid/x.h");
}

TEST_F(Rules, CrowdedRoomsAreFound) {
  for (std::size_t i = 0; i < max_room_files; ++i) plant("grid/octree/f" + std::to_string(i) + ".cpp", "");
  plant("grid/octree/notes.md", "");
  plant("grid/octree/inner/g.cpp", "");
  EXPECT_TRUE(check_room_sizes(tree()).empty());
  plant("grid/octree/one_more.h", "");
  expect_one(check_room_sizes(tree()), "grid/octree", 0);
}

// Files without a cycle may still couple their rooms both ways. Top folders are check_include_direction's matter.
TEST_F(Rules, RoomsIncludeEachOtherOneWay) {
  plant("grid/octree/a.h", "#include \"base/types.h\"\n");
  plant("grid/fields/b.h", "#include \"grid/octree/a.h\"\n");
  plant("grid/fields/c.h", "");
  plant("grid/octree/test.h", "#include \"grid/octree/a.h\"\n");
  plant("tests/grid/octree/d.h", "#include \"tests/grid/fields/e.h\"\n");
  plant("tests/grid/fields/e.h", "");
  plant("tests/grid/fields/f.h", "#include \"tests/grid/octree/d.h\"\n");
  plant("base/types.h", "");
  EXPECT_TRUE(check_room_cycles(tree()).empty()) << to_text(check_room_cycles(tree()));
  plant("grid/octree/d.cpp", "#include \"grid/octree/a.h\"\n#include \"grid/fields/c.h\"\n");
  EXPECT_TRUE(check_unit_cycles(tree()).empty()) << to_text(check_unit_cycles(tree()));
  expect_one(check_room_cycles(tree()), "grid/fields/b.h", 1);
  EXPECT_TRUE(check_room_cycles(tree(), {"grid"}).empty());
}

// The files directly in a top folder are a room as well.
TEST_F(Rules, TheTopFolderIsARoom) {
  plant("solvers/solver_options.h", "#include \"solvers/libraries/options.h\"\n");
  plant("solvers/libraries/options.h", "");
  plant("solvers/objective.h", "");
  plant("solvers/libraries/run.h", "#include \"solvers/objective.h\"\n");
  expect_one(check_room_cycles(tree()), "solvers/solver_options.h", 1);
}

TEST_F(Rules, TestsMirrorTheFolders) {
  plant("grid/octree/octree.h", "");
  plant("tests/grid/octree/octree_test.cpp", "");
  plant("tests/grid/test_grids.h", "");
  plant("tests/support/deep/folders.h", "");
  EXPECT_TRUE(check_test_folders(tree()).empty()) << to_text(check_test_folders(tree()));
  plant("tests/grid/quadtree/octree_test.cpp", "");
  expect_one(check_test_folders(tree()), "tests/grid/quadtree", 0);
}

}  // namespace
}  // namespace shellmatch::repository
