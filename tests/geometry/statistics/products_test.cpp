// Products of shapes against sums written out; more columns than a tile, more rows than a block.
#include "geometry/statistics/products.h"

#include "tests/geometry/statistics/families.h"

#include <gtest/gtest.h>

namespace shellmatch {
namespace {

using testing::random_sets;
using testing::random_weights;

double product(const Eigen::VectorXd& a, const Eigen::VectorXd& b, const Eigen::VectorXd& weights, int dimension) {
  double sum = 0;
  for (Eigen::Index row = 0; row < a.size(); ++row) sum += weights[row / dimension] * a[row] * b[row];
  return sum;
}

TEST(Products, AreSumsOverThePoints) {
  for (const int dimension : {2, 3}) {
    const Eigen::MatrixXd a = random_sets(dimension, 411, 70, 1).coordinates,
                          b = random_sets(dimension, 411, 131, 2).coordinates;
    const Eigen::VectorXd weights = random_weights(411, 3), centre = a.col(5);
    const Eigen::MatrixXd plain = inner_products({a}, {b}, weights),
                          centred = inner_products({a, &centre}, {b}, weights);
    const Eigen::MatrixXd gram = gram_matrix({b, &centre}, weights);
    for (const Eigen::Index i : {0, 63, 64, 69})
      for (const Eigen::Index j : {0, 1, 64, 127, 128, 130}) {
        EXPECT_NEAR(plain(i, j), product(a.col(i), b.col(j), weights, dimension), 1e-13);
        EXPECT_NEAR(centred(i, j), product(a.col(i) - centre, b.col(j), weights, dimension), 1e-13);
        EXPECT_NEAR(gram(i, j), product(b.col(i) - centre, b.col(j) - centre, weights, dimension), 1e-13);
      }
    EXPECT_EQ(gram, gram.transpose());
  }
}

TEST(Products, Combinations) {
  const Eigen::MatrixXd a = random_sets(3, 411, 70, 1).coordinates, c = random_sets(2, 35, 9, 2).coordinates;
  const Eigen::VectorXd centre = a.col(5);
  EXPECT_LE((combinations({a, &centre}, c) - (a.colwise() - centre) * c).norm(), 1e-10);
  Eigen::MatrixXd in_place = a;
  const Eigen::MatrixXd square = random_sets(2, 35, 70, 2).coordinates;
  combine_in_place(in_place, square);
  EXPECT_LE((in_place - a * square).norm(), 1e-9);
}

// Sizes at which Eigen takes other kernels: no product, a vector, less than a register, more than a panel.
TEST(Products, CombinationsDoNotDependOnTheColumnsThatFollow) {
  for (const Eigen::Index n_sets : {2, 11, 70}) {
    const Eigen::MatrixXd a = random_sets(3, 411, n_sets, 1).coordinates,
                          c = random_sets(2, n_sets, 100, 2).coordinates;
    const Eigen::MatrixXd all = combinations({a}, c.topRows(n_sets));
    for (const Eigen::Index n : {0, 1, 2, 5, 15, 16, 17, 33, 99})
      EXPECT_EQ(combinations({a}, c.topLeftCorner(n_sets, n)), all.leftCols(n))
          << n_sets << " sets, " << n << " columns";
  }
}

TEST(Products, OnlyOfWhatFits) {
  const Eigen::MatrixXd a = Eigen::MatrixXd::Ones(6, 2), b = Eigen::MatrixXd::Ones(9, 2);
  const Eigen::VectorXd weights = uniform_weights(2);
  EXPECT_THROW(inner_products({a}, {b}, weights), std::logic_error);
  EXPECT_THROW(inner_products({a}, {a}, uniform_weights(4)), std::logic_error);
  EXPECT_THROW(combinations({a}, b), std::logic_error);
}

TEST(GramEigen, FindsWhatTheMatrixWasMadeOf) {
  const Eigen::MatrixXd random = random_sets(2, 20, 40, 4).coordinates;
  const Eigen::MatrixXd gram = random.transpose() * random;
  const Eigen::MatrixXd q = random * orthonormalising_combinations(gram);
  EXPECT_LE((q.transpose() * q - Eigen::MatrixXd::Identity(40, 40)).norm(), 1e-9);
  // The first column keeps its direction: the combinations are triangular.
  EXPECT_LE((q.col(0) - random.col(0).normalized()).norm(), 1e-12);
  Eigen::VectorXd values = Eigen::VectorXd::Zero(40);
  values.head(5) << 7, 3, 1, 1, 1e-9;
  values[5] = 1e-13;
  const GramEigen eigen = gram_eigen(q * values.asDiagonal() * q.transpose(), 0);
  ASSERT_EQ(eigen.values.size(), 5);
  EXPECT_LE((eigen.values - values.head(5)).norm(), 1e-13);
  for (const Eigen::Index k : {0, 1, 4}) EXPECT_NEAR(std::abs(eigen.vectors.col(k).dot(q.col(k))), 1, 1e-12);
  EXPECT_EQ(gram_eigen(q * values.asDiagonal() * q.transpose(), 2).values.size(), 2);
  EXPECT_EQ(gram_eigen(Eigen::MatrixXd::Zero(4, 4), 0).values.size(), 0);
}

}  // namespace
}  // namespace shellmatch
