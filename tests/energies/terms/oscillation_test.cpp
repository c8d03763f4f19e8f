// The oscillating maps of the circle [eq:varphik]: R = 0.95, k = 6, 20, 50, as in the paper's figure.
//
// In polar coordinates r' = R sin(k xi) and r theta' = (1 - R^2 sin^2(k xi))^(1/2). The paper's r0, the mean
// of the second, closes the curve in the limit of large k; for finite k a start r that is smaller by about
// R/k does.

#include "energies/terms/cauchy_green_membrane.h"
#include "energies/terms/membrane.h"
#include "tests/energies/densities/random_matrices.h"
#include "tests/energies/terms/band_density.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace shellmatch {
namespace {

using namespace test;

constexpr double pi = std::numbers::pi, amplitude = 0.95;
constexpr int n = 40000;  // steps of the midpoint rule: even in every period for k = 50

double radial(int k, double xi) { return amplitude * std::sin(k * xi); }
double angular(int k, double xi) { return std::sqrt(1 - std::pow(radial(k, xi), 2)); }
double radius(int k, double start, double xi) { return start + amplitude / k * (1 - std::cos(k * xi)); }

// Angle that the curve runs through in one turn of xi.
double turn(int k, double start) {
  double sum = 0;
  for (int i = 0; i < n; ++i) {
    const double xi = 2 * pi * (i + 0.5) / n;
    sum += angular(k, xi) / radius(k, start, xi) * 2 * pi / n;
  }
  return sum;
}

// The start for which the curve closes after one turn.
double closing_start(int k) {
  double low = 0.05, high = 1;  // the turn falls with the start
  for (int i = 0; i < 60; ++i) (turn(k, 0.5 * (low + high)) > 2 * pi ? low : high) = 0.5 * (low + high);
  return 0.5 * (low + high);
}

double mean_speed() {
  double sum = 0;
  for (int i = 0; i < n; ++i) sum += angular(1, 2 * pi * (i + 0.5) / n) / n;
  return sum;
}

// Density of a membrane term where the reference has its tangent along the first axis and the template, a
// circle about the origin, its normal along e_r: the derivative is given in the frame (e_theta, e_r).
template <class Membrane>
double density(double along, double out) {
  const Vec<2> normal(0, 1);
  Mat<2> dphi;
  dphi << along, 0, out, 1;
  const TargetPoint<2, double> y{0, small<2>(normal), {}};
  const ReferencePoint<2, double> x{0, small<2>(normal), {}};
  return band_density<Membrane>(y, small(dphi), x, Material<double>{1, 1});
}

template <class Membrane>
double energy(int k) {
  double sum = 0;
  for (int i = 0; i < n; ++i) {
    const double xi = 2 * pi * (i + 0.5) / n;
    sum += density<Membrane>(angular(k, xi), radial(k, xi)) * 2 * pi / n;
  }
  return sum;
}

TEST(Oscillation, CurvesCloseAndTendToTheCircle) {
  const double r0 = mean_speed();
  EXPECT_NEAR(2 * pi * r0, 4 * std::comp_ellint_2(amplitude), 1e-8);
  double last_gap = 2;
  for (const int k : {6, 20, 50}) {
    const double start = closing_start(k);
    EXPECT_NEAR(turn(k, start), 2 * pi, 1e-9);
    EXPECT_NEAR(radius(k, start, 2 * pi), start, 1e-12);
    const double t = 1e-5;  // r' is the radial speed
    for (const double xi : {0.1, 0.9, 4.0})
      EXPECT_NEAR((radius(k, start, xi + t) - radius(k, start, xi - t)) / (2 * t), radial(k, xi), 1e-6);
    // Never nearer to the origin than at the start: the curve is simple, since its angle grows throughout.
    EXPECT_GT(start, 0.2);
    // All of the curve is within 2 R / k of the limit, the start included.
    EXPECT_LT(std::abs(start - r0), 1.5 * amplitude / k);
    EXPECT_LT(std::abs(start + 2 * amplitude / k - r0), 1.5 * amplitude / k);
    // With the paper's start the ends miss each other by an angle that falls like 1/k.
    const double gap = std::abs(turn(k, r0) - 2 * pi);
    EXPECT_GT(gap, 1.0 / k);
    EXPECT_LT(gap, 20.0 / k);
    EXPECT_LT(gap, last_gap);
    last_gap = gap;
  }
}

TEST(Oscillation, TheNaiveMembraneFallsBehindItsWeakLimitAndOursDoesNot) {
  const double r0 = mean_speed();
  EXPECT_NEAR(r0, 0.702, 1e-4);
  const double naive_limit = 2 * pi * density<CauchyGreenMembrane<2>>(r0, 0);
  const double limit = 2 * pi * density<Membrane<2>>(r0, 0);
  EXPECT_GT(naive_limit, 0.3);
  EXPECT_GT(limit, 0.3);
  for (const int k : {6, 20, 50}) {
    // Tangentially isometric, hence free of charge: not lower semicontinuous.
    for (int i = 0; i < 100; ++i) EXPECT_NEAR(std::hypot(angular(k, i), radial(k, i)), 1, 1e-15);
    EXPECT_NEAR(energy<CauchyGreenMembrane<2>>(k), 0, 1e-12);
    // With P2 the oscillations cost more than the limit.
    EXPECT_GT(energy<Membrane<2>>(k), limit + 0.1);
  }
}

}  // namespace
}  // namespace shellmatch
