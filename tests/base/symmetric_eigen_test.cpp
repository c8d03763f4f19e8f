#include "base/decompositions.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <random>

namespace shellmatch {
namespace {

using Matrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

// Q diag(values) Q^T with a random orthogonal Q, the product of reflections.
Matrix with_eigenvalues(const Eigen::VectorXd& values, std::mt19937& random) {
  std::normal_distribution<double> normal;
  Matrix a = values.asDiagonal();
  for (int k = 0; k < values.size(); ++k) {
    Eigen::VectorXd v(values.size());
    for (double& entry : v) entry = normal(random);
    const Matrix reflection = Matrix::Identity(v.size(), v.size()) - 2 / v.squaredNorm() * v * v.transpose();
    a = (reflection * a * reflection).eval();
  }
  return 0.5 * (a + a.transpose());
}

template <int Dim>
void expect_eigenpairs(const Mat<Dim>& a, const Vec<Dim>& values, const Eigenpairs<Dim>& found, double tolerance) {
  EXPECT_LE((found.values - values).norm(), tolerance * values.norm());
  EXPECT_LE((found.vectors.transpose() * found.vectors - Mat<Dim>::Identity()).norm(), 1e-13);
  EXPECT_LE((a * found.vectors - found.vectors * found.values.asDiagonal()).norm(), 10 * tolerance * values.norm());
}

template <int Dim>
void check_eigenpairs() {
  std::mt19937 random(3);
  std::normal_distribution<double> normal;
  for (int i = 0; i < 200; ++i) {
    Vec<Dim> values;
    for (double& v : values) v = normal(random);
    if (i % 4 == 1) values[0] = values[1];
    if (i % 4 == 2) values[0] = 0;
    std::sort(values.begin(), values.end());
    const Mat<Dim> a = with_eigenvalues(values, random);
    expect_eigenpairs<Dim>(a, values, eigenpairs<Dim>(a), 1e-14);
  }
}

TEST(SymmetricEigen, PairsInThePlane) { check_eigenpairs<2>(); }
TEST(SymmetricEigen, PairsInSpace) { check_eigenpairs<3>(); }

TEST(SymmetricEigen, PairsOfZeroAndOfDiagonalMatrices) {
  EXPECT_EQ(eigenpairs<2>(Mat<2>::Zero()).values, Vec<2>(0, 0));
  EXPECT_EQ(eigenpairs<2>(Vec<2>(3, -1).asDiagonal()).values, Vec<2>(-1, 3));
  EXPECT_EQ(eigenpairs<3>(Vec<3>(3, -1, 2).asDiagonal()).values, Vec<3>(-1, 2, 3));
}

TEST(SymmetricEigen, NegativeEigenvaluesAreSetToZero) {
  std::mt19937 random(4);
  std::normal_distribution<double> normal;
  for (int n = 1; n <= 9; ++n)
    for (int i = 0; i < 30; ++i) {
      Eigen::VectorXd values(n);
      for (double& v : values) v = i % 3 == 0 ? std::round(normal(random)) : normal(random) * std::pow(10.0, -(i % 5));
      std::mt19937 same = random;
      Matrix a = with_eigenvalues(values, random);
      const Matrix positive = with_eigenvalues(values.cwiseMax(0.0), same);
      EXPECT_NEAR(largest_eigenvalue(n, a.data()), values.maxCoeff(), 1e-14 * n * values.norm());
      remove_negative_eigenvalues(n, a.data());
      EXPECT_LE((a - positive).norm(), 1e-14 * n * values.norm())
          << "n " << n << ", eigenvalues " << values.transpose();
    }
}

TEST(SymmetricEigen, NothingIsTheLargestEigenvalueOfWhatIsNotFinite) {
  const std::array<double, 4> matrix{1, 0, 0, std::nan("")};
  EXPECT_TRUE(std::isnan(largest_eigenvalue(2, matrix.data())));
}

}  // namespace
}  // namespace shellmatch
