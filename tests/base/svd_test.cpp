// Singular values and vectors of matrices built from known ones.
#include "base/decompositions.h"

#include <gtest/gtest.h>

#include <random>

namespace shellmatch {
namespace {

template <class Matrix>
Matrix random_orthogonal(Eigen::Index n, std::mt19937& random) {
  std::normal_distribution<double> normal;
  Matrix q = Matrix::Identity(n, n);
  for (Eigen::Index k = 0; k < n; ++k) {
    Eigen::VectorXd v(n);
    for (double& entry : v) entry = normal(random);
    q -= (2 / v.squaredNorm() * (q * v) * v.transpose()).eval();
  }
  return q;
}

template <class Matrix>
void check(const Eigen::VectorXd& values) {
  const Eigen::Index n = values.size();
  std::mt19937 random(5);
  const Matrix u = random_orthogonal<Matrix>(n, random), v = random_orthogonal<Matrix>(n, random);
  const Matrix a = u * values.asDiagonal() * v.transpose(), one = Matrix::Identity(n, n);
  const Svd<Matrix> svd = jacobi_svd(a);
  const double tolerance = 1e-14 * values[0] * static_cast<double>(n);
  EXPECT_LE((svd.values - values).norm(), tolerance);
  EXPECT_LE((svd.u * svd.values.asDiagonal() * svd.v.transpose() - a).norm(), tolerance);
  EXPECT_LE((svd.u.transpose() * svd.u - one).norm(), 1e-14 * static_cast<double>(n));
  EXPECT_LE((svd.v.transpose() * svd.v - one).norm(), 1e-14 * static_cast<double>(n));
}

TEST(Svd, OfThreeRows) {
  check<Mat<3>>(Vec<3>(3, 2, 0.5));
  check<Mat<3>>(Vec<3>(1e-20, 1e-20, 0));
}

TEST(Svd, OfAnyNumberOfRows) {
  check<Eigen::MatrixXd>(Eigen::VectorXd::LinSpaced(40, 40, 1));
  check<Eigen::MatrixXd>(Eigen::VectorXd::Constant(1, 7));
}

TEST(Svd, TheNearestOrthogonalMatrixIsThatOfItsVectors) {
  std::mt19937 random(5);
  for (const double least : {1.0, 1e-3, 1e-7, 0.0}) {  // the latter by the decomposition
    const Eigen::MatrixXd u = random_orthogonal<Eigen::MatrixXd>(30, random),
                          v = random_orthogonal<Eigen::MatrixXd>(30, random);
    const Eigen::MatrixXd a = u * Eigen::VectorXd::LinSpaced(30, 5, least).asDiagonal() * v.transpose(),
                          q = nearest_orthogonal(a);
    EXPECT_LE((q.transpose() * q - Eigen::MatrixXd::Identity(30, 30)).norm(), 1e-11);
    EXPECT_NEAR((q.transpose() * a).trace(), Eigen::VectorXd::LinSpaced(30, 5, least).sum(), 1e-10);
    if (least > 1e-4) {
      EXPECT_LE((q - u * v.transpose()).norm(), 1e-9);
    }
  }
}

TEST(Svd, OfSquareMatricesOnly) {
  EXPECT_THROW(nearest_orthogonal(Eigen::MatrixXd::Ones(2, 3)), std::logic_error);
  EXPECT_THROW(jacobi_svd<Eigen::MatrixXd>(Eigen::MatrixXd::Ones(2, 3)), std::logic_error);
}

}  // namespace
}  // namespace shellmatch
