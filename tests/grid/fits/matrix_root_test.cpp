#include "grid/fits/matrix_root.h"

#include "grid/fits/classification.h"
#include "tests/grid/test_grids.h"

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <gtest/gtest.h>

#include <algorithm>

namespace shellmatch {
namespace {

template <int Dim>
Mat<Dim> random_rotation(std::mt19937& random) {
  if constexpr (Dim == 2) return Eigen::Rotation2Dd(6.3 * test::random_point<2>(random)[0]).toRotationMatrix();
  else {
    Eigen::Quaterniond q;
    q.coeffs().head<3>() = test::random_point<3>(random, -1, 1);
    q.coeffs()[3] = test::random_point<3>(random, -1, 1)[0];
    return q.normalized().toRotationMatrix();
  }
}

template <int Dim>
Mat<Dim> turned(const Mat<Dim>& q, const Vec<Dim>& values) {
  const Mat<Dim> a = q * values.asDiagonal() * q.transpose();
  return 0.5 * (a + a.transpose());
}

// Against the root that is known by construction. The error may grow with the condition number and, within the
// formula's range, with the inverse of the determinant.
template <int Dim>
void expect_roots(const Mat<Dim>& q, const Vec<Dim>& values) {
  const double condition = values.maxCoeff() / values.minCoeff(), determinant = (values / values.mean()).prod();
  const double rounding = 4e-15 * std::max(condition, std::min(1 / determinant, 1e6));
  const Mat<Dim> a = turned<Dim>(q, values);
  const Mat<Dim> root = turned<Dim>(q, values.cwiseSqrt()), inverse = turned<Dim>(q, values.cwiseSqrt().cwiseInverse());
  ASSERT_LE((franca_root<Dim>(a) - root).norm(), rounding * root.norm()) << values.transpose();
  ASSERT_LE((franca_inverse_root<Dim>(a) - inverse).norm(), 3 * rounding * inverse.norm()) << values.transpose();
}

template <class D>
class MatrixRoot : public testing::Test {};
using Dims = testing::Types<std::integral_constant<int, 2>, std::integral_constant<int, 3>>;
TYPED_TEST_SUITE(MatrixRoot, Dims);

TYPED_TEST(MatrixRoot, RandomMatrices) {
  constexpr int Dim = TypeParam::value;
  std::mt19937 random(1);
  for (int i = 0; i < 2000; ++i) {
    Vec<Dim> values = test::random_point<Dim>(random, -1.5, 1.5);
    for (double& v : values) v = std::pow(10.0, v + i % 7 - 3);
    expect_roots<Dim>(random_rotation<Dim>(random), values);
  }
}

// Where two or all eigenvalues agree, or nearly so, the formula loses nothing.
TYPED_TEST(MatrixRoot, EqualAndNearlyEqualEigenvalues) {
  constexpr int Dim = TypeParam::value;
  std::mt19937 random(2);
  for (int i = 0; i < 200; ++i)
    for (const double gap : {0.0, 1e-16, 1e-12, 1e-9, 1e-6, 1e-3})
      for (const double third : {0.01, 0.999999, 1.0, 1 + 1e-9, 40.0}) {
        Vec<Dim> values = Vec<Dim>::Constant(third);
        values[0] = 1;
        values[1] = 1 + gap;
        expect_roots<Dim>(random_rotation<Dim>(random), 7.3 * values);
      }
}

// Beyond the formula's reach the eigendecomposition takes over, with no jump between them.
TYPED_TEST(MatrixRoot, NearlySingularMatrices) {
  constexpr int Dim = TypeParam::value;
  std::mt19937 random(3);
  for (int i = 0; i < 200; ++i)
    for (double small = 1e-3; small > 1e-14; small *= 0.1) {
      Vec<Dim> values = Vec<Dim>::Constant(small);
      values[Dim - 1] = 2;
      expect_roots<Dim>(random_rotation<Dim>(random), values);
      values[Dim - 2] = 0.7;
      expect_roots<Dim>(random_rotation<Dim>(random), values);
    }
}

TYPED_TEST(MatrixRoot, RefusesWhatIsNotPositiveDefinite) {
  constexpr int Dim = TypeParam::value;
  const Mat<Dim> one = Mat<Dim>::Identity();
  EXPECT_THROW(franca_root<Dim>(Mat<Dim>::Zero()), std::logic_error);
  EXPECT_THROW(franca_root<Dim>(-one), std::logic_error);
  Mat<Dim> a = one;
  a(0, 0) = -0.1;
  EXPECT_THROW(franca_root<Dim>(a), std::logic_error);
  a(1, 1) = -0.1;  // in space: the determinant is positive again
  if (Dim == 3) a(2, 2) = 3;
  EXPECT_THROW(franca_root<Dim>(a), std::logic_error);
  a(0, 0) = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(franca_root<Dim>(a), std::logic_error);
}

TYPED_TEST(MatrixRoot, ClassifiedPowersAgree) {
  constexpr int Dim = TypeParam::value;
  std::mt19937 random(5);
  for (int i = 0; i < 500; ++i) {
    const Mat<Dim> q = random_rotation<Dim>(random);
    const Mat<Dim> s = turned<Dim>(q, test::random_point<Dim>(random, -30, 30));
    Classifier c{.kind = i % 2 ? Classification::absolute : Classification::shift, .tau = 1, .cap = 0, .shift = 31};
    for (const double exponent : {0.5, -0.5}) {
      c.root = RootMethod::eigen;
      const Mat<Dim> by_eigen = classified_power<Dim>(s, c, exponent);
      c.root = RootMethod::franca;
      ASSERT_LE((classified_power<Dim>(s, c, exponent) - by_eigen).norm(), 1e-12 * by_eigen.norm());
    }
  }
}

}  // namespace
}  // namespace shellmatch
