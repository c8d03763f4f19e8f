// Specks of a labelled surface: which connected components are dropped, and what is left.
#include "geometry/label/surface_parts.h"

#include <gtest/gtest.h>

#include <array>

namespace shellmatch::testing {
namespace {

// Adds a tetrahedron of volume side^3 / 6 with outward normals, or inward ones: the wall of a cavity.
void add_tetrahedron(Surface<3>& surface, const Vec<3>& corner, double side, bool inward = false) {
  const auto first = static_cast<Index>(surface.vertices.size());
  surface.vertices.push_back(corner);
  for (int k = 0; k < 3; ++k) surface.vertices.push_back(corner + side * Vec<3>::Unit(k));
  for (const auto& [a, b, c] : {std::array{0, 2, 1}, std::array{0, 1, 3}, std::array{0, 3, 2}, std::array{1, 2, 3}})
    surface.facets.push_back(inward ? std::array<Index, 3>{first + c, first + b, first + a}
                                    : std::array<Index, 3>{first + a, first + b, first + c});
}

// Volumes 36, 4.5, 1/6 and, of a cavity far from the origin, -4/3.
Surface<3> four_parts() {
  Surface<3> surface;
  add_tetrahedron(surface, {9, 9, 9}, 1);
  add_tetrahedron(surface, {0, 0, 0}, 6);
  add_tetrahedron(surface, {20, -7, 3}, 2, true);
  add_tetrahedron(surface, {-30, 4, 8}, 3);
  return surface;
}

TEST(SurfaceParts, PartsBelowTheVolumeGoAndTheOthersKeepTheirFacets) {
  Surface<3> surface = four_parts();
  EXPECT_EQ(drop_small_parts(surface, 1.0), 1u);
  Surface<3> expected;
  add_tetrahedron(expected, {0, 0, 0}, 6);
  add_tetrahedron(expected, {20, -7, 3}, 2, true);
  add_tetrahedron(expected, {-30, 4, 8}, 3);
  EXPECT_EQ(surface.vertices, expected.vertices);
  EXPECT_EQ(surface.facets, expected.facets);
}

TEST(SurfaceParts, ACavityCountsByItsSize) {
  Surface<3> surface = four_parts();
  EXPECT_EQ(drop_small_parts(surface, 4.0), 2u);
  Surface<3> expected;
  add_tetrahedron(expected, {0, 0, 0}, 6);
  add_tetrahedron(expected, {-30, 4, 8}, 3);
  EXPECT_EQ(surface.facets, expected.facets);
  EXPECT_EQ(surface.vertices, expected.vertices);
}

TEST(SurfaceParts, TheLargestStaysWhateverTheLimit) {
  Surface<3> surface = four_parts();
  EXPECT_EQ(drop_small_parts(surface, 1e9), 3u);
  Surface<3> expected;
  add_tetrahedron(expected, {0, 0, 0}, 6);
  EXPECT_EQ(surface.vertices, expected.vertices);
}

TEST(SurfaceParts, NothingBelowTheLimitChangesNothing) {
  Surface<3> surface = four_parts(), none;
  const Surface<3> before = surface;
  EXPECT_EQ(drop_small_parts(surface, 0.1), 0u);
  EXPECT_EQ(surface.vertices, before.vertices);
  EXPECT_EQ(surface.facets, before.facets);
  EXPECT_EQ(drop_small_parts(none, 1.0), 0u);
}

}  // namespace
}  // namespace shellmatch::testing
