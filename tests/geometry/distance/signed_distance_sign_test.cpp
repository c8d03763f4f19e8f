// The sign, against the winding number: two algorithms that share nothing.
#include "geometry/distance/signed_distance.h"
#include "geometry/distance/winding_number.h"
#include "geometry/surface/self_intersections.h"
#include "tests/geometry/surface/test_surfaces.h"

#include <gtest/gtest.h>

#include <utility>

namespace shellmatch {
namespace {

using namespace test;

/// Tells how many points lie inside, so that a test cannot pass for want of them.
template <int Dim>
int expect_sign_of_winding_number(const Surface<Dim>& surface, const std::vector<Vec<Dim>>& points) {
  const SignedDistance<Dim> distance(surface);
  int n_inside = 0, n_compared = 0;
  for (const Vec<Dim>& x : points) {
    const double d = distance(x);
    if (std::abs(d) < 1e-10) continue;
    ++n_compared;
    const bool inside = winding_number(surface, x) > 0.5;
    EXPECT_EQ(d < 0, inside) << x.transpose() << " at distance " << d;
    n_inside += inside;
  }
  EXPECT_GT(n_compared, static_cast<int>(points.size()) * 9 / 10);
  return n_inside;
}

TEST(SignedDistanceSign, AgreesOnSmoothAndSpikySurfaces) {
  const Surface<3> round = torus(0.6, 0.25, 30, 15);
  EXPECT_GT(expect_sign_of_winding_number(round, query_points(round, 300)), 50);
  // Every vertex of the finest level moved at random: sharp edges, concave and convex.
  const auto noise = random_points<3>(400, Vec<3>::Constant(-0.12), Vec<3>::Constant(0.12), 9);
  std::size_t i = 0;
  const Surface<3> spiky =
      mapped<3>(unit_sphere(3), [&](const Vec<3>& x) { return Vec<3>(x * (1 + 2 * noise[i++ % 400].x())); });
  EXPECT_GT(expect_sign_of_winding_number(spiky, query_points(spiky, 1000)), 100);
}

TEST(SignedDistanceSign, AgreesInThePlane) {
  const Surface<2> star = polygon(14, [](double t) { return std::cos(7 * t) > 0 ? 1.0 : 0.15; });
  EXPECT_GT(expect_sign_of_winding_number(star, query_points(star, 1000)), 100);
}

TEST(SignedDistanceSign, AgreesInAHollowBody) {
  const Surface<3> hollow = joined(box({0, 0, 0}, {1, 1, 1}), reversed(box({0.3, 0.2, 0.4}, {0.6, 0.7, 0.8})));
  EXPECT_GT(expect_sign_of_winding_number(hollow, query_points(hollow, 500)), 100);
}

TEST(SignedDistanceSign, AgreesOnASharpWedge) {
  const Surface<3> wedge = wedge_with_flat_triangle(0.02);
  // All around the sharp edge, in whose plane a single facet's normal would decide wrongly.
  auto points = random_points<3>(2000, {-0.1, -0.05, -0.03}, {1.1, 0.1, 0.03}, 3);
  EXPECT_GT(expect_sign_of_winding_number(wedge, points), 15);
}

// A triangle of a scan that is turned over, on the outermost place: whatever lies beyond it seems to be inside.
TEST(SignedDistanceSign, OutsideIsOutsideBeyondATriangleThatIsTurnedOver) {
  Surface<3> s = unit_sphere(3);
  const auto [a, b, c] = s.facets[100];
  const Vec<3> centre = (s.vertices[a] + s.vertices[b] + s.vertices[c]) / 3;
  std::swap(s.vertices[a], s.vertices[b]);
  for (const Index v : {a, b, c}) s.vertices[v] *= 1.3;
  const SignedDistance<3> by_normals(s), checked(s, self_intersecting_facets(s));
  int n_wrong = 0;
  for (const Vec<3>& offset : random_points<3>(2000, Vec<3>::Constant(-0.5), Vec<3>::Constant(0.5), 5)) {
    const Vec<3> x = 1.6 * centre + offset;
    const ClosestPoint<3> found = checked.closest(x);
    EXPECT_EQ(std::abs(found.signed_distance), std::abs(by_normals(x)));
    if (winding_number(s, x) > 0.5) continue;
    n_wrong += by_normals(x) < 0;
    EXPECT_GT(found.signed_distance, 0) << x.transpose();
    EXPECT_LT((found.normal * found.signed_distance - (x - found.point)).norm(), 1e-9);
  }
  EXPECT_GT(n_wrong, 50);
}

void expect_sign_on_data(const std::string& file) {
  const auto surface = data_surface(file);
  if (!surface) GTEST_SKIP() << "no file " << file << "; set SHELLMATCH_DATA to the data folder";
  EXPECT_GT(expect_sign_of_winding_number(*surface, query_points(*surface, 200)), 50);
}

TEST(SignedDistanceSign, AgreesOnAVertebra) { expect_sign_on_data("vertebra_L1_verse/verse018_aligned_to_016.ply"); }
TEST(SignedDistanceSign, AgreesOnAHand) { expect_sign_on_data("hands_makehuman/hand_woman_young.off"); }

}  // namespace
}  // namespace shellmatch
