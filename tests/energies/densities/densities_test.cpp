// The densities themselves: where they vanish, what they are invariant under, their convexity and derivatives.

#include "energies/autodiff/jet.h"
#include "energies/densities/full_volume.h"
#include "energies/densities/symmetric_dirichlet.h"
#include "energies/densities/thin_shell.h"
#include "tests/energies/densities/random_matrices.h"
#include "tests/support/taylor.h"

#include <gtest/gtest.h>

namespace shellmatch {
namespace {

using namespace test;

// The densities as objects, so that one test serves all.
template <template <int> class Density>
struct Of {
  Material<double> material{1, 1};
  template <class T, int Dim>
  T operator()(const SmallMat<T, Dim>& a) const {
    return Density<Dim>::value(a, material);
  }
};
using ThinShell = Of<ThinShellDensity>;
using Extrapolated = Of<ExtrapolatedThinShellDensity>;
using FullVolume = Of<FullVolumeDensity>;
using SymmetricDirichlet = Of<SymmetricDirichletDensity>;

template <int Dim, class Density>
double value(const Density& w, const Mat<Dim>& a) {
  return w(small(a));
}

template <int Dim, class Density>
Mat<Dim> derivative(const Density& w, const Mat<Dim>& a) {
  using Jet = ceres::Jet<double, Dim * Dim>;
  SmallMat<Jet, Dim> j;
  for (int i = 0; i < Dim * Dim; ++i) j.v[i] = Jet(a(i / Dim, i % Dim), i);
  const Jet r = w(j);
  Mat<Dim> d;
  for (int i = 0; i < Dim * Dim; ++i) d(i / Dim, i % Dim) = r.v[i];
  return d;
}

// d^2/dt^2 W(A + tE) at 0, from differences of the exact first derivative.
template <int Dim, class Density>
double second_derivative(const Density& w, const Mat<Dim>& a, const Mat<Dim>& e) {
  const double t = 1e-5;
  const Mat<Dim> forward = derivative<Dim>(w, a + t * e), backward = derivative<Dim>(w, a - t * e);
  return (forward - backward).cwiseProduct(e).sum() / (2 * t);
}

template <class T>
struct Densities : ::testing::Test {};
template <int D>
struct In {
  static constexpr int dim = D;
};
using Dimensions = ::testing::Types<In<2>, In<3>>;
TYPED_TEST_SUITE(Densities, Dimensions);

const Material<double> materials[] = {{1, 1}, {0.3, 2}, {5, 0.1}};

TYPED_TEST(Densities, ThinShellVanishesAndIsStationaryOnRotations) {
  constexpr int Dim = TypeParam::dim;
  std::mt19937 random(1);
  for (const auto& lame : materials)
    for (int i = 0; i < 20; ++i) {
      const Mat<Dim> q = random_rotation<Dim>(random);
      EXPECT_NEAR(value<Dim>(ThinShell{lame}, q), 0, 1e-13);
      EXPECT_LT(derivative<Dim>(ThinShell{lame}, q).norm(), 1e-13);
    }
}

TYPED_TEST(Densities, AllAreFrameIndifferent) {
  constexpr int Dim = TypeParam::dim;
  std::mt19937 random(2);
  const auto expect_indifferent = [&](const auto& w, const Mat<Dim>& a) {
    const double expected = value<Dim>(w, a);
    const Mat<Dim> q = random_rotation<Dim>(random);
    EXPECT_NEAR(value<Dim>(w, q * a), expected, 1e-11 * (1 + std::abs(expected)));
    EXPECT_NEAR(value<Dim>(w, a * q), expected, 1e-11 * (1 + std::abs(expected)));
  };
  for (int i = 0; i < 20; ++i) {
    for (const auto& lame : materials) {
      expect_indifferent(ThinShell{lame}, random_matrix<Dim>(random));
      expect_indifferent(Extrapolated{lame}, 4 * random_matrix<Dim>(random));
    }
    const Mat<Dim> a = random_orientation_preserving<Dim>(random, 0.6, 1.7);
    expect_indifferent(FullVolume{}, a);
    expect_indifferent(SymmetricDirichlet{{1, 0.7}}, a);
  }
}

TYPED_TEST(Densities, ThinShellIsLameNavierToSecondOrder) {
  constexpr int Dim = TypeParam::dim;
  std::mt19937 random(3);
  const Mat<Dim> id = Mat<Dim>::Identity();
  for (const auto& lame : materials) {
    const auto remainder = [&](const Mat<Dim>& e, double t) {
      const Mat<Dim> s = 0.5 * (e + e.transpose());
      const double lame_navier = lame.mu * s.squaredNorm() + 0.5 * lame.lambda * e.trace() * e.trace();
      return std::abs(value<Dim>(ThinShell{lame}, id + t * e) - t * t * lame_navier);
    };
    const Mat<Dim> e = random_matrix<Dim>(random);
    EXPECT_NEAR(order_between(1e-2, remainder(e, 1e-2), 1e-3, remainder(e, 1e-3)), 3, 0.1);
    // Infinitesimal rotations cost nothing up to the fourth order.
    const Mat<Dim> skew = e - e.transpose();
    EXPECT_NEAR(order_between(1e-1, remainder(skew, 1e-1), 1e-2, remainder(skew, 1e-2)), 4, 0.2);
  }
}

// W and W_hat are polyconvex, hence convex along A + t a b^T, wherever that may lead.
TYPED_TEST(Densities, PolyconvexOnesAreConvexAlongRankOneLines) {
  constexpr int Dim = TypeParam::dim;
  std::mt19937 random(4);
  for (int i = 0; i < 200; ++i) {
    const Mat<Dim> rank_one = random_matrix<Dim, 1>(random) * random_matrix<1, Dim>(random);
    for (const auto& lame : materials) {
      EXPECT_GE(second_derivative<Dim>(ThinShell{lame}, 2 * random_matrix<Dim>(random), rank_one), -1e-7);
      EXPECT_GE(second_derivative<Dim>(Extrapolated{lame}, 4 * random_matrix<Dim>(random), rank_one), -1e-7);
    }
    const Mat<Dim> a = random_orientation_preserving<Dim>(random, 0.7, 2);
    EXPECT_GE(second_derivative<Dim>(FullVolume{}, a, rank_one), -1e-6);
  }
}

// diag(-d, 1, ..., 1) has the determinant -d.
TYPED_TEST(Densities, ExtrapolatedThinShellIsThinShellDownToMinusThreeAndAParabolaBelow) {
  constexpr int Dim = TypeParam::dim;
  const Material<double> lame{0.3, 2};
  const Extrapolated w{lame};
  const ThinShell exact{lame};
  const auto at = [](double det) {
    Mat<Dim> a = Mat<Dim>::Identity();
    a(0, 0) = det;
    return a;
  };
  Mat<Dim> along = Mat<Dim>::Zero();
  along(0, 0) = 1;
  const double k = lame.mu + 0.5 * lame.lambda, c = std::exp(4.0);
  for (const double det : {2.0, 1.0, 0.0, -1.0, -2.99}) {
    EXPECT_EQ(value<Dim>(w, at(det)), value<Dim>(exact, at(det)));
    EXPECT_EQ(derivative<Dim>(w, at(det)), derivative<Dim>(exact, at(det)));
  }
  for (const double det : {-3.01, -4.0, -9.0, -40.0}) {
    const double beyond = -3 - det;
    const double expected =
        value<Dim>(exact, at(det)) + k * (c * (1 + beyond + 0.5 * beyond * beyond) - std::exp(1 - det));
    EXPECT_NEAR(value<Dim>(w, at(det)), expected, 1e-12 * std::exp(1 - det));
    EXPECT_LT(value<Dim>(w, at(det)), value<Dim>(exact, at(det)));
    const double slope = (lame.mu + 0.5 * lame.lambda) * det - k * c * (1 + beyond);
    EXPECT_NEAR(derivative<Dim>(w, at(det))(0, 0), slope, 1e-12 * std::abs(slope));
    EXPECT_NEAR(second_derivative<Dim>(w, at(det), along), lame.mu + 0.5 * lame.lambda + k * c, 1e-4);
  }
}

// The constants of the paper, and its condition for I to be stationary.
template <int Dim>
struct FullConstants {
  static constexpr double alpha = Dim == 3 ? 1 : 2, beta = alpha, p = Dim == 3 ? 4 : 3, s = Dim == 3 ? 9 : 4;
  static inline const double gamma = Dim == 3 ? 4 : 3 * std::sqrt(2.0);
};

TYPED_TEST(Densities, FullVolumeIsThePapersAndStationaryAtRotations) {
  constexpr int Dim = TypeParam::dim;
  using C = FullConstants<Dim>;
  EXPECT_NEAR((Dim + 1) * std::pow(Dim, 0.5 * (Dim - 1)) * (C::alpha + (Dim - 1) * C::beta), Dim * Dim * C::gamma,
              1e-12);
  const auto papers = [](const Mat<Dim>& a) {
    const Mat<Dim> cof = a.determinant() * a.inverse().transpose();
    return C::alpha * std::pow(a.norm(), C::p) + C::beta * std::pow(cof.norm(), C::p) +
           C::gamma * std::pow(a.determinant(), -C::s);
  };
  const double at_identity = papers(Mat<Dim>::Identity());
  std::mt19937 random(5);
  for (int i = 0; i < 20; ++i) {
    const Mat<Dim> q = random_rotation<Dim>(random), a = random_orientation_preserving<Dim>(random, 0.6, 1.7);
    EXPECT_NEAR(value<Dim>(FullVolume{}, q), 0, 1e-12);
    EXPECT_LT(derivative<Dim>(FullVolume{}, q).norm(), 1e-11);
    EXPECT_NEAR(value<Dim>(FullVolume{}, a), papers(a) - at_identity, 1e-11 * papers(a));
    // At I: p n^(p/2-1) |E|^2 + p (p-2) n^(p/2-2) (tr E)^2 from |A|^p, for n = 3 56 (tr E)^2 from |cof A|^4,
    // and s |E|^2 + s^2 (tr E)^2 from (det A)^-s.
    const Mat<Dim> strain = random_symmetric<Dim>(random, -1, 1);
    const double squares = strain.squaredNorm(), trace2 = strain.trace() * strain.trace(), root2 = std::sqrt(2.0);
    const double hessian = Dim == 3 ? (12 + 4 * 9) * squares + (8 + 56 + 4 * 81) * trace2
                                    : (4 * 3 + 3 * 4) * root2 * squares + (6 + 3 * 16) * root2 * trace2;
    EXPECT_NEAR(second_derivative<Dim>(FullVolume{}, Mat<Dim>::Identity(), strain), hessian, 1e-4);
  }
}

TYPED_TEST(Densities, SymmetricDirichletWeighsAMatrixAndItsInverseAlike) {
  constexpr int Dim = TypeParam::dim;
  std::mt19937 random(6);
  const SymmetricDirichlet w{{1, 0.7}};
  for (int i = 0; i < 20; ++i) {
    const Mat<Dim> q = random_rotation<Dim>(random), a = random_orientation_preserving<Dim>(random, 0.4, 2.5);
    EXPECT_NEAR(value<Dim>(w, q), 0, 1e-13);
    EXPECT_LT(derivative<Dim>(w, q).norm(), 1e-12);
    EXPECT_GT(value<Dim>(w, a), 0);
    EXPECT_NEAR(value<Dim>(w, a), value<Dim>(w, a.inverse()), 1e-11 * value<Dim>(w, a));
    EXPECT_NEAR(value<Dim>(w, a), 0.35 * (0.5 * a.squaredNorm() + 0.5 * a.inverse().squaredNorm() - Dim),
                1e-11 * (1 + value<Dim>(w, a)));
    const Mat<Dim> e = random_matrix<Dim>(random), s = 0.5 * (e + e.transpose());
    EXPECT_NEAR(second_derivative<Dim>(w, Mat<Dim>::Identity(), e), 2 * 0.7 * s.squaredNorm(), 1e-8);
  }
}

TYPED_TEST(Densities, ThoseThatForbidFoldsAreNaNOrInfiniteThere) {
  constexpr int Dim = TypeParam::dim;
  std::mt19937 random(7);
  for (int i = 0; i < 20; ++i) {
    Mat<Dim> a = random_orientation_preserving<Dim>(random, 0.5, 2);
    a.col(0) = -a.col(0);
    EXPECT_TRUE(std::isnan(value<Dim>(FullVolume{}, a)));
    EXPECT_TRUE(std::isnan(value<Dim>(SymmetricDirichlet{}, a)));
    EXPECT_TRUE(std::isfinite(value<Dim>(ThinShell{}, a)));
  }
  const Mat<Dim> zero = Mat<Dim>::Zero();
  EXPECT_FALSE(std::isfinite(value<Dim>(FullVolume{}, zero)));
  EXPECT_FALSE(std::isfinite(value<Dim>(SymmetricDirichlet{}, zero)));
  EXPECT_TRUE(std::isfinite(value<Dim>(ThinShell{}, zero)));
}

TYPED_TEST(Densities, DerivativesAgreeWithTheTaylorRemainder) {
  constexpr int Dim = TypeParam::dim;
  std::mt19937 random(8);
  const auto check = [&](const auto& w) {
    const Mat<Dim> a = random_orientation_preserving<Dim>(random, 0.8, 1.5), e = random_matrix<Dim>(random);
    const double slope = derivative<Dim>(w, a).cwiseProduct(e).sum();
    const auto line = [&](double t) { return value<Dim>(w, a + t * e); };
    EXPECT_TRUE(has_derivative(line, slope));
    EXPECT_FALSE(has_derivative(line, 1.001 * slope + 1e-3));
  };
  for (const auto& lame : materials) check(ThinShell{lame});
  check(Extrapolated{});
  check(FullVolume{});
  check(SymmetricDirichlet{});
}

}  // namespace
}  // namespace shellmatch
