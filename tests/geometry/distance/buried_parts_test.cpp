// What of a surface lies inside the body that it encloses, on boxes and spheres that overlap.

#include "geometry/distance/buried_parts.h"

#include "geometry/surface/self_intersections.h"
#include "tests/geometry/surface/test_surfaces.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace shellmatch {
namespace {

using namespace test;

BuriedParts found_in(const Surface<3>& s) { return buried_parts(s, self_intersecting_facets(s)); }

Surface<3> moved(Surface<3> s, const Vec<3>& by) {
  for (Vec<3>& x : s.vertices) x += by;
  return s;
}

TEST(BuriedParts, NoneWhereNothingCrosses) {
  EXPECT_TRUE(found_in(unit_sphere(4)).facets.empty());
  // A cavity's surface lies inside another one, but winds the other way.
  const BuriedParts found =
      found_in(joined(box({0, 0, 0}, {1, 1, 1}), reversed(box({0.3, 0.3, 0.3}, {0.6, 0.6, 0.6}))));
  EXPECT_TRUE(found.facets.empty());
  EXPECT_EQ(found.share, 0);
}

TEST(BuriedParts, OfSpheresThatOverlapAreTheCapsOfBoth) {
  const Surface<3> left = unit_sphere(4), both = joined(left, moved(left, {1.6, 0, 0}));
  const BuriedParts found = found_in(both);
  // The circle in which they cross lies at x = 0.8; facets on it belong to the side of their centre.
  const auto centre_x = [&](Index f) {
    return (both.vertices[both.facets[f][0]] + both.vertices[both.facets[f][1]] + both.vertices[both.facets[f][2]])
               .x() /
           3;
  };
  for (Index f = 0; f < static_cast<Index>(both.facets.size()); ++f) {
    const bool is_cap = f < static_cast<Index>(left.facets.size()) ? centre_x(f) > 0.8 : centre_x(f) < 0.8;
    if (std::abs(centre_x(f) - 0.8) < 0.005) continue;
    EXPECT_EQ(std::ranges::binary_search(found.facets, f), is_cap) << f;
  }
  EXPECT_NEAR(found.share, 0.1, 0.005);                  // a cap of height 0.2 on each sphere
  EXPECT_NEAR(found.depth, std::hypot(0.2, 0.6), 0.03);  // from each apex to the circle
  std::size_t n_within = 0;                              // all facets around are buried
  for (const Vec<3>& x : left.vertices) n_within += x.x() > 0.9;
  EXPECT_GE(found.n_vertices, 2 * n_within);
  EXPECT_LE(found.n_vertices, 4 * n_within);
}

TEST(BuriedParts, AWholeComponentWithinAnother) {
  const Surface<3> two = joined(box({0, 0, 0}, {1, 1, 1}), box({0.9, 0.9, 0.9}, {1.1, 1.1, 1.1})),
                   small = box({0.3, 0.4, 0.4}, {0.6, 0.6, 0.6});
  const std::size_t before = found_in(two).facets.size();
  const BuriedParts found = found_in(joined(two, small));
  EXPECT_EQ(found.facets.size(), before + 12);
  EXPECT_EQ(found.facets.back(), 35);
  EXPECT_NEAR(found.depth, 0.4, 1e-12);
}

TEST(BuriedParts, WhereTheyTouch) {
  // Both sides of the wall between two boxes lie inside of what they enclose together.
  const BuriedParts found = found_in(joined(box({0, 0, 0}, {1, 1, 1}), box({1, 0, 0}, {2, 1, 1})));
  EXPECT_EQ(found.facets.size(), 4u);
  EXPECT_NEAR(found.share, 2.0 / 12, 1e-12);
}

/// A box with vertices at these heights.
Surface<3> column(double side, const std::vector<double>& heights) {
  Surface<3> s;
  for (const double z : heights)
    for (const Vec<2>& x : {Vec<2>(0, 0), Vec<2>(side, 0), Vec<2>(side, side), Vec<2>(0, side)})
      s.vertices.emplace_back(x.x(), x.y(), z);
  const auto at = [](std::size_t ring, int k) { return static_cast<Index>(4 * ring) + k % 4; };
  const std::size_t top = heights.size() - 1;
  s.facets = {{at(0, 0), at(0, 2), at(0, 1)},
              {at(0, 0), at(0, 3), at(0, 2)},
              {at(top, 0), at(top, 1), at(top, 2)},
              {at(top, 0), at(top, 2), at(top, 3)}};
  for (std::size_t r = 0; r < top; ++r)
    for (int k = 0; k < 4; ++k) {
      s.facets.push_back({at(r, k), at(r, k + 1), at(r + 1, k + 1)});
      s.facets.push_back({at(r, k), at(r + 1, k + 1), at(r + 1, k)});
    }
  return s;
}

TEST(BuriedParts, TheRimOfADeepPartBelongsToIt) {
  // A column that stands half in a box; a ring of its facets reaches no deeper than the crossings of a rough mesh.
  const Surface<3> inside = moved(column(0.2, {0.5, 0.9997, 0.9999, 1.5}), {0.4, 0.4, 0});
  const Surface<3> s = joined(box({0, 0, 0}, {1, 1, 1}), inside);
  ASSERT_LT(3e-4, least_burial_depth * bounding_box(s.vertices).diagonal());
  const BuriedParts found = found_in(s);
  std::vector<Index> expected{12, 13};  // the column's bottom
  for (Index f = 12 + 4; f < 12 + 4 + 16; ++f) expected.push_back(f);
  EXPECT_EQ(found.facets, expected);
  EXPECT_EQ(found.n_vertices, 8u);
}

TEST(BuriedParts, CrossingsOfARoughMeshAreNone) {
  // A sphere doubled: what lies inside is less deep than a mesh is exact.
  const Surface<3> sphere = unit_sphere(4);
  const double diagonal = bounding_box(sphere.vertices).diagonal();
  EXPECT_TRUE(found_in(joined(sphere, moved(sphere, {0.5 * least_burial_depth * diagonal, 0, 0}))).facets.empty());
  EXPECT_FALSE(found_in(joined(sphere, moved(sphere, {5 * least_burial_depth * diagonal, 0, 0}))).facets.empty());
}

TEST(WithoutBuried, AllFacetsAreThereOnce) {
  const Surface<3> both = joined(unit_sphere(3), moved(unit_sphere(3), {1.6, 0, 0}));
  const BuriedParts found = found_in(both);
  const Evidence<3> evidence = without_buried(both, {}, found.facets);
  EXPECT_EQ(evidence.unobserved.facets.size(), found.facets.size());
  EXPECT_EQ(evidence.observed.facets.size() + found.facets.size(), both.facets.size());
  EXPECT_NEAR(surface_measure(evidence.unobserved), found.share * surface_measure(both), 1e-12);
  EXPECT_TRUE(without_buried(both, {}, {}).is_complete());
}

TEST(WithoutBuried, WhatWasMadeUpStaysSo) {
  // As if the lower half of the left sphere had been filled in; the observed facets come in another order.
  const Surface<3> both = joined(unit_sphere(3), moved(unit_sphere(3), {1.6, 0, 0}));
  const BuriedParts found = found_in(both);
  Evidence<3> filled{{both.vertices, {}}, {{both.vertices.rbegin(), both.vertices.rend()}, {}}};
  const auto last = static_cast<Index>(both.vertices.size()) - 1;
  std::size_t n_buried = 0;
  for (Index f = static_cast<Index>(both.facets.size()) - 1; f >= 0; --f) {
    const bool is_filled = both.vertices[both.facets[f][0]].z() < -0.1;
    const auto& [a, b, c] = both.facets[f];
    if (is_filled) filled.unobserved.facets.push_back({last - a, last - b, last - c});
    else filled.observed.facets.push_back({a, b, c});
    n_buried += !is_filled && std::ranges::binary_search(found.facets, f);
  }
  ASSERT_GT(n_buried, 0u);
  ASSERT_LT(n_buried, found.facets.size());
  const Evidence<3> evidence = without_buried(both, filled, found.facets);
  EXPECT_EQ(evidence.observed.facets.size(), filled.observed.facets.size() - n_buried);
  EXPECT_EQ(evidence.unobserved.facets.size(), filled.unobserved.facets.size() + n_buried);
  EXPECT_NEAR(surface_measure(evidence.observed) + surface_measure(evidence.unobserved), surface_measure(both), 1e-12);
  for (const auto& facet : evidence.observed.facets) EXPECT_FALSE(both.vertices[facet[0]].z() < -0.1);
  const Surface<3> files = with_buried(evidence);
  EXPECT_EQ(files.facets.size(), filled.observed.facets.size());
  EXPECT_NEAR(surface_measure(files), surface_measure(filled.observed), 1e-12);
  // Once more changes nothing.
  EXPECT_EQ(without_buried(both, evidence, found.facets).observed.facets, evidence.observed.facets);
}

}  // namespace
}  // namespace shellmatch
