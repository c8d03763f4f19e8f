// Frames of coordinates as 3D Slicer names them in comments of meshes.

#include "geometry/mesh_text/read_mesh_formats.h"
#include "geometry/surface/space.h"

#include <gtest/gtest.h>

namespace shellmatch {
namespace {

TEST(Space, IsNamedInAComment) {
  EXPECT_EQ(space_in_comment("# SPACE=LPS"), Space::lps);
  EXPECT_EQ(space_in_comment("3D Slicer output. SPACE=RAS"), Space::ras);
  EXPECT_EQ(space_in_comment("SPACE=LPS"), Space::lps);
  EXPECT_EQ(space_in_comment("WORKSPACE=LPS SPACE=RAS"), Space::ras);
  for (const char* text : {"", "SPACE", "SPACE=IJK", "MYSPACE=LPS", "SPACE=LP"})
    EXPECT_EQ(space_in_comment(text), Space::unsaid) << text;
}

TEST(Space, ConversionTurnsXAndYAndIsItsOwnInverse) {
  const Vec<3> x(1, 2, 3);
  EXPECT_EQ(in_space(x, Space::lps, Space::ras), Vec<3>(-1, -2, 3));
  EXPECT_EQ(in_space(in_space(x, Space::ras, Space::lps), Space::lps, Space::ras), x);
  EXPECT_EQ(in_space(x, Space::unsaid, Space::ras), x);
  EXPECT_EQ(in_space(x, Space::lps, Space::unsaid), x);
  std::vector<Vec<3>> points{x};
  EXPECT_FALSE(change_space(points, Space::ras, Space::ras));
  EXPECT_TRUE(change_space(points, Space::ras, Space::lps));
  EXPECT_EQ(points[0], Vec<3>(-1, -2, 3));
}

TEST(Space, IsFoundAtTheHeadOfMeshes) {
  EXPECT_EQ(space_of_mesh("# 3D Slicer\n# SPACE=LPS\nv 0 0 0\n"), Space::lps);
  EXPECT_EQ(space_of_mesh("OFF\n# SPACE=LPS\n1 0 0\n"), Space::lps);
  EXPECT_EQ(
      space_of_mesh("ply\r\nformat ascii 1.0\r\ncomment a\r\ncomment 3D Slicer; SPACE=RAS\r\nelement vertex 0\r\n"),
      Space::ras);
  EXPECT_EQ(space_of_mesh("solid SPACE=LPS\nfacet\n"), Space::lps);
  EXPECT_EQ(space_of_mesh("3D Slicer output. SPACE=LPS" + std::string(60, '\0')), Space::lps);
  // What stands in the data is no comment.
  EXPECT_EQ(space_of_mesh("v 0 0 0\n# SPACE=LPS\nv 0 0 0\n"), Space::lps);
  EXPECT_EQ(space_of_mesh("v 0 0 0\nv 0 0 1\n# SPACE=LPS\n"), Space::unsaid);
  EXPECT_EQ(space_of_mesh(std::string(80, ' ') + "SPACE=LPS"), Space::unsaid);
}

}  // namespace
}  // namespace shellmatch
