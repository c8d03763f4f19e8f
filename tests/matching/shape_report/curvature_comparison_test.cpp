#include "matching/shape_report/curvature_comparison.h"

#include "base/parallel.h"
#include "matching/shape_report/curvature_report.h"
#include "matching/experiment/generated_source.h"
#include "matching/input/shape_source.h"

#include <Eigen/Geometry>
#include <gtest/gtest.h>

namespace shellmatch {
namespace {

template <int Dim>
CurvatureComparison<Dim> compare(const std::string& source, int from, int to, double stretch = 1,
                                 DistanceMethod distance = DistanceMethod::exact) {
  auto shape = std::get<Shape<Dim>>(open_shape(source));
  for (Vec<Dim>& x : shape.surface.vertices) x *= stretch;
  std::optional<ExactShape<Dim>> formula;
  if (stretch == 1)
    if (const auto any = generated_formula(source)) formula = std::get<ExactShape<Dim>>(*any);
  ExperimentOptions options;
  options.cascade.min_level = from;
  options.cascade.max_level = to;
  options.coefficients.distance = distance;
  return compare_curvatures<Dim>(shape, formula, options, MeshFit{}, [](const CurvatureLevel&) {});
}

TEST(CurvatureComparison, PrincipalCurvaturesOfAnOperator) {
  const Eigen::Matrix3d q = Eigen::AngleAxisd(0.7, Vec<3>(1, 2, 3).normalized()).toRotationMatrix();
  // What lies along the normal does not count.
  const Mat<3> s = q * Vec<3>(-2, 5, 99).asDiagonal() * q.transpose();
  const auto k = principal_curvature<3>(s, q.col(2));
  EXPECT_NEAR(k.k1, 5, 1e-12);
  EXPECT_NEAR(k.k2, -2, 1e-12);
  EXPECT_NEAR(std::abs(k.first.dot(q.col(1))), 1, 1e-12);
  const auto plane = principal_curvature<2>(Mat<2>(Vec<2>(3, 7).asDiagonal()), Vec<2>(0, 1));
  EXPECT_NEAR(plane.k1, 3, 1e-12);
}

TEST(CurvatureComparison, ErrorsOfKnownDifferences) {
  const Vec<3> x(1, 0, 0), turned(std::cos(0.1), -std::sin(0.1), 0);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const std::vector<PrincipalCurvature<3>> expected = {{3, 1, x}, {3, 1, x}, {3, 2.9, x}, {nan, nan, x}};
  const std::vector<PrincipalCurvature<3>> found = {{3.5, 1, -x}, {3, 1.25, turned}, {3, 2.9, turned}, {3, 1, x}};
  const CurvatureErrors e = compare_curvatures<3>(found, expected, 2);
  EXPECT_EQ(e.n_vertices, 3u);
  EXPECT_EQ(e.n_directions, 2u) << "equal curvatures have no direction";
  EXPECT_DOUBLE_EQ(e.k1.median, 0);
  EXPECT_NEAR(compare_curvatures<3>({found[0]}, {expected[0]}, 2).k1.median, 1, 1e-14) << "times the diagonal";
  EXPECT_NEAR(compare_curvatures<3>({found[1]}, {expected[1]}, 2).direction.median, 0.1 * 180 / M_PI, 1e-9);
  EXPECT_NEAR(compare_curvatures<3>({found[0]}, {expected[0]}, 2).direction.median, 0, 1e-9) << "up to the sign";
  EXPECT_TRUE(std::isnan(compare_curvatures<3>({found[3]}, {expected[3]}, 2).k1.median));
}

// With the distance by its formula nothing but the grid errs. Graded grids converge at first order.
template <int Dim>
void expect_convergence(const std::string& source, int finest, double largest) {
  const auto c = compare<Dim>(source, 3, finest);
  const CurvatureErrors &coarse = *c.levels[c.levels.size() - 3].formula_to_formula,
                        &fine = *c.levels.back().formula_to_formula;
  const double order = 0.5 * std::log2(coarse.k1.p95 / fine.k1.p95);
  EXPECT_GT(order, 0.8) << source;
  EXPECT_LT(order, 2.2) << source;
  EXPECT_LT(fine.k1.median, largest) << source;
  EXPECT_LT(c.levels.back().to_formula->k1.median, 1.5 * largest) << source;
  EXPECT_LT(c.levels.back().to_mesh_fit.k1.median, 2 * largest) << source;
}

TEST(CurvatureComparison, GridsConvergeToTheFormula) {
  expect_convergence<2>("generate:ellipse/long", 8, 0.005);
  expect_convergence<3>("generate:torus", 6, 0.2);
  expect_convergence<3>("generate:ellipsoid/long", 6, 0.04);
}

TEST(CurvatureComparison, DirectionsOfTheTorusAreFound) {
  const auto c = compare<3>("generate:torus", 4, 5);
  EXPECT_LT(c.levels[1].to_formula->direction.median, 1.5);
  EXPECT_LT(c.levels[1].to_mesh_fit.direction.median, 1.5);
  EXPECT_EQ(c.levels[1].to_formula->n_directions, c.surface.vertices.size());
  EXPECT_LT(c.mesh_fit_to_formula->direction.p95, 1);
}

TEST(CurvatureComparison, MarchedDistancesServeToo) {
  const auto c = compare<3>("generate:torus", 4, 5, 1, DistanceMethod::fast_marching);
  EXPECT_LT(c.levels[1].to_formula->k1.median, 1.5);
  EXPECT_LT(c.levels[1].to_formula->direction.median, 3);
}

// Curvatures are in the user's units, errors have none.
TEST(CurvatureComparison, ScalesWithTheShape) {
  const auto one = compare<3>("generate:torus", 4, 4), large = compare<3>("generate:torus", 4, 4, 1000);
  EXPECT_NEAR(large.diagonal, 1000 * one.diagonal, 1e-9);
  EXPECT_NEAR(large.levels[0].side, one.levels[0].side, 1e-9);
  EXPECT_NEAR(large.levels[0].to_mesh_fit.k1.median, one.levels[0].to_mesh_fit.k1.median, 1e-5);
  for (std::size_t v = 0; v < one.grid.size(); v += 100) EXPECT_NEAR(1000 * large.grid[v].k1, one.grid[v].k1, 1e-5);
  EXPECT_NEAR(one.mesh_fit[0].k1, 10, 0.5) << "1/minor radius";
}

TEST(CurvatureComparison, SameBitsWithOneAndTwoThreads) {
  set_n_threads(1);
  const auto one = compare<3>("generate:ellipsoid/long", 4, 5);
  set_n_threads(2);
  const auto two = compare<3>("generate:ellipsoid/long", 4, 5);
  for (std::size_t v = 0; v < one.grid.size(); ++v) ASSERT_EQ(one.grid[v].k1, two.grid[v].k1);
}

}  // namespace
}  // namespace shellmatch
