// Second derivatives of the densities without their negative modes: by principal stretches, in closed form, and in
// general; and what they are made with.

#include "energies/densities/positive_hessian.h"

#include "energies/autodiff/jet.h"
#include "energies/autodiff/second_order.h"
#include "energies/densities/full_volume.h"
#include "energies/densities/material.h"
#include "energies/densities/symmetric_dirichlet.h"
#include "energies/densities/tangent_frames.h"
#include "energies/densities/thin_shell.h"
#include "tests/energies/densities/random_matrices.h"
#include "tests/energies/hessian/model_by_differences.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

namespace shellmatch {
namespace {

using namespace test;
using autodiff::Pack;

template <int Dim>
Mat<Dim> random_of_size(std::mt19937& random, double amplitude) {
  std::uniform_real_distribution<double> u(-amplitude, amplitude);
  return Mat<Dim>::NullaryExpr([&] { return u(random); });
}

template <class Density, int Dim>
void check_stretch_hessian(double amplitude) {
  std::mt19937 random(Dim);
  for (int trial = 0; trial < 50; ++trial) {
    // The stretches of the first are equal, where a quotient of differences becomes a derivative.
    const Mat<Dim> change = trial == 0 ? Mat<Dim>(0.1 * Mat<Dim>::Identity()) : random_of_size<Dim>(random, amplitude);
    const Mat<Dim> a = Mat<Dim>::Identity() + change;
    const Material<double> material{0.7, 1.3};
    const auto exact = positive_part(exact_hessian<Density>(small(a), material));
    SmallMat<Pack, Dim> packed;  // another matrix's entries in the other lanes
    for (int i = 0; i < Dim * Dim; ++i) {
      packed.v[i] += i % (Dim + 1) == 0 ? 1.0 + 0.1 * i : 0.02;
      packed.v[i][trial % 8] = a(i / Dim, i % Dim);
    }
    const auto model = positive_hessian<Density>(packed, material);
    double square = 0;
    for (int i = 0; i < Dim * Dim; ++i)
      for (int j = 0; j < Dim * Dim; ++j) square += std::pow(model[i][j][trial % 8] - exact(i, j), 2);
    EXPECT_LT(std::sqrt(square), 1e-6 * exact.norm());
  }
}

TEST(StretchHessian, IsThePositivePartOfTheSecondDerivative) {
  check_stretch_hessian<ThinShellDensity<2>, 2>(0.4);
  check_stretch_hessian<ThinShellDensity<3>, 3>(0.3);
  check_stretch_hessian<SymmetricDirichletDensity<2>, 2>(0.3);
  check_stretch_hessian<SymmetricDirichletDensity<3>, 3>(0.2);
  check_stretch_hessian<FullVolumeDensity<2>, 2>(0.2);
  check_stretch_hessian<FullVolumeDensity<3>, 3>(0.1);
}

template <template <int> class Density>
void check_tangent_hessian(double amplitude) {
  std::mt19937 random(7);
  const Material<double> material{0.7, 1.3};
  for (int trial = 0; trial < 100; ++trial) {
    // Far from the identity as well: the band's matrices may turn over.
    const Mat<2> y =
        random_of_size<2>(random, trial < 50 ? 0.3 : amplitude) + (trial < 50 ? 1.0 : 0.0) * Mat<2>::Identity();
    // W of Y beside a 1 differs from the plane's W by a constant: the second derivatives are the same.
    const auto exact = positive_part(exact_hessian<Density<2>>(small(y), material));
    std::array<Pack, 4> entries;
    for (int i = 0; i < 4; ++i) entries[i] = Pack{} + y(i / 2, i % 2);
    const auto model = positive_tangent_hessian<Density<3>, 3>(entries, material);
    for (int i = 0; i < 4; ++i)
      for (int j = 0; j < 4; ++j) EXPECT_NEAR(model[i][j][trial % 8], exact(i, j), 1e-9 * (1 + exact.norm()));
  }
}

TEST(TangentHessian, IsThePositivePartOfTheSecondDerivativeInTheTangentPlane) {
  check_tangent_hessian<ThinShellDensity>(2);
  check_tangent_hessian<ExtrapolatedThinShellDensity>(4);
}

TEST(TangentHessian, IsThatOfTheExtrapolationInThePlane) {
  const Material<double> material{0.7, 1.3};
  const double k = material.mu + 0.5 * material.lambda;
  for (const double det : {1.0, -1.0, -2.9, -3.1, -20.0}) {
    const auto model = positive_tangent_hessian<ExtrapolatedThinShellDensity<2>, 2>({Pack{} + det}, material);
    EXPECT_NEAR(model[0][0][3], k + k * std::exp(std::min(1 - det, 4.0)), 1e-11);
  }
}

// Semidefinite matrices of every rank, with the rounding of those who made them.
TEST(TangentHessian, FactorOfASemidefiniteMatrix) {
  std::mt19937 random(11);
  std::uniform_real_distribution<double> u(-1, 1);
  using Square = Eigen::Matrix<double, 7, 7>;
  for (int trial = 0; trial < 200; ++trial) {
    const Eigen::MatrixXd j = Eigen::MatrixXd::NullaryExpr(7, 1 + trial % 7, [&] { return u(random); });
    const Square noise = Square::NullaryExpr([&] { return 1e-10 * u(random); });
    const Square h = j * j.transpose() + noise + noise.transpose();
    std::array<std::array<Pack, 7>, 7> packed;
    for (int i = 0; i < 7; ++i)
      for (int k = 0; k < 7; ++k) packed[i][k] = Pack{} + h(i, k);
    const auto l = cholesky<7>(packed);
    Square factor;
    for (int i = 0; i < 7; ++i)
      for (int k = 0; k < 7; ++k) factor(i, k) = l[i][k][trial % 8];
    EXPECT_LT((factor * factor.transpose() - h).norm(), 2e-4 * h.norm()) << trial;
  }
}

template <int Dim>
void check_tangent_basis() {
  std::mt19937 random(3);
  for (int trial = 0; trial < 50; ++trial) {
    Vec<Dim> n = random_of_size<Dim>(random, 1).col(0).normalized();
    if (trial == 0) n = -Vec<Dim>::Unit(Dim - 1);
    std::array<Pack, Dim> packed;
    for (int k = 0; k < Dim; ++k) packed[k] = Pack{} + n[k];
    const auto t = tangent_basis<Dim>(packed);
    Mat<Dim> frame;
    for (int i = 0; i < Dim - 1; ++i)
      for (int k = 0; k < Dim; ++k) frame(k, i) = t[i][k][0];
    frame.col(Dim - 1) = n;
    EXPECT_LT((frame.transpose() * frame - Mat<Dim>::Identity()).norm(), 1e-12);
    EXPECT_NEAR(frame.determinant(), 1.0, 1e-12);
  }
}
TEST(TangentBasis, IsOrthonormalAndRightHanded) {
  check_tangent_basis<2>();
  check_tangent_basis<3>();
}

/// |A e1|^4 + det A: of no symmetry, and not convex.
template <int Dim>
struct Anisotropic {
  template <class T>
  using Argument = SmallMat<T, Dim>;
  template <class T, class P>
  static constexpr T value(const SmallMat<T, Dim>& a, const Material<P>&) {
    T along = a(0, 0) * a(0, 0);
    for (int i = 1; i < Dim; ++i) along = along + a(i, 0) * a(i, 0);
    return along * along + determinant(a);
  }
};

/// W'' by differences of the first derivative, which ceres::Jet gives.
template <class Density>
auto hessian_by_differences(const typename Density::template Argument<double>& a, const Material<double>& c) {
  constexpr int n = n_arguments_of<Density>;
  using Jet = ceres::Jet<double, n>;
  const auto gradient = [&](int moved, double by) {
    typename Density::template Argument<Jet> x;
    for (int i = 0; i < n; ++i) x.v[i] = Jet(a.v[i] + (i == moved ? by : 0.0), i);
    return Density::template value<Jet, double>(x, c).v;
  };
  const double t = 1e-5;
  Eigen::Matrix<double, n, n> h;
  for (int i = 0; i < n; ++i) h.col(i) = (gradient(i, t) - gradient(i, -t)) / (2 * t);
  return Eigen::Matrix<double, n, n>(0.5 * (h + h.transpose()));
}

/// What was seen of a density's second derivatives.
struct Seen {
  int positive = 0, indefinite = 0;
};

/// Of eight arguments at a time, each entry that of the identity (0 of a residual) plus up to `amplitude`.
template <class Density>
Seen check_positive_hessian(double amplitude, bool at_identity = true) {
  constexpr int n = n_arguments_of<Density>;
  using Hessian = Eigen::Matrix<double, n, n>;
  const int dim = n == 9 ? 3 : 2;
  const Material<double> material{0.7, 1.3};
  std::mt19937 random(n);
  std::uniform_real_distribution<double> u(-amplitude, amplitude);
  Seen seen;
  for (int trial = 0; trial < 25; ++trial) {
    std::array<typename Density::template Argument<double>, autodiff::pack_size> a;
    typename Density::template Argument<Pack> packed{};
    for (int lane = 0; lane < autodiff::pack_size; ++lane)
      for (int i = 0; i < n; ++i) {
        a[lane].v[i] = u(random) + (at_identity && i % (dim + 1) == 0 ? 1.0 : 0.0);
        packed.v[i][lane] = a[lane].v[i];
      }
    const auto found = positive_hessian<Density>(packed, material);
    for (int lane = 0; lane < autodiff::pack_size; ++lane) {
      const Hessian exact = hessian_by_differences<Density>(a[lane], material);
      if (!exact.allFinite()) continue;  // a fold
      Hessian h;
      for (int i = 0; i < n; ++i)
        for (int j = 0; j < n; ++j) h(i, j) = found[i][j][lane];
      const double size = exact.norm();
      EXPECT_LT((h - h.transpose()).norm(), 1e-12 * size);
      EXPECT_GT(least_eigenvalue(h), -1e-10 * size);
      const double least = least_eigenvalue(exact);
      ++(least >= 0 ? seen.positive : seen.indefinite);
      EXPECT_LT((h - (least >= 0 ? exact : Hessian(positive_part(exact)))).norm(), 1e-6 * size)
          << (least >= 0 ? "W''" : "its positive part");
    }
  }
  return seen;
}

// By stretches, in closed form, and by eigenvalues of the whole.
TEST(PositiveHessian, IsThatOfEveryDensityWhereItIsPositiveAndItsPositivePartElsewhere) {
  const auto expect_both = [](const Seen& seen) {
    EXPECT_GT(seen.positive, 5);
    EXPECT_GT(seen.indefinite, 5);
  };
  expect_both(check_positive_hessian<ThinShellDensity<2>>(0.5));
  expect_both(check_positive_hessian<ThinShellDensity<3>>(0.3));
  expect_both(check_positive_hessian<ExtrapolatedThinShellDensity<3>>(0.3));
  expect_both(check_positive_hessian<SymmetricDirichletDensity<2>>(0.3));
  expect_both(check_positive_hessian<SymmetricDirichletDensity<3>>(0.2));
  expect_both(check_positive_hessian<FullVolumeDensity<2>>(0.3));
  expect_both(check_positive_hessian<FullVolumeDensity<3>>(0.2));
  EXPECT_EQ(check_positive_hessian<SquareDensity<3>>(1, false).positive, 200);
  EXPECT_GT(check_positive_hessian<Anisotropic<2>>(0.5).indefinite, 5);
  EXPECT_GT(check_positive_hessian<Anisotropic<3>>(0.5).indefinite, 5);
  EXPECT_GT((check_positive_hessian<detail::OnTangentMaps<SymmetricDirichletDensity<3>, 3>>(0.2).positive), 5);
}

TEST(PositiveHessian, LargestSecondDerivativeAtRest) {
  const Material<double> material{0.7, 1.3};
  EXPECT_NEAR(largest_second_derivative<ThinShellDensity<2>>(material), 2 * 1.3 + 2 * 0.7, 1e-12);
  EXPECT_NEAR(largest_second_derivative<ThinShellDensity<3>>(material), 2 * 1.3 + 3 * 0.7, 1e-12);
  EXPECT_NEAR(largest_second_derivative<SymmetricDirichletDensity<2>>(material), 2 * 1.3, 1e-12);
  EXPECT_NEAR(largest_second_derivative<SymmetricDirichletDensity<3>>(material), 2 * 1.3, 1e-12);
  EXPECT_NEAR(largest_second_derivative<SquareDensity<4>>(material), 2, 1e-12);
}

// By their closed forms, along x + 2 y.
TEST(SecondOrder, LogarithmAndPowersHaveTheirDerivatives) {
  using Scalar = autodiff::SecondOrder<2, Pack>;
  const Pack x0{0.1, 0.5, 1, 1.5, 2, 3, 5, 8}, y0 = Pack{} + 0.25;
  const Scalar u = Scalar::variable(x0, 0) + 2.0 * Scalar::variable(y0, 1);
  const Scalar logarithm = log(u), power = pow(u, -1.5), cube = pow(-u, 3.0);
  for (int lane = 0; lane < autodiff::pack_size; ++lane) {
    const double t = x0[lane] + 0.5;
    const auto expect = [&](const Scalar& s, double f, double f1, double f2) {
      const double error = 1e-14 * (std::abs(f) + std::abs(f1) + std::abs(f2));
      EXPECT_NEAR(s.v[lane], f, error);
      EXPECT_NEAR(s.g[0][lane], f1, error);
      EXPECT_NEAR(s.g[1][lane], 2 * f1, 2 * error);
      EXPECT_NEAR(s.h(0, 0)[lane], f2, error);
      EXPECT_NEAR(s.h(0, 1)[lane], 2 * f2, 2 * error);
      EXPECT_NEAR(s.h(1, 1)[lane], 4 * f2, 4 * error);
    };
    expect(logarithm, std::log(t), 1 / t, -1 / (t * t));
    expect(power, std::pow(t, -1.5), -1.5 * std::pow(t, -2.5), 3.75 * std::pow(t, -3.5));
    expect(cube, -t * t * t, -3 * t * t, -6 * t);
  }
}

// max_of takes value and both derivatives of the larger one, lane by lane, and of the second where they are equal.
TEST(SecondOrder, MaximumHasTheDerivativesOfTheLargerOne) {
  using Scalar = autodiff::SecondOrder<2, Pack>;
  const Pack x0{-2, -1, -0.5, 0, 0.5, 1, 2, 3};
  const Scalar x = Scalar::variable(x0, 0), y = Scalar::variable(Pack{} + 1.0, 1);
  const Scalar larger = max_of(x * x * y, 2.0 * y + x * (y - 1.0));  // x^2 y or 2 y + x (y - 1), at y = 1
  for (int lane = 0; lane < autodiff::pack_size; ++lane) {
    const double v = x0[lane];
    const bool first = v * v > 2;
    EXPECT_EQ(larger.v[lane], first ? v * v : 2);
    EXPECT_EQ(larger.g[0][lane], first ? 2 * v : 0);
    EXPECT_EQ(larger.g[1][lane], first ? v * v : 2 + v);
    EXPECT_EQ(larger.h(0, 0)[lane], first ? 2 : 0);
    EXPECT_EQ(larger.h(0, 1)[lane], first ? 2 * v : 1);
    EXPECT_EQ(larger.h(1, 1)[lane], 0);
  }
  const auto tie = max_of(autodiff::SecondOrder<2>::variable(1, 0), autodiff::SecondOrder<2>::variable(1, 1));
  EXPECT_EQ(tie.g[0], 0);
  EXPECT_EQ(tie.g[1], 1);
}

}  // namespace
}  // namespace shellmatch
