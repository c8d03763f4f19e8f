// Triangles without area, cracks without width and edges of more than two triangles: what scans have that were
// decimated and rounded.
#include "geometry/repair/flat_triangles.h"
#include "geometry/repair/repair.h"
#include "geometry/repair/repair_steps.h"
#include "tests/geometry/io/files.h"
#include "tests/geometry/surface/test_surfaces.h"

#include <Eigen/Geometry>

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <random>

namespace shellmatch::testing {
namespace {

using test::box;
using test::joined;
using test::unit_sphere;

OriginalShape<3> original_of(const Surface<3>& surface) {
  OriginalShape<3> shape;
  shape.vertices = surface.vertices;
  for (const auto& [a, b, c] : surface.facets) shape.polygons.push_back({a, b, c});
  return shape;
}

struct Mended : MendedSurface {
  std::vector<std::string> notes;
  bool has_note(std::string_view part) const {
    return std::ranges::any_of(notes, [&](const std::string& note) { return note.find(part) != std::string::npos; });
  }
};

Mended mended(const Surface<3>& surface, Closing closing = Closing::automatic) {
  Mended result;
  static_cast<MendedSurface&>(result) = mend_surface(original_of(surface), "thing", result.notes, closing);
  EXPECT_TRUE(is_closed_and_oriented(result.surface));
  return result;
}

// A sphere with bumps and noise, its vertices rounded to a grid that does not know single precision; equal ones are
// one.
Surface<3> snapped_sphere(int trial, double cell) {
  const double phase = trial;
  std::mt19937 random(static_cast<unsigned>(trial));
  const auto noise = [&] { return 0.015 * (static_cast<double>(random()) / 2147483648.0 - 1); };
  Surface<3> fine = unit_sphere(5), surface;
  std::map<std::array<long, 3>, Index> number;
  std::vector<Index> vertex;
  for (const Vec<3>& x : fine.vertices) {
    const Vec<3> y =
        (1 + 0.2 * std::sin(5 * x.x() + phase) * std::cos(4 * x.y() - phase)) * (x + Vec<3>(noise(), noise(), noise()));
    const std::array<long, 3> grid{std::lround(y.x() / cell), std::lround(y.y() / cell), std::lround(y.z() / cell)};
    const auto [at, is_new] = number.emplace(grid, static_cast<Index>(surface.vertices.size()));
    if (is_new)
      surface.vertices.push_back(cell *
                                 Vec<3>(Eigen::Map<const Eigen::Matrix<long, 3, 1>>(grid.data()).cast<double>()));
    vertex.push_back(at->second);
  }
  for (auto facet : fine.facets) {
    for (Index& v : facet) v = vertex[v];
    if (facet[0] != facet[1] && facet[1] != facet[2] && facet[2] != facet[0]) surface.facets.push_back(facet);
  }
  return surface;
}

TEST(FlatTriangles, OfRoundedScansAreTakenApart) {
  for (int trial = 0; trial < 12; ++trial) {
    const Surface<3> rounded = snapped_sphere(trial, 0.0317 + 0.003 * trial);
    const double height = negligible_length(rounded.vertices);
    EXPECT_GT(flat_triangles(rounded, height).size(), 10u) << trial;
    const Mended result = mended(rounded);
    EXPECT_NEAR(enclosed_measure(result.surface), enclosed_measure(rounded), 0.005 * enclosed_measure(rounded))
        << trial;
    EXPECT_TRUE(flat_triangles(result.surface, 0).empty()) << trial;
    EXPECT_FALSE(result.has_note("wrapped")) << trial;
    EXPECT_LT(result.invented_share, 0.01) << trial;
  }
}

TEST(FlatTriangles, CracksThatTheyLeaveBehindAreStitched) {
  for (int trial = 0; trial < 12; ++trial) {
    const Surface<3> rounded = snapped_sphere(trial, 0.0317 + 0.003 * trial);
    Surface<3> cracked{rounded.vertices, {}};
    std::vector<bool> is_flat(rounded.facets.size(), false);
    for (const Index f : flat_triangles(rounded, negligible_length(rounded.vertices))) is_flat[f] = true;
    for (std::size_t f = 0; f < is_flat.size(); ++f)
      if (!is_flat[f]) cracked.facets.push_back(rounded.facets[f]);
    const Mended result = mended(cracked);
    EXPECT_NEAR(enclosed_measure(result.surface), enclosed_measure(rounded), 0.005 * enclosed_measure(rounded))
        << trial;
    EXPECT_FALSE(result.has_note("wrapped")) << trial;
    EXPECT_LT(result.invented_share, 0.01) << trial;
  }
}

TEST(FlatTriangles, EqualEdgesAreNotFlat) {
  Surface<3> tetrahedron;
  tetrahedron.vertices = {{1, 1, 1}, {1, -1, -1}, {-1, 1, -1}, {-1, -1, 1}};
  tetrahedron.facets = {{0, 1, 2}, {0, 2, 3}, {0, 3, 1}, {1, 3, 2}};
  EXPECT_TRUE(flat_triangles(tetrahedron, 0.1).empty());
}

// Three corners in a row, on both sides of an edge: flips alone exchange the two triangles for ever.
TEST(FlatTriangles, TwoThatShareTheirLongestEdge) {
  Surface<3> surface = box({0, 0, 0}, {1, 1, 1});
  const auto n = static_cast<Index>(surface.vertices.size());
  const auto [a, b, c] = surface.facets[0];
  const Vec<3>&x = surface.vertices[a], &y = surface.vertices[b];
  surface.vertices.insert(surface.vertices.end(), {0.75 * x + 0.25 * y, 0.25 * x + 0.75 * y});
  // a -> b is replaced by a -> n + 1 -> b in the first facet, and two flat ones close what that opens.
  surface.facets[0] = {a, n + 1, c};
  surface.facets.insert(surface.facets.end(), {{n + 1, b, c}, {a, b, n}, {a, n, n + 1}, {n, b, n + 1}});
  const Mended result = mended(surface, Closing::never);
  EXPECT_NEAR(enclosed_measure(result.surface), 1, 1e-14);
  EXPECT_TRUE(flat_triangles(result.surface, 0).empty());
  EXPECT_TRUE(result.has_note("3 triangles without area removed"));
}

// Vertices with equal coordinates are one.
Surface<3> welded(Surface<3> surface) {
  for (auto& facet : surface.facets)
    for (Index& v : facet)
      v = static_cast<Index>(std::ranges::find(surface.vertices, surface.vertices[v]) - surface.vertices.begin());
  return surface;
}

TEST(TakeApart, BoxesThatShareAnEdgeAreTwoBoxes) {
  Surface<3> boxes = welded(joined(box({0, 0, 0}, {1, 1, 1}), box({1, 1, 0}, {2, 2, 1})));
  EXPECT_EQ(take_apart(boxes), 1u);
  EXPECT_EQ(boxes.facets.size(), 24u);
  const Mended two = mended(boxes, Closing::never);
  EXPECT_NEAR(enclosed_measure(two.surface), 2, 1e-14);
  Surface<3> one = box({0, 0, 0}, {1, 1, 1});
  EXPECT_EQ(take_apart(one), 0u);
}

TEST(TakeApart, OfBoxesThatShareAFaceNothingIsMadeUp) {
  Surface<3> mirrored = box({0, 0, 0}, {1, 1, 1});
  for (auto& facet : mirrored.facets) std::swap(facet[1], facet[2]);
  for (Vec<3>& x : mirrored.vertices) x.x() = 2 - x.x();
  // Their common face has one diagonal or two; where it is turned, the angles of the two sides differ by roundings.
  for (const Surface<3>& other : {mirrored, box({1, 0, 0}, {2, 1, 1})})
    for (const double angle : {0.0, 1.0, 2.0}) {
      Surface<3> boxes = welded(joined(box({0, 0, 0}, {1, 1, 1}), other));
      for (Vec<3>& x : boxes.vertices) x = Eigen::AngleAxisd(angle, Vec<3>(1, 2, 3).normalized()) * x;
      const Mended one = mended(boxes);
      EXPECT_NEAR(enclosed_measure(one.surface), 2, 1e-14);
      EXPECT_NEAR(surface_measure(one.surface), 10, 1e-14);
      EXPECT_EQ(one.invented_share, 0);
      EXPECT_TRUE(one.evidence.is_complete());
    }
}

// The second shares a face with the first, and touches the third with a part of one.
TEST(TakeApart, BoxesThatTouchInPartOfAFaceStayApart) {
  const Surface<3> row =
      joined(joined(box({0, 0, 0}, {1, 1, 1}), box({1, 0, 0}, {2, 1, 1})), box({2, 0, 0}, {3, 1, 2}));
  const Mended three = mended(welded(row));
  EXPECT_NEAR(enclosed_measure(three.surface), 4, 1e-14);
  EXPECT_EQ(three.surface.facets.size(), 36u);
  EXPECT_EQ(three.invented_share, 0);
}

TEST(StitchCracks, BordersWhoseVerticesDiffer) {
  // The lid of a box by itself, its sides divided elsewhere.
  Surface<3> surface = box({0, 0, 0}, {1, 1, 1});
  std::erase_if(surface.facets, [&](const auto& f) {
    return std::ranges::all_of(f, [&](Index v) { return surface.vertices[v].z() == 1; });
  });
  ASSERT_EQ(surface.facets.size(), 10u);
  const auto n = static_cast<Index>(surface.vertices.size());
  surface.vertices.insert(surface.vertices.end(),
                          {{0, 0, 1}, {0.3, 0, 1}, {1, 0, 1}, {1, 0.6, 1}, {1, 0.7, 1}, {1, 1, 1}, {0, 1, 1}});
  for (Index k = 1; k < 6; ++k) surface.facets.push_back({n, n + k, n + k + 1});
  std::erase_if(surface.facets, [&](const auto& f) { return f[0] == n && f[1] == n + 1; });  // flat
  const Mended result = mended(surface);
  EXPECT_NEAR(enclosed_measure(result.surface), 1, 1e-14);
  EXPECT_EQ(result.invented_share, 0);
  EXPECT_TRUE(result.has_note("of cracks without width closed"));
  EXPECT_FALSE(result.has_note("hole"));
}

TEST(StitchCracks, HolesStayHoles) {
  Surface<3> open = unit_sphere(2);
  open.facets.resize(open.facets.size() - 5);
  const Surface<3> before = open;
  EXPECT_EQ(stitch_cracks(open, negligible_length(open.vertices)), 0u);
  EXPECT_EQ(open.facets, before.facets);
}

TEST(Precision, FarFromTheOriginItIsUsedUpAndSaid) {
  Surface<3> far = unit_sphere(4);
  for (Vec<3>& x : far.vertices) x = (5 * x + Vec<3>(2e7, -1e7, 3e6)).cast<float>().cast<double>();
  EXPECT_TRUE(mended(far).has_note("single precision is used up"));
  Surface<3> sheet{far.vertices, {far.facets.begin(), far.facets.begin() + 5}};
  std::vector<std::string> notes;
  const std::string message = input_error_of([&] { mend_surface(original_of(sheet), "thing", notes, Closing::never); });
  EXPECT_TRUE(contains(message, "single precision is used up"));
  // In double precision the same is fine, and places keep the digits that tell them apart.
  Surface<3> exact = unit_sphere(4);
  for (Vec<3>& x : exact.vertices) x = 5 * x + Vec<3>(2e7 + 0.1, -1e7, 3e6);
  EXPECT_FALSE(mended(exact).has_note("single precision"));
  exact.facets.pop_back();
  EXPECT_TRUE(contains(input_error_of([&] { mend_surface(original_of(exact), "thing", notes, Closing::never); }),
                       "one from (2000000"));
}

}  // namespace
}  // namespace shellmatch::testing
