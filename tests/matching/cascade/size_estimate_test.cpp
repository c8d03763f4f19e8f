#include "base/error.h"
#include "grid/octree/octree.h"
#include "matching/cascade/size_estimate.h"
#include "matching/input/shape_source.h"
#include "matching/level/shape_fields.h"
#include "tests/matching/output/temporary_folder.h"

#include <gtest/gtest.h>

#include <numbers>

namespace shellmatch {
namespace {

// The cascade's grid around a circle or sphere of radius r, refined where the surface meets a leaf.
template <int Dim>
Index actual_nodes(double r, int min_level, int max_level) {
  Octree<Dim> grid(min_level);
  const Vec<Dim> centre = Vec<Dim>::Constant(0.5 + 1e-3);
  for (int level = min_level; level < max_level; ++level)
    grid.refine([&](Index c) {
      const Vec<Dim> low = grid.cell_corner(c), high = low + Vec<Dim>::Constant(grid.cell(c).side());
      const Vec<Dim> nearest = centre.cwiseMax(low).cwiseMin(high) - centre;
      const Vec<Dim> farthest = (low - centre).cwiseAbs().cwiseMax((high - centre).cwiseAbs());
      return nearest.norm() <= r && farthest.norm() >= r;
    });
  return grid.n_nodes();
}

template <int Dim>
void expect_bound_from_above(const std::vector<std::pair<int, int>>& levels) {
  for (const double r : {0.15, 0.3})
    for (const auto& [low, high] : levels) {
      const double measure = Dim == 2 ? 2 * std::numbers::pi * r : 4 * std::numbers::pi * r * r;
      const double actual = actual_nodes<Dim>(r, low, high);
      const double estimated = estimate_size<Dim>({.phi = measure}, low, high).n_nodes;
      EXPECT_GT(estimated, actual) << Dim << " " << low << " " << high;
      EXPECT_LT(estimated, 2.5 * actual) << Dim << " " << low << " " << high;
    }
}
TEST(SizeEstimateTest, BoundsTheGridFromAboveInThePlane) { expect_bound_from_above<2>({{4, 9}, {3, 11}, {5, 5}}); }
TEST(SizeEstimateTest, BoundsTheGridFromAboveInSpace) { expect_bound_from_above<3>({{3, 6}, {2, 7}, {4, 4}}); }

// A shape's own grid, which is wider.
template <int Dim>
void expect_bound_of_fields(const std::string& name, int max_level) {
  const SignedDistance<Dim> d(std::get<Shape<Dim>>(open_shape("generate:" + name)).surface);
  FieldGrid<Dim> own(3);
  own.distance.compute(own.grid, d, DistanceMethod::exact);
  for (int level = 3; level < max_level; ++level) {
    own.refine(CoefficientOptions{}.reach);
    own.distance.compute(own.grid, d, DistanceMethod::exact);
  }
  const Surface<Dim> surface = std::get<Shape<Dim>>(open_shape("generate:" + name)).surface;
  double area = 0;
  for (Index f = 0; f < static_cast<Index>(surface.facets.size()); ++f) area += facet_measure(surface, f);
  const double estimated = estimate_size<Dim>({.phi = area, .fields = area}, 3, max_level).n_field_nodes;
  EXPECT_GT(estimated, own.grid.n_nodes());
  EXPECT_LT(estimated, 2.5 * own.grid.n_nodes());
}
TEST(SizeEstimateTest, BoundsTheShapesOwnGrids) {
  expect_bound_of_fields<2>("ellipse/long", 8);
  expect_bound_of_fields<3>("ellipsoid/long", 6);
}

TEST(SizeEstimateTest, GrowsWithTheSurface) {
  // Four times as many nodes per level in space, twice in the plane.
  const auto ratio = [](double a, double b) { return a / b; };
  EXPECT_NEAR(ratio(estimate_size<3>({.phi = 1}, 3, 12).n_nodes, estimate_size<3>({.phi = 1}, 3, 11).n_nodes), 4, 0.05);
  EXPECT_NEAR(ratio(estimate_size<2>({.phi = 1}, 3, 14).n_nodes, estimate_size<2>({.phi = 1}, 3, 13).n_nodes), 2, 0.05);
}

TEST(SizeEstimateTest, TooMuchIsAnEnvironmentErrorThatNamesALevelThatDoes) {
  check_size<3>({1, 0}, 3, 4, "/");
  const std::string message = testing::message_of<EnvironmentError>([] { check_size<3>({2, 0}, 3, 15, "/"); });
  EXPECT_NE(message.find("level 15 needs"), std::string::npos) << message;
  const std::size_t at = message.find("--levels 3:");
  ASSERT_NE(at, std::string::npos) << message;
  const int advised = std::stoi(message.substr(at + 11));
  EXPECT_LT(advised, 15);
  check_size<3>({2, 0}, 3, advised, "/");
}

}  // namespace
}  // namespace shellmatch
