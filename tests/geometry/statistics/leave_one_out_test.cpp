// Components of a shape along the modes of all others, against a decomposition of those, for spectra that are hard to
// tell apart.
#include "geometry/statistics/leave_one_out.h"

#include "geometry/statistics/products.h"
#include "tests/geometry/statistics/families.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace shellmatch {
namespace {

// S' = diag(values) - rho z z^T, decomposed. What the shape has of directions in which S' is 0 remains whatever the
// number of modes.
Eigen::VectorXd directly(const Eigen::VectorXd& values, const Eigen::VectorXd& z, double n) {
  const double rho = n / (n - 1), shift = values[0];  // all eigenvalues are positive then, and none is left out
  Eigen::MatrixXd matrix = (values.array() + shift).matrix().asDiagonal();
  matrix -= rho * z * z.transpose();
  const GramEigen eigen = gram_eigen(matrix, 0);
  const Eigen::VectorXd components = rho * eigen.vectors.transpose() * z;
  Eigen::VectorXd squares = Eigen::VectorXd::Zero(values.size() + 1);
  const auto is_mode = [&](Eigen::Index k) { return eigen.values[k] - shift > 1e-12 * values[0]; };
  for (Eigen::Index k = 0; k < values.size(); ++k)
    if (!is_mode(k)) squares[values.size()] += components[k] * components[k];
  for (Eigen::Index k = values.size(); k-- > 0;)
    squares[k] = squares[k + 1] + (is_mode(k) ? components[k] * components[k] : 0);
  return squares;
}

// Scores of one of n shapes whose scatter has these eigenvalues: sum_j z_j^2 / lambda_j is at most 1 - 1/n.
Eigen::VectorXd admissible(const Eigen::VectorXd& values, const Eigen::VectorXd& directions, double n, double share) {
  return (values.array().sqrt() * directions.array()).matrix() * std::sqrt(share * (1 - 1 / n)) / directions.norm();
}

void expect_same(const Eigen::VectorXd& values, const Eigen::VectorXd& z, double n, double tolerance) {
  const Eigen::VectorXd ours = left_out_distances(values, z, static_cast<Eigen::Index>(n)),
                        theirs = directly(values, z, n);
  ASSERT_EQ(ours.size(), theirs.size());
  EXPECT_LE((ours - theirs).cwiseAbs().maxCoeff(), tolerance * theirs[0]);
  const double rho = n / (n - 1);
  EXPECT_NEAR(ours[0], rho * rho * z.squaredNorm(), 1e-12 * theirs[0]);  // nothing of the shape is lost
  for (Eigen::Index k = 0; k + 1 < ours.size(); ++k) EXPECT_GE(ours[k], ours[k + 1]);
}

TEST(LeaveOneOut, OfSpectraOfManyKinds) {
  constexpr double n = 31;
  const Eigen::VectorXd directions = testing::random_sets(2, 15, 1, 3).coordinates.col(0);
  const Eigen::VectorXd linear = Eigen::VectorXd::LinSpaced(30, 3, 0.1);
  Eigen::VectorXd geometric(30), pairs = linear;
  for (Eigen::Index k = 0; k < 30; ++k) geometric[k] = std::pow(0.4, static_cast<double>(k));
  for (Eigen::Index k = 0; k + 1 < 30; k += 2) pairs[k + 1] = pairs[k] * (1 - 1e-9);
  for (const double share : {1.0, 0.999999, 0.5, 1e-3, 1e-8}) {
    for (const Eigen::VectorXd& values : {linear, geometric})
      expect_same(values, admissible(values, directions, n, share), n, 1e-9);
    expect_same(pairs, admissible(pairs, directions, n, share), n,
                1e-5);  // vectors of neighbours are determined to fewer digits
  }
  expect_same(linear.head(1), admissible(linear.head(1), directions.head(1), n, 0.7), n, 1e-12);
  expect_same(linear.head(2), admissible(linear.head(2), directions.head(2), n, 0.7), n, 1e-12);
}

TEST(LeaveOneOut, WhereTheShapeHasNothingOfAMode) {
  constexpr double n = 11;
  const Eigen::VectorXd values = Eigen::VectorXd::LinSpaced(10, 3, 0.1);
  for (const double tiny : {0.0, 1e-300, 1e-20, 1e-14, 1e-9}) {
    Eigen::VectorXd directions = Eigen::VectorXd::Ones(10);
    for (const Eigen::Index k : {0, 4, 5, 9}) directions[k] = tiny;
    expect_same(values, admissible(values, directions, n, 0.8), n, 1e-10);
  }
  EXPECT_EQ(left_out_distances(values, Eigen::VectorXd::Zero(10), 11), Eigen::VectorXd::Zero(11));
  EXPECT_EQ(left_out_distances({}, {}, 11), Eigen::VectorXd::Zero(1));
}

// Three shapes on a line, two of them the same: those have no mode, and the third keeps its whole distance of 3/2 |z|.
TEST(LeaveOneOut, WhereTheOthersDoNotVary) {
  const Eigen::VectorXd squares = left_out_distances(Eigen::VectorXd{{6}}, Eigen::VectorXd{{2}}, 3);
  ASSERT_EQ(squares.size(), 2);
  for (const double square : squares) EXPECT_NEAR(square, 9, 1e-12);
}

// Of equal eigenvalues, one combination of the modes holds all of the shape, and the others stay. What modes leave is
// known where the shape lies in such a plane: all, as long as its own mode is not among them, whose eigenvalue is 2 -
// 9/8 |z|^2.
TEST(LeaveOneOut, OfEqualEigenvalues) {
  constexpr Eigen::Index n = 9;
  const Eigen::VectorXd values{{5, 2, 2, 2, 1}}, z{{0, 0.6, 0.8, 0, 0}};
  const double whole = std::pow(n / (n - 1.0), 2);
  EXPECT_LE((left_out_distances(values, z, n) - Eigen::VectorXd{{whole, whole, whole, whole, whole, 0}}).norm(), 1e-13);
  EXPECT_LE((100 * left_out_distances(values, z / 10, n) - Eigen::VectorXd{{whole, whole, whole, whole, 0, 0}}).norm(),
            1e-13);
}

}  // namespace
}  // namespace shellmatch
