// The terms that the paper argues against: their formulas, and where convexity fails them.

#include "energies/densities/thin_shell.h"
#include "energies/terms/list.h"
#include "tests/energies/densities/random_matrices.h"
#include "tests/energies/terms/band_density.h"

#include <gtest/gtest.h>

namespace shellmatch {
namespace {

using namespace test;

constexpr Material<double> unit{1, 1};

template <int Dim>
TargetPoint<Dim, double> target_point(const Vec<Dim>& n2, const Mat<Dim>& root = Mat<Dim>::Zero()) {
  return {0, small<Dim>(n2), small_symmetric<Dim>(root)};
}
template <int Dim>
ReferencePoint<Dim, double> reference_point(const Vec<Dim>& n1, const Mat<Dim>& r1 = Mat<Dim>::Zero()) {
  return {0, small<Dim>(n1), small_symmetric<Dim>(r1)};
}
template <int Dim>
Mat<Dim> tangential_projection(const Vec<Dim>& n) {
  return Mat<Dim>::Identity() - n * n.transpose();
}

template <int Dim>
void check_variants(unsigned seed) {
  std::mt19937 random(seed);
  const Material<double> material{0.7, 1.3};
  for (int i = 0; i < 20; ++i) {
    const Vec<Dim> n1 = random_matrix<Dim, 1>(random).normalized(), n2 = random_matrix<Dim, 1>(random).normalized();
    const Mat<Dim> dphi = random_matrix<Dim>(random), p1 = tangential_projection<Dim>(n1);
    const Mat<Dim> at2 = random_symmetric<Dim>(random, -1, 2), at1 = random_symmetric<Dim>(random, -1, 2);
    const auto y = target_point<Dim>(0.8 * n2, at2);  // n2 need not come as a unit vector
    const auto x = reference_point<Dim>(n1, at1);
    const auto w = [&](const Mat<Dim>& a) { return ThinShellDensity<Dim>::value(small(a), material); };
    const Mat<Dim> nn = n2 * n1.transpose(), flat = dphi * p1;
    EXPECT_NEAR(band_density<MembraneWithoutP2<Dim>>(y, small(dphi), x, material), w(flat + nn), 1e-12);
    EXPECT_NEAR(band_density<CauchyGreenMembrane<Dim>>(y, small(dphi), x, material),
                w(flat.transpose() * flat + n1 * n1.transpose()), 1e-12);
    EXPECT_NEAR(band_density<BendingWithoutP2<Dim>>(y, small(dphi), x, material), w(at2 * dphi * at1 + nn), 1e-11);
    EXPECT_NEAR(band_density<QuadraticBending<Dim>>(y, small(dphi), x, material),
                (dphi.transpose() * at2 * dphi - at1).squaredNorm(), 1e-12);
  }
}

TEST(Comparison, IntegrandsAreTheFormulas) {
  check_variants<2>(1);
  check_variants<3>(2);
}

// Example ex:norank1conv: F convex in trace and determinant of the Cauchy-Green tensor is not enough.
TEST(Comparison, CauchyGreenMembraneIsNotRankOneConvex) {
  const Vec<2> e2(0, 1);
  const auto on_segment = [](double l) {
    Mat<2> b;
    b << l, 0, 1 - l, 0;
    return b;
  };
  const auto wf = [&](double l) {
    const Mat<2> c = on_segment(l).transpose() * on_segment(l);
    const double a = c.trace(), det = (c + e2 * e2.transpose()).determinant();
    return 0.5 * a + 0.5 * det + 1 / det - 2;
  };
  EXPECT_NEAR(wf(0), 0, 1e-15);
  EXPECT_NEAR(wf(1), 0, 1e-15);
  EXPECT_NEAR(wf(0.5), 0.5, 1e-15);
  // The program's W in the place of F: zero at both ends, W(diag(1/2, 1)) = 5/8 + 1/16 + 3/2 e^(1/2) - 11/4
  // between.
  const auto naive = [&](double l) {
    return band_density<CauchyGreenMembrane<2>>(target_point<2>(e2), small(on_segment(l)), reference_point<2>(e2),
                                                unit);
  };
  EXPECT_NEAR(naive(0), 0, 1e-14);
  EXPECT_NEAR(naive(1), 0, 1e-14);
  EXPECT_NEAR(naive(0.5), 0.625 + 0.0625 + 1.5 * std::exp(0.5) - 2.75, 1e-14);
  EXPECT_NEAR(band_density<CauchyGreenMembrane<2>>(target_point<2>(e2), small<double, 2>(Mat<2>::Identity()),
                                                   reference_point<2>(e2), unit),
              0, 1e-14);
}

// The terms of the model are convex along every rank-one line; so is W with P2 left out, as long as n2 stays.
template <int Dim>
void check_rank_one_convexity(unsigned seed) {
  std::mt19937 random(seed);
  int naive_fails = 0, quadratic_fails = 0;
  for (int i = 0; i < 500; ++i) {
    const Vec<Dim> n1 = random_matrix<Dim, 1>(random).normalized(), n2 = random_matrix<Dim, 1>(random).normalized();
    const Mat<Dim> p1 = tangential_projection<Dim>(n1), p2 = tangential_projection<Dim>(n2);
    const Mat<Dim> root = p2 * random_symmetric<Dim>(random, 0.5, 2) * p2 + n2 * n2.transpose();
    const auto y = target_point<Dim>(n2, root);
    const auto x = reference_point<Dim>(n1, p1 * random_symmetric<Dim>(random, 0.5, 2) * p1);
    const auto curved = target_point<Dim>(n2, p2), flat = reference_point<Dim>(n1, p1);
    const Mat<Dim> a = random_matrix<Dim>(random);
    const Mat<Dim> line = random_matrix<Dim, 1>(random) * random_matrix<Dim, 1>(random).transpose();
    const auto excess = [&](auto&& density) {
      return density(small<double, Dim>(a)) -
             0.5 * (density(small<double, Dim>(a - line)) + density(small<double, Dim>(a + line)));
    };
    EXPECT_LE(excess([&](const auto& m) { return band_density<Membrane<Dim>>(y, m, x, unit); }), 1e-12);
    EXPECT_LE(excess([&](const auto& m) { return band_density<Bending<Dim>>(y, m, x, unit); }), 1e-11);
    EXPECT_LE(excess([&](const auto& m) { return band_density<MembraneWithoutP2<Dim>>(y, m, x, unit); }), 1e-12);
    EXPECT_LE(excess([&](const auto& m) { return band_density<BendingWithoutP2<Dim>>(y, m, x, unit); }), 1e-11);
    naive_fails += excess([&](const auto& m) { return band_density<CauchyGreenMembrane<Dim>>(y, m, x, unit); }) > 1e-3;
    quadratic_fails +=
        excess([&](const auto& m) { return band_density<QuadraticBending<Dim>>(curved, m, flat, unit); }) > 1e-3;
  }
  EXPECT_GT(naive_fails, 10);
  EXPECT_GT(quadratic_fails, 10);
}

TEST(Comparison, ConvexityOnRandomRankOneLines) {
  check_rank_one_convexity<2>(3);
  check_rank_one_convexity<3>(4);
}

// Section 3.2: S1 = S2 = P(e_n), the segment from I - 3/4 e1 e1^T to I - 1/2 e1 e1^T; ((1 - t)^2 - 1)^2
// there.
TEST(Comparison, QuadraticBendingIsNotConvexOnThePapersSegment) {
  const Vec<3> e3 = Vec<3>::UnitZ();
  const auto density = [&](double t) {
    const Mat<3> a = Mat<3>::Identity() - t * Vec<3>::UnitX() * Vec<3>::UnitX().transpose();
    return band_density<QuadraticBending<3>>(target_point<3>(e3, tangential_projection<3>(e3)), small(a),
                                             reference_point<3>(e3, tangential_projection<3>(e3)), unit);
  };
  for (const double t : {0.0, 0.5, 0.625, 0.75}) EXPECT_NEAR(density(t), std::pow((1 - t) * (1 - t) - 1, 2), 1e-15);
  EXPECT_GT(density(0.625), 0.5 * (density(0.5) + density(0.75)) + 0.01);
}

}  // namespace
}  // namespace shellmatch
