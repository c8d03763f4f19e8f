#include "grid/fields/quadrature.h"

#include "grid/fields/bump.h"

#include <gtest/gtest.h>

namespace shellmatch {
namespace {

template <int Dim>
void check_exactness() {
  for (int n = 1; n <= max_gauss_points; ++n) {
    const auto rule = gauss_rule<Dim>(n);
    double volume = 0;
    for (const auto& q : rule) volume += q.weight;
    EXPECT_NEAR(volume, 1, 1e-15);
    // Monomials x^a y^b (z^c) with every exponent up to 2n - 1, and the first that is missed.
    const auto integral = [&](std::array<int, Dim> exponents) {
      double sum = 0;
      for (const auto& q : rule) {
        double v = q.weight;
        for (int k = 0; k < Dim; ++k) v *= std::pow(q.point[k], exponents[k]);
        sum += v;
      }
      return sum;
    };
    for (int a = 0; a < 2 * n; ++a)
      for (int b = 0; b < 2 * n; ++b) {
        std::array<int, Dim> exponents{};
        exponents[0] = a;
        exponents[Dim - 1] = b;
        EXPECT_NEAR(integral(exponents), 1.0 / ((a + 1) * (b + 1)), 1e-15) << n << " points";
      }
    for (int k = 0; k < Dim; ++k) {
      std::array<int, Dim> beyond{};
      beyond[k] = 2 * n;
      EXPECT_GT(std::abs(integral(beyond) - 1.0 / (2 * n + 1)), 1e-7) << n << " points";
    }
  }
}

TEST(GaussRule, ExactUpToItsDegreeAndNoFurther) {
  check_exactness<2>();
  check_exactness<3>();
}

TEST(GaussRule, RefusesNumbersOfPointsThatDoNotExist) {
  EXPECT_THROW(gauss_rule<2>(0), std::logic_error);
  EXPECT_THROW(gauss_rule<3>(6), std::logic_error);
}

// The largest error that docs/curvature.md states for sigma = 2h: planes parallel to the faces of the cells,
// the worst case, at all offsets; there the sum over the cells is one-dimensional.
TEST(GaussRule, BandIntegralsAreAsGoodAsDocumented) {
  constexpr std::array documented{8.0e-3, 6.1e-3, 3.8e-3, 1.5e-3, 3.5e-4};
  double previous = 1;
  for (int n = 1; n <= max_gauss_points; ++n) {
    double worst = 0;
    for (double offset = 0; offset < 1; offset += 0.0005) {
      double sum = 0;
      for (int cell = -3; cell <= 3; ++cell)
        for (const auto& q : gauss_rule<2>(n)) sum += q.weight * bump(cell + q.point[0] - offset, 2);
      worst = std::max(worst, std::abs(sum - 1));
    }
    EXPECT_LE(worst, documented[n - 1]) << n << " points";
    EXPECT_GE(worst, 0.9 * documented[n - 1]) << n << " points";
    EXPECT_LT(worst, previous);
    previous = worst;
  }
}

// All derivatives of eta vanish at the ends, so that the trapezoidal rule converges faster than any power.
TEST(Bump, HasIntegralOne) {
  for (const double sigma : {0.01, 0.25, 3.0}) {
    const int n = 400;
    double sum = 0;
    for (int i = -n; i <= n; ++i) sum += bump(sigma * i / n, sigma) * sigma / n;
    EXPECT_NEAR(sum, 1, 1e-14);
  }
}

TEST(Bump, IsEvenAndSupportedInTheBand) {
  const double sigma = 0.5;
  for (double t = 0; t < 0.6; t += 0.01) EXPECT_EQ(bump(t, sigma), bump(-t, sigma));
  EXPECT_GT(bump(0.45, sigma), 0);
  EXPECT_EQ(bump(0.5, sigma), 0);
  EXPECT_EQ(bump(-0.7, sigma), 0);
  EXPECT_DOUBLE_EQ(bump(0, sigma), bump_constant / sigma * std::exp(-1.0));
}

}  // namespace
}  // namespace shellmatch
