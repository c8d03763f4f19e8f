#include "grid/fits/curvature.h"

#include "base/parallel.h"
#include "grid/fields/sample.h"
#include "tests/grid/exact_shapes.h"
#include "tests/grid/test_grids.h"

#include <gtest/gtest.h>

namespace shellmatch {
namespace {

using test::ellipsoid;
using test::ExactShape;
using test::sphere;
using test::sphere_grid;
using test::torus;

// Root mean square error of P D^2 d P within `width` of the surface, relative to its size.
template <int Dim>
double shape_operator_error(const Octree<Dim>& grid, const ExactShape<Dim>& shape, double width) {
  const auto d = sample_nodes<Dim>(grid, shape.distance);
  std::vector<Index> band;
  for (const Index node : grid.free_nodes())
    if (std::abs(d[node]) <= width) band.push_back(node);
  const auto geometry = nodal_geometry<Dim>(grid, d, CoefficientOptions{}, band);
  double error = 0, size = 0;
  for (const Index node : band) {
    const Vec<Dim> n = geometry.normal[node];
    const Mat<Dim> expected = shape.hessian(grid.node_position(node));
    const Mat<Dim> found = unpack_symmetric<Dim>(geometry.extended_shape[node]) - n * n.transpose();
    error += (found - expected).squaredNorm();
    size += expected.squaredNorm();
  }
  return std::sqrt(error / size);
}

template <int Dim>
double uniform_order(const ExactShape<Dim>& shape, int level) {
  const double coarse = shape_operator_error(Octree<Dim>(level), shape, 0.04);
  const double fine = shape_operator_error(Octree<Dim>(level + 1), shape, 0.04);
  EXPECT_LT(fine, 0.1);
  return std::log2(coarse / fine);
}

TEST(Curvature, SecondOrderOnUniformGrids) {
  const auto expect_second = [](double order) {
    EXPECT_GT(order, 1.7);
    EXPECT_LT(order, 2.4);
  };
  expect_second(uniform_order(sphere<2>(0.3), 6));
  expect_second(uniform_order(ellipsoid<2>({0.32, 0.25}), 7));
  expect_second(uniform_order(sphere<3>(0.3), 4));
  expect_second(uniform_order(ellipsoid<3>({0.35, 0.3, 0.27}), 4));
  expect_second(uniform_order(torus(0.27, 0.14), 5));
}

// The band is two cells of the finest level wide on either side, as it is for the energies. Neighbourhoods
// are lopsided throughout it, which costs one order.
template <int Dim>
double adaptive_order(const ExactShape<Dim>& shape, int level) {
  std::array<double, 2> errors;
  for (int i = 0; i < 2; ++i) {
    const auto grid = test::shape_grid<Dim>(3, level + i, shape.distance);
    errors[i] = shape_operator_error(grid, shape, 2 * grid.finest_side());
  }
  EXPECT_LT(errors[1], 0.1);
  return std::log2(errors[0] / errors[1]);
}

TEST(Curvature, FirstOrderWhereTheLevelChanges) {
  EXPECT_GT(adaptive_order(sphere<2>(0.3), 8), 0.8);
  EXPECT_GT(adaptive_order(ellipsoid<2>({0.32, 0.25}), 8), 0.8);
  EXPECT_GT(adaptive_order(sphere<3>(0.3), 5), 0.8);
  EXPECT_GT(adaptive_order(ellipsoid<3>({0.35, 0.3, 0.27}), 5), 0.8);
  EXPECT_GT(adaptive_order(torus(0.27, 0.14), 6), 0.8);
}

// Off the surface it is 1/(R + d), on it 1/R.
TEST(Curvature, RootsOfASphere) {
  const auto grid = sphere_grid<3>(4, 6, 0.3, Vec<3>::Constant(0.5));
  const auto shape = sphere<3>(0.3);
  const auto d = sample_nodes<3>(grid, shape.distance);
  CoefficientOptions options;
  const auto root = compute_coefficients<3>(grid, d, options, false);
  const auto inverse = compute_coefficients<3>(grid, d, options, true);
  EXPECT_EQ(root.distance, d);
  for (const Index node : grid.free_nodes()) {
    if (std::abs(d[node]) > 0.03) continue;
    const Vec<3> n = (grid.node_position(node) - Vec<3>::Constant(0.5)).normalized();
    const Mat<3> r = unpack_symmetric<3>(root.root[node]);
    const Mat<3> expected = (Mat<3>::Identity() - n * n.transpose()) / std::sqrt(0.3 + d[node]) + n * n.transpose();
    ASSERT_LE((r - expected).norm(), 0.15);
    ASSERT_LE((r * unpack_symmetric<3>(inverse.root[node]) - Mat<3>::Identity()).norm(), 1e-12);
  }
  for (const auto& h : grid.hanging_nodes()) {
    double mean = 0;
    for (int p = 0; p < h.n_parents; ++p) mean += root.root[h.parents[p]][0] / h.n_parents;
    ASSERT_NEAR(root.root[h.node][0], mean, 1e-12) << "continuous";
  }
}

TEST(Curvature, CapHoldsAtTheMedialAxis) {
  const Octree<3> grid(4);
  CoefficientOptions options;
  options.max_curvature_times_h = 0.25;
  const auto fields = compute_coefficients<3>(grid, sample_nodes<3>(grid, sphere<3>(0.3).distance), options, false);
  double largest = 0;
  for (const auto& r : fields.root) largest = std::max(largest, unpack_symmetric<3>(r).norm());
  EXPECT_LE(largest, std::sqrt(3 * 0.25 * 16) + 1e-12);
  EXPECT_GE(largest, std::sqrt(0.25 * 16)) << "and is reached at the centre of the sphere";
}

TEST(Curvature, ThePairSharesItsClassifier) {
  const Octree<2> grid(5);
  const auto circle = sample_nodes<2>(grid, sphere<2>(0.3).distance);
  // The complement of a disc: curvature -1/0.2.
  const auto hole = sample_nodes<2>(grid, [](const Vec<2>& x) { return 0.2 - (x - Vec<2>::Constant(0.5)).norm(); });
  CoefficientOptions options;
  options.classification = Classification::shift;
  options.max_curvature_times_h = 0.5;
  options.invert_at_point = false;
  const auto pair = coefficient_pair<2>({&grid, &grid}, nodal_geometry<2>(grid, {circle, hole}, options), options);
  options.invert_at_point = true;
  const auto plain = coefficient_pair<2>({&grid, &grid}, nodal_geometry<2>(grid, {circle, hole}, options), options);
  const auto geometry = nodal_geometry<2>(grid, {circle, hole}, options);
  const auto classifier = make_classifier<2>({&grid, &grid}, options, geometry[0], geometry[1]);
  EXPECT_GE(classifier.shift, 5 + options.tau) << "above the curvature of the hole";
  const auto alone = classify<2>(grid, geometry[0], classifier, false);
  EXPECT_EQ(plain.reference.root, alone.root);
  EXPECT_EQ(plain.target.root, pair.target.root);
  for (const Index node : grid.free_nodes()) {
    const Mat<2> product =
        unpack_symmetric<2>(plain.reference.root[node]) * unpack_symmetric<2>(pair.reference.root[node]);
    ASSERT_LE((product - Mat<2>::Identity()).norm(), 1e-12);
  }
}

TEST(Curvature, SameBitsWithOneAndTwoThreads) {
  const auto grid = sphere_grid<3>(3, 5, 0.3, Vec<3>::Constant(0.5));
  const auto d = sample_nodes<3>(grid, torus(0.25, 0.12).distance);
  set_n_threads(1);
  const auto one = compute_coefficients<3>(grid, d, {}, false);
  set_n_threads(2);
  const auto two = compute_coefficients<3>(grid, d, {}, false);
  EXPECT_EQ(one.normal, two.normal);
  EXPECT_EQ(one.root, two.root);
}

}  // namespace
}  // namespace shellmatch
