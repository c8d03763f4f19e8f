#include "geometry/generate/exact_shape.h"

#include "base/error.h"
#include "geometry/generate/generate_shape.h"
#include "geometry/distance/signed_distance.h"

#include <gtest/gtest.h>

#include <random>

namespace shellmatch {
namespace {

template <int Dim>
Surface<Dim> surface_of(const OriginalShape<Dim>& shape) {
  Surface<Dim> s;
  s.vertices = shape.vertices;
  for (const auto& polygon : shape.polygons) {
    if constexpr (Dim == 3) s.facets.push_back({polygon[0], polygon[1], polygon[2]});
    else
      for (std::size_t i = 0; i < polygon.size(); ++i)
        s.facets.push_back({polygon[i], polygon[(i + 1) % polygon.size()]});
  }
  return s;
}

template <int Dim>
Vec<Dim> random_point(std::mt19937& random) {
  std::uniform_real_distribution<double> uniform(0, 1);
  Vec<Dim> x;
  for (int k = 0; k < Dim; ++k) x[k] = uniform(random);
  return x;
}

// On the generated vertices the distance vanishes; elsewhere it is that of the fine mesh.
template <int Dim>
void expect_distance_of_mesh(const std::string& name, const std::string& variant, double tolerance) {
  SCOPED_TRACE(name + "/" + variant);
  const auto shape = std::get<ExactShape<Dim>>(*exact_shape(name, variant));
  const Surface<Dim> surface = surface_of(std::get<OriginalShape<Dim>>(generate_shape(name, variant)));
  for (const Vec<Dim>& x : surface.vertices) ASSERT_NEAR(shape.distance(x), 0, 1e-12);
  const SignedDistance<Dim> of_mesh(surface);
  std::mt19937 random(1);
  for (int i = 0; i < 3000; ++i) {
    const Vec<Dim> x = random_point<Dim>(random);
    ASSERT_NEAR(shape.distance(x), of_mesh(x), tolerance) << x.transpose();
  }
}

TEST(ExactShape, DistanceIsThatOfTheGeneratedShape) {
  for (const char* variant : {"large", "small"}) {
    expect_distance_of_mesh<2>("circle", variant, 2e-5);
    expect_distance_of_mesh<3>("sphere", variant, 2e-4);
  }
  for (const char* variant : {"round", "long"}) {
    expect_distance_of_mesh<2>("ellipse", variant, 3e-5);
    expect_distance_of_mesh<3>("ellipsoid", variant, 2e-4);
  }
  for (const char* variant : {"thick", "thin"}) expect_distance_of_mesh<3>("torus", variant, 3e-4);
}

// Points of the medial disc and of the axes, where the nearest point is not unique or lies on an axis.
TEST(ExactShape, DistanceOnTheAxesOfAnEllipsoid) {
  const Vec<3> a(0.3, 0.2, 0.1);
  const auto shape = exact_ellipsoid<3>(a, Vec<3>::Zero());
  EXPECT_NEAR(shape.distance(Vec<3>::Zero()), -0.1, 1e-12);
  EXPECT_NEAR(shape.distance({0, 0, 0.05}), -0.05, 1e-12);
  EXPECT_NEAR(shape.distance({0, 0, -0.7}), 0.6, 1e-12);
  EXPECT_NEAR(shape.distance({0.299, 0, 0}), -0.001, 1e-12);
  // On the long axis next to the centre: x = a^2 y/(a^2 - c^2), z from the equation of the ellipse.
  const double y = 0.1, x = 0.09 * y / (0.09 - 0.01), z = 0.1 * std::sqrt(1 - x * x / 0.09);
  EXPECT_NEAR(shape.distance({y, 0, 0}), -std::hypot(x - y, z), 1e-9);
}

// S is D^2 d: central differences of the distance.
template <int Dim>
void expect_second_derivative(const std::string& name, const std::string& variant) {
  SCOPED_TRACE(name);
  const auto shape = std::get<ExactShape<Dim>>(*exact_shape(name, variant));
  const auto original = std::get<OriginalShape<Dim>>(generate_shape(name, variant, 0.03));
  const double h = 1e-3;
  for (std::size_t v = 0; v < original.vertices.size(); v += 7) {
    const Vec<Dim> x = original.vertices[v];
    const Mat<Dim> s = shape.shape_operator(x);
    for (int i = 0; i < Dim; ++i)
      for (int j = 0; j < Dim; ++j) {
        const Vec<Dim> a = h * Vec<Dim>::Unit(i), b = h * Vec<Dim>::Unit(j);
        const double found = (shape.distance(x + a + b) - shape.distance(x + a - b) - shape.distance(x - a + b) +
                              shape.distance(x - a - b)) /
                             (4 * h * h);
        ASSERT_NEAR(s(i, j), found, 2e-3 * std::max(1.0, s.norm()));
      }
  }
}

TEST(ExactShape, ShapeOperatorIsTheSecondDerivativeOfTheDistance) {
  expect_second_derivative<2>("circle", "");
  expect_second_derivative<2>("ellipse", "long");
  expect_second_derivative<3>("sphere", "small");
  expect_second_derivative<3>("ellipsoid", "long");
  expect_second_derivative<3>("torus", "thin");
}

TEST(ExactShape, OthersHaveNone) {
  EXPECT_FALSE(exact_shape("hand"));
  EXPECT_FALSE(exact_shape("leaf", "shallow"));
  EXPECT_THROW(exact_shape("no such thing"), InputError);
  EXPECT_THROW(exact_shape("sphere", "square"), InputError);
}

}  // namespace
}  // namespace shellmatch
