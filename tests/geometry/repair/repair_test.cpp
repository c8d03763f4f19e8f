// Mending of triangle surfaces: closed, oriented outward, nothing lost, nothing hidden.
#include "geometry/io/read_shape.h"
#include "geometry/repair/repair.h"
#include "geometry/repair/repair_steps.h"
#include "tests/geometry/io/files.h"

#include <Eigen/Geometry>

#include <cmath>
#include <numbers>
#include <random>

namespace shellmatch::testing {

namespace {

Shape<3> mended(const OriginalShape<3>& original) {
  Shape<3> shape{"thing", original, {}, {}};
  shape.surface = mend_surface(shape.original, shape.source, shape.notes).surface;
  EXPECT_TRUE(is_closed_and_oriented(shape.surface));
  return shape;
}

std::string message(const OriginalShape<3>& original) {
  std::vector<std::string> notes;
  return input_error_of([&] { mend_surface(original, "thing", notes); });
}

TEST(Repair, OrientationIsFoundNotAssumed) {
  std::mt19937 random(7);
  for (int trial = 0; trial < 20; ++trial) {
    OriginalShape<3> shape = cube();
    for (auto& polygon : shape.polygons)
      if (random() % 2) std::reverse(polygon.begin(), polygon.end());
    EXPECT_NEAR(volume(mended(shape).surface), 1, 1e-14);
  }
}

TEST(Repair, PartsFaceOutwardAndCavitiesInward) {
  for (const bool first : {false, true})
    for (const bool second : {false, true}) {
      OriginalShape<3> apart;
      append(apart, cube(), first);
      append(apart, cube({3, 0, 0}, 2), second);
      EXPECT_NEAR(volume(mended(apart).surface), 1 + 8, 1e-13);
      OriginalShape<3> nested;
      append(nested, cube({0.25, 0.25, 0.25}, 0.5), first);
      append(nested, cube(), second);
      append(nested, cube({0.4, 0.4, 0.4}, 0.1), first);
      const Shape<3> shape = mended(nested);
      EXPECT_NEAR(volume(shape.surface), 1 - 0.125 + 0.001, 1e-14);
      EXPECT_TRUE(has_note(shape, "1 part lies inside another"));
    }
}

// The vertical ray from a corner of the inner cube meets the diagonal of the outer one's top. With coordinates of 1e20
// the search for a better ray went on for ever.
TEST(Repair, PartsOfAnySizeAreFoundNested) {
  for (const double side : {1e-40, 1.0, 1e20, 1e49}) {
    OriginalShape<3> shape = cube(Vec<3>::Zero(), 4 * side);
    append(shape, cube(Vec<3>::Constant(side), side));
    EXPECT_NEAR(volume(mended(shape).surface) / (side * side * side), 63, 1e-9) << side;
  }
}

// A tetrahedron whose corner is one of the cube's, in a vertex of its own or in the cube's; also one whose four corners
// are all the cube's.
TEST(Repair, CavitiesMayTouchTheOuterWall) {
  const std::vector<std::vector<Index>> faces = {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {0, 3, 2}};
  for (const bool is_inscribed : {false, true})
    for (const bool is_shared : {false, true}) {
      const Vec<3> a = is_inscribed ? Vec<3>(1, 1, 0) : Vec<3>(0.5, 0.2, 0.2), b(a[2], a[0], a[1]), c(a[1], a[2], a[0]);
      OriginalShape<3> tetrahedron;
      tetrahedron.vertices = {Vec<3>::Zero(), a, b, c};
      tetrahedron.polygons = faces;
      OriginalShape<3> shape = cube();
      append(shape, tetrahedron);
      for (auto& polygon : shape.polygons)
        for (Index& v : polygon) v = is_shared && v == 8 ? 0 : v;
      const Shape<3> result = mended(shape);
      EXPECT_NEAR(volume(result.surface), 1 - std::abs(a.dot(b.cross(c))) / 6, 1e-14);
      EXPECT_TRUE(has_note(result, "1 part lies inside another")) << is_inscribed << is_shared;
    }
}

TEST(Repair, CrossingPartsAreNotNested) {
  OriginalShape<3> shape;
  append(shape, cube());
  append(shape, cube({0.5, 0.25, 0.25}, 0.5), true);  // touches the side of the first from within
  append(shape, cube({0.5, 0.5, 0.5}, 1), true);
  const Shape<3> result = mended(shape);
  EXPECT_NEAR(volume(result.surface), 1 + 0.125 + 1, 1e-14);
  EXPECT_TRUE(has_note(result, "cross or touch"));
}

// Each facet of the second has a vertex within the first.
TEST(Repair, APartWithATipOutsideIsNotNested) {
  const std::vector<std::vector<Index>> faces = {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {0, 3, 2}};
  const OriginalShape<3> outer{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, faces, {}};
  const OriginalShape<3> crossing{{{0.3, 0.1, 0.1}, {0.1, 0.3, 0.1}, {0.1, 0.1, 0.3}, {0.9, 0.9, 0.9}}, faces, {}};
  OriginalShape<3> shape = outer;
  append(shape, crossing);
  EXPECT_NEAR(volume(mended(shape).surface), volume(mended(outer).surface) + volume(mended(crossing).surface), 1e-14);
}

TEST(Repair, SeamsAreWeldedAndTouchingPartsAreNot) {
  OriginalShape<3> loose;
  const OriginalShape<3> box = cube();
  for (const auto& polygon : box.polygons) {
    std::vector<Index> own;
    for (const Index v : polygon) {
      own.push_back(static_cast<Index>(loose.vertices.size()));
      loose.vertices.push_back(box.vertices[v]);
    }
    loose.polygons.push_back(own);
  }
  loose.vertices.emplace_back(9, 9, 9);
  const Shape<3> shape = mended(loose);
  EXPECT_EQ(shape.surface.vertices.size(), 8u);
  EXPECT_EQ(shape.original.vertices.size(), 25u);
  EXPECT_TRUE(has_note(shape, "16 duplicate vertices welded"));
  EXPECT_TRUE(has_note(shape, "1 unused vertex left out"));
  OriginalShape<3> touching = box;
  append(touching, cube({1, 0, 0}));  // shares a whole side
  EXPECT_NEAR(volume(mended(touching).surface), 2, 1e-14);
}

TEST(Repair, TrianglesThatCollapseAsTheirSeamCloses) {
  // A third corner at the place of another, which welding makes the same; in every order of the three.
  for (int turn = 0; turn < 3; ++turn) {
    OriginalShape<3> shape = cube();
    std::vector<Index> sliver = {8, 9, 10};
    for (const Vec<3>& x : {Vec<3>(0, 0, 0), Vec<3>(1, 0, 0), Vec<3>(0, 0, 0)}) shape.vertices.push_back(x);
    std::rotate(sliver.begin(), sliver.begin() + turn, sliver.end());
    shape.polygons.push_back(sliver);
    const Shape<3> result = mended(shape);
    EXPECT_NEAR(volume(result.surface), 1, 1e-14);
    EXPECT_TRUE(has_note(result, "1 triangle with a repeated corner removed")) << turn;
  }
}

TEST(Repair, VerticesWherePartsTouchAreSplit) {
  OriginalShape<3> shape = cube();
  OriginalShape<3> second = cube({1, 1, 1});
  append(shape, second);
  for (auto& polygon : shape.polygons)
    for (Index& v : polygon) v = v == 8 ? 7 : v;  // one common vertex
  const Shape<3> result = mended(shape);
  EXPECT_EQ(result.surface.vertices.size(), 16u);
  EXPECT_TRUE(has_note(result, "1 vertex added where the surface touches itself"));
}

TEST(Repair, PolygonsThatAreNotConvexKeepTheirArea) {
  // A comb with n teeth, extruded: the caps are far from convex, and start at any corner.
  for (int start = 0; start < 9; ++start) {
    std::vector<Vec<2>> comb = {{0, 0}, {5, 0}, {5, 3}, {4, 3}, {4, 1}, {3, 3}, {2, 1}, {1, 3}, {0, 3}};
    std::rotate(comb.begin(), comb.begin() + start, comb.end());
    const auto n = static_cast<Index>(comb.size());
    OriginalShape<3> shape;
    for (const double z : {0.0, 2.0})
      for (const Vec<2>& x : comb) shape.vertices.emplace_back(x.x(), x.y(), z);
    shape.polygons.resize(2);
    double base = 0;
    for (Index i = 0; i < n; ++i) {
      const Index j = (i + 1) % n;
      shape.polygons[0].insert(shape.polygons[0].begin(), i);
      shape.polygons[1].push_back(n + i);
      shape.polygons.push_back({i, j, n + j, n + i});
      base += 0.5 * (comb[i].x() * comb[j].y() - comb[i].y() * comb[j].x());
    }
    const Shape<3> result = mended(shape);
    EXPECT_NEAR(volume(result.surface), 2 * base, 1e-13);
    double total = 0, walls = 0;
    for (std::size_t f = 0; f < result.surface.facets.size(); ++f) {
      const auto& [a, b, c] = result.surface.facets[f];
      const auto& x = result.surface.vertices;
      const Vec<3> u = x[b] - x[a], v = x[c] - x[a];
      total += 0.5 * std::sqrt(u.squaredNorm() * v.squaredNorm() - u.dot(v) * u.dot(v));
    }
    for (Index i = 0; i < n; ++i) walls += 2 * (comb[(i + 1) % n] - comb[i]).norm();
    EXPECT_NEAR(total, 2 * base + walls, 1e-12) << "no triangle may reach out of its polygon";
  }
}

TEST(Repair, FlatTrianglesGoAndTheSurfaceStaysClosed) {
  OriginalShape<3> shape = cube();
  // A vertex in the middle of an edge, joined to one side only by a triangle without area.
  shape.vertices.emplace_back(0.5, 0, 0);
  shape.polygons.push_back({0, 8, 1});
  shape.polygons[0] = {0, 2, 3, 1, 8};
  const Shape<3> result = mended(shape);
  EXPECT_NEAR(volume(result.surface), 1, 1e-14);
  EXPECT_TRUE(has_note(result, "without area removed"));
  for (std::size_t f = 0; f < result.surface.facets.size(); ++f) {
    const auto& [a, b, c] = result.surface.facets[f];
    const auto& x = result.surface.vertices;
    const Vec<3> u = x[b] - x[a], v = x[c] - x[a];
    EXPECT_GT(u.squaredNorm() * v.squaredNorm() - u.dot(v) * u.dot(v), 1e-6);
  }
}

// A prism whose base has three corners in one line and crosses itself: flips fold two triangles onto each other.
TEST(Repair, TrianglesThatAreFoldedOntoEachOtherGo) {
  const std::vector<Vec<3>> base = {{1.75, -30, -30.5},
                                    {0, 0, 1},
                                    {0, 13.75, 0},
                                    {0, 4, 0},
                                    {0, 4, 4},
                                    {0, 2, 2},
                                    {2.75, 2.75, -3.25},
                                    {0, -30.5, -30.5},
                                    {-30.5, -30.5, -30.5},
                                    {-30.5, -30.5, -30.5}};
  OriginalShape<3> shape;
  const auto n = static_cast<Index>(base.size());
  for (const double height : {0.0, 4.0})
    for (const Vec<3>& x : base) shape.vertices.push_back(x + height * Vec<3>::UnitZ());
  shape.polygons.resize(2);
  for (Index k = 0; k < n; ++k) {
    shape.polygons[0].push_back(n - 1 - k);
    shape.polygons[1].push_back(n + k);
    shape.polygons.push_back({k, (k + 1) % n, n + (k + 1) % n, n + k});
  }
  EXPECT_GT(volume(mended(shape).surface), 0);
}

TEST(Repair, RepeatedTrianglesGo) {
  OriginalShape<3> shape = cube();
  shape.polygons.push_back({0, 2, 3});
  shape.polygons.push_back({5, 5, 7});
  const Shape<3> result = mended(shape);
  EXPECT_NEAR(volume(result.surface), 1, 1e-14);
  EXPECT_TRUE(has_note(result, "1 repeated triangle removed"));
}

TEST(Repair, OpenSurfacesAreRefusedWithTheirHoles) {
  OriginalShape<3> shape = cube();
  shape.polygons.erase(shape.polygons.begin() + 1);
  EXPECT_TRUE(contains(message(shape), "thing: the surface is open: 4 boundary edges in 1 loop, one from (0, 0, 1)"));
  shape.polygons.erase(shape.polygons.begin());
  EXPECT_TRUE(contains(message(shape), "8 boundary edges in 2 loops"));
}

TEST(Repair, OtherSurfacesThatBoundNothing) {
  OriginalShape<3> shape = cube();
  shape.polygons.push_back({0, 1, 7});
  EXPECT_TRUE(contains(message(shape), "not manifold"));
  // Two sheets on top of each other.
  OriginalShape<3> flat;
  flat.vertices = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0.3, 0.3, 0}};
  flat.polygons = {{0, 1, 2}, {0, 3, 1}, {1, 3, 2}, {2, 3, 0}};
  EXPECT_TRUE(contains(message(flat), "encloses no volume"));
  flat.polygons.clear();
  EXPECT_TRUE(contains(message(flat), "no faces"));
  flat.polygons = {{0, 1, 0}};
  EXPECT_TRUE(contains(message(flat), "no area"));
  // Klein bottle: a torus whose ends are joined the wrong way round.
  OriginalShape<3> bottle;
  constexpr Index n = 12;
  for (Index i = 0; i < n; ++i)
    for (Index j = 0; j < n; ++j) {
      const double u = 2 * std::numbers::pi * i / n, v = 2 * std::numbers::pi * j / n;
      const double r = 2 + std::cos(u / 2) * std::sin(v) - std::sin(u / 2) * std::sin(2 * v);
      bottle.vertices.emplace_back(r * std::cos(u), r * std::sin(u),
                                   std::sin(u / 2) * std::sin(v) + std::cos(u / 2) * std::sin(2 * v));
      const auto at = [](Index a, Index b) { return a < n ? a * n + b % n : (n - b % n) % n; };
      bottle.polygons.push_back({at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)});
    }
  EXPECT_TRUE(contains(message(bottle), "one-sided"));
}

TEST(Repair, SmallAndFarAwayShapesKeepTheirVolume) {
  EXPECT_NEAR(volume(mended(cube({0, 0, 0}, 1e-9)).surface) / 1e-27, 1, 1e-12);
  EXPECT_EQ(mended(cube({1e7, -1e7, 1e7}, 1)).surface.facets.size(), 12u);
}

}  // namespace
}  // namespace shellmatch::testing
