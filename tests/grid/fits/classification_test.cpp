#include "grid/fits/classification.h"

#include "tests/grid/test_grids.h"

#include <gtest/gtest.h>
#include <Eigen/Geometry>

namespace shellmatch {
namespace {

template <int Dim>
Mat<Dim> random_symmetric(std::mt19937& random, double size) {
  Mat<Dim> a;
  for (int i = 0; i < Dim; ++i) a.col(i) = test::random_point<Dim>(random, -size, size);
  return 0.5 * (a + a.transpose());
}

template <class D>
class ClassificationTest : public testing::Test {};
using Dims = testing::Types<std::integral_constant<int, 2>, std::integral_constant<int, 3>>;
TYPED_TEST_SUITE(ClassificationTest, Dims);

TYPED_TEST(ClassificationTest, RootsAreRootsAndInverseRootsTheirInverse) {
  constexpr int Dim = TypeParam::value;
  std::mt19937 random(1);
  const Classifier c{.kind = Classification::absolute, .tau = 0.7, .cap = 50, .shift = 0};
  for (int i = 0; i < 300; ++i) {
    const Mat<Dim> s = random_symmetric<Dim>(random, std::pow(10.0, i % 4 - 1));
    const Mat<Dim> whole = classified_power<Dim>(s, c, 1), root = classified_power<Dim>(s, c, 0.5),
                   inverse = classified_power<Dim>(s, c, -0.5);
    ASSERT_LE((root * root - whole).norm(), 1e-12 * whole.norm());
    ASSERT_LE((root * inverse - Mat<Dim>::Identity()).norm(), 1e-12);
    ASSERT_LE((root - root.transpose()).norm(), 1e-13 * root.norm());
    ASSERT_LE((whole * s - s * whole).norm(), 1e-10 * whole.norm() * s.norm()) << "they share their eigenvectors";
  }
}

TYPED_TEST(ClassificationTest, PositiveMatricesAboveTauStayWhatTheyAre) {
  constexpr int Dim = TypeParam::value;
  std::mt19937 random(2);
  const Classifier c{.kind = Classification::absolute, .tau = 1, .cap = 0, .shift = 0};
  for (int i = 0; i < 100; ++i) {
    const Mat<Dim> a = random_symmetric<Dim>(random, 2);
    const Mat<Dim> s = a * a + 1.01 * Mat<Dim>::Identity();
    ASSERT_LE((classified_power<Dim>(s, c, 1) - s).norm(), 1e-12 * s.norm());
    ASSERT_LE((classified_power<Dim>(-s, c, 1) - s).norm(), 1e-12 * s.norm()) << "the sign is lost";
  }
}

TYPED_TEST(ClassificationTest, RotatesWithItsArgument) {
  constexpr int Dim = TypeParam::value;
  std::mt19937 random(3);
  const Classifier c{.kind = Classification::absolute, .tau = 1, .cap = 4, .shift = 0};
  for (int i = 0; i < 100; ++i) {
    const Mat<Dim> s = random_symmetric<Dim>(random, 6);
    Mat<Dim> q = Mat<Dim>::Identity();
    q.template topLeftCorner<2, 2>() = Eigen::Rotation2Dd(0.1 * i).toRotationMatrix();
    const Mat<Dim> turned = q * s * q.transpose();
    ASSERT_LE((classified_power<Dim>(turned, c, 0.5) - q * classified_power<Dim>(s, c, 0.5) * q.transpose()).norm(),
              1e-12);
  }
}

TYPED_TEST(ClassificationTest, ShiftAddsAMultipleOfTheIdentity) {
  constexpr int Dim = TypeParam::value;
  std::mt19937 random(4);
  const Classifier c{.kind = Classification::shift, .tau = 1, .cap = 0, .shift = 30};
  const Mat<Dim> s = random_symmetric<Dim>(random, 5);
  EXPECT_LE((classified_power<Dim>(s, c, 1) - s - 30 * Mat<Dim>::Identity()).norm(), 1e-12);
  const Classifier too_small{.kind = Classification::shift, .tau = 1, .cap = 0, .shift = 0};
  EXPECT_THROW(classified_power<Dim>(-Mat<Dim>::Identity(), too_small, 0.5), std::logic_error);
}

// [lemma:MN] asks for M = P M P + n n^T.
TYPED_TEST(ClassificationTest, ExtendedShapeOperatorHasTheBlockStructure) {
  constexpr int Dim = TypeParam::value;
  std::mt19937 random(5);
  for (int i = 0; i < 100; ++i) {
    const Vec<Dim> n = (test::random_point<Dim>(random, -1, 1)).normalized();
    const Mat<Dim> s = extended_shape_operator<Dim>(random_symmetric<Dim>(random, 5), n);
    const Mat<Dim> p = Mat<Dim>::Identity() - n * n.transpose();
    ASSERT_LE((s * n - n).norm(), 1e-13);
    ASSERT_LE((p * s * p + n * n.transpose() - s).norm(), 1e-13);
    const Classifier c{.kind = Classification::absolute, .tau = 1, .cap = 0, .shift = 0};
    ASSERT_LE((classified_power<Dim>(s, c, 0.5) * n - n).norm(), 1e-12) << "with tau up to 1 C keeps it";
  }
}

TYPED_TEST(ClassificationTest, TangentialPartSufficesForExtendedShapeOperators) {
  constexpr int Dim = TypeParam::value;
  std::mt19937 random(6);
  for (const Classification kind : {Classification::absolute, Classification::shift})
    for (int i = 0; i < 200; ++i) {
      // Normals along the axes, too, where the choice of the tangents changes.
      const Vec<Dim> n = i < 2 * Dim ? Vec<Dim>((i % 2 == 0 ? 1 : -1) * Vec<Dim>::Unit(i / 2))
                                     : test::random_point<Dim>(random, -1, 1).normalized();
      const Mat<Dim> s = extended_shape_operator<Dim>(random_symmetric<Dim>(random, i % 3 == 0 ? 0 : 8), n);
      const Classifier c{.kind = kind, .tau = 0.5, .cap = 6, .shift = 7};
      for (const double exponent : {1.0, 0.5, -0.5}) {
        const Mat<Dim> expected = classified_power<Dim>(s, c, exponent);
        ASSERT_LE((classified_power<Dim>(s, n, c, exponent) - expected).norm(), 1e-13 * expected.norm())
            << n.transpose();
      }
    }
  const Classifier too_small{.kind = Classification::shift, .tau = 1, .cap = 0, .shift = -2};
  EXPECT_THROW(classified_power<Dim>(Mat<Dim>::Identity(), Vec<Dim>::Unit(0), too_small, 0.5), std::logic_error);
}

TEST(Classification, TruncatesAndCaps) {
  const Classifier c{.kind = Classification::absolute, .tau = 1, .cap = 8, .shift = 0};
  EXPECT_EQ(c(0.2), 1);
  EXPECT_EQ(c(-0.2), 1);
  EXPECT_EQ(c(3), 3);
  EXPECT_EQ(c(-3), 3);
  EXPECT_EQ(c(100), 8);
  EXPECT_EQ(c(-100), 8);
}

TEST(Classification, NoHarmFromEqualEigenvalues) {
  const Classifier c{.kind = Classification::absolute, .tau = 1, .cap = 0, .shift = 0};
  Mat<3> s = 4 * Mat<3>::Identity();
  s(0, 1) = s(1, 0) = 1e-13;
  EXPECT_LE((classified_power<3>(s, c, 0.5) - 2 * Mat<3>::Identity()).norm(), 1e-12);
}

}  // namespace
}  // namespace shellmatch
