// Volumes, areas and lengths with known values: second order in the edge length.
#include "tests/geometry/generate/generated_surface.h"
#include "tests/geometry/surface/test_surfaces.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

namespace shellmatch {
namespace {

// The error falls at least like h^1.8 from h = 0.04 to 0.02 to 0.01, and is not zero by accident.
void expect_second_order(const std::function<double(double)>& measure, double exact) {
  const double coarse = std::abs(measure(0.04) - exact), middle = std::abs(measure(0.02) - exact),
               fine = std::abs(measure(0.01) - exact);
  EXPECT_GT(fine, 1e-9);
  EXPECT_GT(std::log2(coarse / fine) / 2, 1.8) << coarse << ' ' << middle << ' ' << fine;
  EXPECT_LT(fine, 2e-3 * exact);
}

TEST(Measures, Sphere) {
  expect_second_order(
      [](double h) {
        return enclosed_measure(generated_surface("sphere", "", h, {{"radius", 0.3}}));
      },
      4 * M_PI / 3 * 0.027);
  expect_second_order(
      [](double h) {
        return test::boundary_measure(generated_surface("sphere", "", h, {{"radius", 0.3}}));
      },
      4 * M_PI * 0.09);
}

TEST(Measures, Ellipsoid) {
  expect_second_order([](double h) { return enclosed_measure(generated_surface("ellipsoid", "long", h)); },
                      4 * M_PI / 3 * 0.36 * 0.22 * 0.27);
}

TEST(Measures, Torus) {
  expect_second_order([](double h) { return enclosed_measure(generated_surface("torus", "thick", h)); },
                      2 * M_PI * M_PI * 0.26 * 0.01);
  expect_second_order([](double h) { return test::boundary_measure(generated_surface("torus", "thick", h)); },
                      4 * M_PI * M_PI * 0.26 * 0.1);
}

TEST(Measures, RoundedBox) {
  // Steiner's formula for the inner box with sides a and the ball of radius r.
  const double a = 0.45 - 0.1, r = 0.05;
  const double volume = a * a * a + 6 * a * a * r + 3 * M_PI * a * r * r + 4 * M_PI / 3 * r * r * r;
  expect_second_order([](double h) { return enclosed_measure(generated_surface("box", "cube", h)); }, volume);
  expect_second_order([](double h) { return enclosed_measure(generated_surface("box", "compressed", h)); },
                      0.64 * volume);
}

TEST(Measures, Ellipse) {
  expect_second_order([](double h) { return enclosed_measure(generated_outline("ellipse", "long", h)); },
                      M_PI * 0.37 * 0.2);
  expect_second_order([](double h) { return test::boundary_measure(generated_outline("circle", "large", h)); },
                      2 * M_PI * 0.3);
}

}  // namespace
}  // namespace shellmatch
