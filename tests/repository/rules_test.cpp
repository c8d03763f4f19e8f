#include <gtest/gtest.h>

#include <fstream>
#include <random>

#include "tests/repository/include_rules.h"
#include "tests/repository/mutation_rules.h"
#include "tests/repository/text_rules.h"

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
  EXPECT_TRUE(matches("render/vtk_image.cpp", "*/vtk_*.cpp"));
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

TEST_F(Rules, IncludesAreWrittenFromTheRoot) {
  plant("grid/octree/octree.h", "");
  plant("grid/octree/octree.cpp", "#include \"octree.h\"\n");
  expect_one(check_include_direction(tree()), "grid/octree/octree.cpp", 1);
}

TEST_F(Rules, IncludedFilesExist) {
  plant("grid/octree/octree.cpp", "#include \"grid/octree/octree.h\"\n");
  expect_one(check_include_direction(tree()), "grid/octree/octree.cpp", 1);
}

TEST_F(Rules, ALibraryStaysBehindItsDoor) {
  plant("geometry/repair/cgal_read.cpp", "#include <CGAL/Surface_mesh.h>\n");
  plant("geometry/mesh.cpp", "#include <cmath>\n#include <CGAL/Surface_mesh.h>\n");
  expect_one(check_doors(tree()), "geometry/mesh.cpp", 2);
}

TEST_F(Rules, HeadersOfADoorStayBehindIt) {
  plant("geometry/repair/cgal_mesh.h", "#include <CGAL/Surface_mesh.h>\n");
  plant("geometry/repair/cgal_read.cpp", "#include \"geometry/repair/cgal_mesh.h\"\n");
  plant("geometry/mesh.h", "\n#include \"geometry/repair/cgal_mesh.h\"\n");
  expect_one(check_doors(tree()), "geometry/mesh.h", 2);
}

TEST_F(Rules, EnergiesSeeOnlyTheDualNumbersOfCeres) {
  plant("energies/terms/check.cpp", "#include <ceres/jet.h>\n#include <ceres/ceres.h>\n");
  expect_one(check_doors(tree()), "energies/terms/check.cpp", 2);
}

TEST_F(Rules, HeadersStayFreeOfLibraries) {
  plant("base/error.h", "#include <fmt/core.h>\n");
  plant("grid/field.cpp", "#include <fmt/core.h>\n#include <unistd.h>\n");
  plant("grid/field.h", "#include <Eigen/Core>\n#include <vector>\n#include <fmt/core.h>\n");
  expect_one(check_doors(tree()), "grid/field.h", 3);
}

TEST_F(Rules, AnUnknownLibraryIsFound) {
  plant("grid/field.cpp", "#include <wonder/all.hpp>\n");
  expect_one(check_doors(tree()), "grid/field.cpp", 1);
}

TEST_F(Rules, LongFilesAreFound) {
  std::string lines;
  for (int i = 0; i < 400; ++i) lines += "//\n";
  plant("grid/just.cpp", lines);
  plant("docs/long.md", lines + lines);
  plant("grid/long.cpp", lines + "//\n");
  expect_one(check_lengths(tree()), "grid/long.cpp", 401);
}

TEST_F(Rules, PathsOfOneMachineAreFound) {
  plant("docs/near.md",
        "see docs/ho"
        "me/page, ${root}/t"
        "mp/x and /usr/share/doc\n");
  plant("scripts/run",
        "#!/bin/sh\ncd /ho"
        "me/somebody\n");
  expect_one(check_machine_paths(tree()), "scripts/run", 2);
}

TEST_F(Rules, BuildFoldersAreNotLookedAt) {
  plant("build/release/cache.cmake",
        "/ho"
        "me/somebody\n");
  plant("build-x/cache.cmake",
        "/ho"
        "me/somebody\n");
  EXPECT_TRUE(tree().files.empty());
}

TEST_F(Rules, DeadLinksAreFound) {
  plant("docs/theory.md", "# Theory\n\n## The band\n");
  plant("README.md",
        "[theory](docs/theory.md) [band](docs/theory.md#the-band) [site](https://example.com/x)\n"
        "```\n[in code](nowhere.md)\n```\n"
        "[gone](docs/gone.md)\n");
  expect_one(check_links(tree()), "README.md", 5);
}

TEST_F(Rules, DeadHeadingsAreFound) {
  plant("docs/theory.md", "# Theory\n[up](#theory) [down](#practice)\n");
  expect_one(check_links(tree()), "docs/theory.md", 2);
}

TEST_F(Rules, FilesNamedInDocumentsExist) {
  plant("grid/octree/octree.cpp", "");
  plant("docs/theory.md",
        "`grid/octree/octree.cpp`, `grid/oct*.cpp` and `out/deformed.ply`\n\n`grid/quadtree.cpp`\n");
  expect_one(check_links(tree()), "docs/theory.md", 3);
}

TEST_F(Rules, AForgottenDependencyIsFound) {
  plant("cmake/Dependencies.cmake",
        "find_package(Eigen3 3.4 REQUIRED)\nfind_package(NLopt REQUIRED)\nfind_package(GTest)\n");
  plant("cmake/ShellmatchConfig.cmake.in", "find_dependency(Eigen3 3.4)\n");
  expect_one(check_dependencies(tree()), "cmake/ShellmatchConfig.cmake.in", 0);
}

// One entry of two lines is right; the file has the second text twice and the third not at all.
TEST_F(Rules, ErrorsThatCannotBeMadeAreFound) {
  plant("tests/grid/CMakeLists.txt", "shellmatch_test(grid_octree SOURCES octree_test.cpp)\n");
  plant("grid/octree/octree.cpp", "int a = 1;\n  int b = 2;\nint c = 2;\n");
  const std::string good = "# a comment\ngrid/octree.cpp: grid_octree/Octree*\n- a = 1;\n-   int b\n+ a = 2;\n~ why\n\n";
  const auto findings_for = [&](const std::string& text) {
    plant("tests/mutations.txt", good + text);
    return check_mutations(tree());
  };
  EXPECT_TRUE(findings_for("").empty());
  expect_one(findings_for("- = 2;\n+ = 3;\n"), "tests/mutations.txt", 8);
  expect_one(findings_for("- d = 1;\n+\n\n"), "tests/mutations.txt", 8);
  expect_one(findings_for("\n+ int d;\n"), "tests/mutations.txt", 9);
  expect_one(findings_for("- int a\n+ int a\n"), "tests/mutations.txt", 8);
  expect_one(findings_for("grid/quadtree.cpp: grid_octree\n- b\n+ c\n"), "tests/mutations.txt", 8);
  expect_one(findings_for("grid/octree/octree.cpp: octree\n- b\n+ d\n"), "tests/mutations.txt", 8);
  expect_one(findings_for("grid/octree/octree.cpp:\n- b\n+ d\n"), "tests/mutations.txt", 8);
}

}  // namespace
}  // namespace shellmatch::repository
