// What the paper proves or shows by example, on the terms themselves where they can say it.

#include "energies/densities/thin_shell.h"
#include "energies/terms/bending.h"
#include "energies/terms/extrapolated_bending.h"
#include "energies/terms/match.h"
#include "energies/terms/membrane.h"
#include "energies/terms/simplified_volume.h"
#include "tests/energies/densities/random_matrices.h"
#include "tests/energies/terms/band_density.h"

#include <gtest/gtest.h>

namespace shellmatch {
namespace {

using namespace test;

template <int Dim>
Mat<Dim> projection(const Vec<Dim>& n) {
  return Mat<Dim>::Identity() - n * n.transpose();
}

// Everything lemma:MN speaks of: bases whose last vector is the normal, the tangential blocks of M and N, and the
// tangential block of A, which satisfies A P1 = P2 A.
template <int Dim>
struct LemmaData {
  static constexpr int T = Dim - 1;
  Mat<Dim> basis1, basis2;
  Mat<T> m, n;
  Vec<Dim> n1() const { return basis1.col(T); }
  Vec<Dim> n2() const { return basis2.col(T); }
  Mat<Dim> embed(const Mat<Dim>& left, const Mat<T>& block, const Mat<Dim>& right) const {
    return left.template leftCols<T>() * block * right.template leftCols<T>().transpose();
  }
  Mat<Dim> full_m() const { return embed(basis1, m, basis1) + n1() * n1().transpose(); }
  Mat<Dim> full_n() const { return embed(basis2, n, basis2) + n2() * n2().transpose(); }

  explicit LemmaData(std::mt19937& random)
      : basis1(random_rotation<Dim>(random)),
        basis2(random_rotation<Dim>(random)),
        m(random_symmetric<T>(random, 0.3, 4)),
        n(random_symmetric<T>(random, 0.3, 4)) {}

  // |A^T P2 N P2 A - P1 M P1|
  double mismatch(const Mat<Dim>& a) const {
    const Mat<Dim> p1 = projection<Dim>(n1()), p2 = projection<Dim>(n2());
    return (a.transpose() * p2 * full_n() * p2 * a - p1 * full_m() * p1).norm();
  }
  Mat<Dim> lambda(const Mat<Dim>& a) const {
    const Mat<Dim> p1 = projection<Dim>(n1()), p2 = projection<Dim>(n2());
    return p2 * power<Dim>(full_n(), 0.5) * p2 * a * p1 * power<Dim>(full_m(), -0.5) * p1 + n2() * n1().transpose();
  }
  // The bending term's density, as the program computes it.
  double density(const Mat<Dim>& a) const {
    const Mat<Dim> p1 = projection<Dim>(n1());
    const TargetPoint<Dim, double> y{0, small<Dim>(n2()), small_symmetric<Dim>(power<Dim>(full_n(), 0.5))};
    const ReferencePoint<Dim, double> x{0, small<Dim>(n1()),
                                        small_symmetric<Dim>(p1 * power<Dim>(full_m(), -0.5) * p1)};
    return band_density<Bending<Dim>>(y, small(a), x, Material<double>{1, 1});
  }
};

template <int Dim>
void check_lemma(unsigned seed) {
  std::mt19937 random(seed);
  int n_bad = 0;
  for (int i = 0; i < 50; ++i) {
    const LemmaData<Dim> d(random);
    constexpr int T = Dim - 1;
    const Mat<Dim> normal_part = random_matrix<1>(random)(0, 0) * d.n2() * d.n1().transpose();
    // Curvatures carried over by N^{-1/2} Q M^{1/2}: Lambda is orthogonal, and a rotation if Q is.
    const Mat<T> q = random_rotation<T>(random);
    const Mat<T> carried = power<T>(d.n, -0.5) * q * power<T>(d.m, 0.5);
    const Mat<Dim> good = d.embed(d.basis2, carried, d.basis1) + normal_part;
    EXPECT_LT(d.mismatch(good), 1e-12);
    EXPECT_LT((d.lambda(good).transpose() * d.lambda(good) - Mat<Dim>::Identity()).norm(), 1e-12);
    EXPECT_NEAR(d.density(good), 0, 1e-12);
    // And neither holds, nor is there energy 0, for any other tangential block.
    const Mat<Dim> bad = d.embed(d.basis2, carried + 0.3 * random_matrix<T>(random), d.basis1) + normal_part;
    if (d.mismatch(bad) < 1e-3) continue;
    ++n_bad;
    EXPECT_GT((d.lambda(bad).transpose() * d.lambda(bad) - Mat<Dim>::Identity()).norm(), 1e-5);
    EXPECT_GT(d.density(bad), 0);
    EXPECT_NEAR(d.density(bad), ThinShellDensity<Dim>::value(small(d.lambda(bad)), Material<double>{1, 1}), 1e-11);
  }
  EXPECT_GT(n_bad, 40);
}

TEST(Theory, LambdaIsOrthogonalExactlyWhereCurvaturesMatch) {
  check_lemma<2>(1);
  check_lemma<3>(2);
}

// The integrands are the formulas of the paper, written with Eigen; n2 need not come as a unit vector.
template <int Dim>
void check_formulas(unsigned seed) {
  std::mt19937 random(seed);
  const Material<double> material{0.7, 1.3};
  for (int i = 0; i < 20; ++i) {
    const Vec<Dim> n1 = random_matrix<Dim, 1>(random).normalized(), n2 = random_matrix<Dim, 1>(random).normalized();
    const Mat<Dim> dphi = random_matrix<Dim>(random), root = random_symmetric<Dim>(random, 0.5, 2);
    const Mat<Dim> p1 = projection<Dim>(n1), p2 = projection<Dim>(n2);
    const Mat<Dim> r1 = p1 * random_symmetric<Dim>(random, 0.5, 2) * p1;
    const TargetPoint<Dim, double> y{0.3, small<Dim>(0.8 * n2), small_symmetric<Dim>(root)};
    const ReferencePoint<Dim, double> x{-0.1, small<Dim>(n1), small_symmetric<Dim>(r1)};
    const auto w = [&](const Mat<Dim>& a) { return ThinShellDensity<Dim>::value(small(a), material); };
    const Mat<Dim> nn = n2 * n1.transpose();
    EXPECT_NEAR(band_density<Match<Dim>>(y, small(dphi), x, material), 0.16, 1e-15);
    EXPECT_NEAR(band_density<Membrane<Dim>>(y, small(dphi), x, material), w(p2 * dphi * p1 + nn), 1e-13);
    EXPECT_NEAR(band_density<Bending<Dim>>(y, small(dphi), x, material), w(p2 * root * p2 * dphi * r1 + nn), 1e-12);
    const Mat<Dim> large = 5 * dphi, of_large = p2 * root * p2 * large * r1 + nn;
    EXPECT_NEAR(band_density<ExtrapolatedBending<Dim>>(y, small(large), x, material),
                ExtrapolatedThinShellDensity<Dim>::value(small(of_large), material), 1e-9);
    EXPECT_EQ(SimplifiedVolume<Dim>::Density::value(small(dphi), material), w(dphi));
  }
}

TEST(Theory, IntegrandsAreTheFormulas) {
  check_formulas<2>(1);
  check_formulas<3>(2);
}

// Figure fig:detDtt: for the identity the extended tangential derivative has determinant n1.n2.
TEST(Theory, ExtendedTangentialDerivativeOfTheIdentityDegenerates) {
  const auto determinant_at = []<int Dim>(const Vec<Dim>& n1, const Vec<Dim>& n2) {
    return (projection<Dim>(n2) * projection<Dim>(n1) + n2 * n1.transpose()).determinant();
  };
  EXPECT_NEAR((determinant_at.operator()<2>(Vec<2>(1, 0), Vec<2>(0, 1))), 0, 1e-15);
  EXPECT_NEAR((determinant_at.operator()<2>(Vec<2>(1, 0), Vec<2>(-0.6, 0.8))), -0.6, 1e-15);
  // W stays finite there: the matrix is e2 e1^T, of norm 1 and determinant 0.
  EXPECT_NEAR(band_density<Membrane<2>>(
                  TargetPoint<2, double>{0, small<2>(Vec<2>(0, 1)), {}}, small<double, 2>(Mat<2>::Identity()),
                  ReferencePoint<2, double>{0, small<2>(Vec<2>(1, 0)), {}}, Material<double>{1, 1}),
              0.5 + 1.5 * std::exp(1.0) - 2.75, 1e-14);
  std::mt19937 random(3);
  for (int i = 0; i < 20; ++i) {
    const Vec<3> n1 = random_matrix<3, 1>(random).normalized(), n2 = random_matrix<3, 1>(random).normalized();
    EXPECT_NEAR((determinant_at.operator()<3>(n1, n2)), n1.dot(n2), 1e-14);
  }
}

}  // namespace
}  // namespace shellmatch
