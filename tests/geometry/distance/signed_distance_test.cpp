// The unsigned part: closest points against brute force, exact distances, gradients.
#include "geometry/distance/signed_distance.h"
#include "geometry/surface/pseudonormals.h"

#include "geometry/surface/facet_point.h"
#include "tests/geometry/surface/test_surfaces.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>

namespace shellmatch {
namespace {

using namespace test;

/// Distance from x to a facet, worked out in another way and with more digits: the nearest point of the plane
/// or line through every subset of the corners, where it lies between them.
template <int Dim>
double oracle(const Surface<Dim>& surface, Index f, const Vec<Dim>& x) {
  using Real = long double;
  using Vector = Eigen::Matrix<Real, Dim, 1>;
  Real best = std::numeric_limits<Real>::infinity();
  for (unsigned subset = 1; subset < 1u << Dim; ++subset) {
    std::vector<Vector> corners;
    for (int i = 0; i < Dim; ++i)
      if (subset >> i & 1) corners.push_back(surface.vertices[surface.facets[f][i]].template cast<Real>());
    const Vector w = x.template cast<Real>() - corners[0];
    const std::size_t n = corners.size() - 1;
    if (n == 0) {
      best = std::min(best, w.norm());
      continue;
    }
    // Least squares by orthogonal projection, the second edge without its part along the first, and refined.
    const Vector a = corners[1] - corners[0], b = n == 2 ? Vector(corners[2] - corners[0]) : Vector(Vector::Zero());
    const Vector across = b - a.dot(b) / a.squaredNorm() * a;
    Real of_a = 0, of_b = 0;
    for (int step = 0; step < 3; ++step) {
      const Vector rest = w - of_a * a - of_b * b;
      const Real more_of_b = n == 2 ? across.dot(rest) / across.squaredNorm() : 0;
      of_a += a.dot(rest - more_of_b * b) / a.squaredNorm();
      of_b += more_of_b;
    }
    if (std::min(of_a, of_b) < 0 || of_a + of_b > 1) continue;
    best = std::min(best, (w - of_a * a - of_b * b).norm());
  }
  return static_cast<double>(best);
}

template <int Dim>
double brute_force(const Surface<Dim>& surface, const Vec<Dim>& x) {
  double best = std::numeric_limits<double>::infinity();
  for (Index f = 0; f < static_cast<Index>(surface.facets.size()); ++f) best = std::min(best, oracle(surface, f, x));
  return best;
}

template <int Dim>
void expect_brute_force_distances(const Surface<Dim>& surface, int n, double tolerance = 2e-15) {
  const SignedDistance<Dim> distance(surface);
  auto points = query_points(surface, n);
  for (int i = 0; i < n / 4; ++i) {  // exactly on features
    const auto& facet = surface.facets[static_cast<std::size_t>(7 * i) % surface.facets.size()];
    points.push_back(surface.vertices[facet[0]]);
    points.push_back(0.5 * (surface.vertices[facet[0]] + surface.vertices[facet[1]]));
  }
  for (const Vec<Dim>& x : points) {
    const ClosestPoint<Dim> c = distance.closest(x);
    const double exact = brute_force(surface, x);
    const double scale = 1 + x.norm();
    EXPECT_NEAR(std::abs(c.signed_distance), exact, tolerance * scale);
    EXPECT_NEAR((x - c.point).norm(), exact, tolerance * scale);
    EXPECT_LT(oracle(surface, c.facet, c.point), 1e-15 * scale);
  }
}

TEST(SignedDistance, EqualsBruteForceInSpace) {
  const Surface<3> bumpy = mapped<3>(unit_sphere(3), [](const Vec<3>& x) {
    return Vec<3>(x * (1 + 0.3 * std::sin(5 * x.x()) * std::cos(4 * x.y() + x.z())));
  });
  expect_brute_force_distances(bumpy, 200);
  expect_brute_force_distances(box({0, 0, 0}, {1, 2, 3}), 200);  // fits into two leaves
  Surface<3> one;
  one.vertices = {{0, 0, 0}, {1, 0, 0}, {0.2, 0.7, 0.1}};
  one.facets = {{0, 1, 2}};
  expect_brute_force_distances(one, 200);
}

TEST(SignedDistance, EqualsBruteForceInThePlane) {
  expect_brute_force_distances(polygon(300, [](double t) { return 1 + 0.4 * std::cos(7 * t); }), 300);
  expect_brute_force_distances(polygon(3, [](double) { return 1.0; }), 300);
}

TEST(SignedDistance, EqualsBruteForceOnThinTriangles) {
  for (const double thickness : {1e-2, 1e-5, 1e-8}) {
    const Surface<3> flat =
        mapped<3>(unit_sphere(2), [&](const Vec<3>& x) { return Vec<3>(x.x(), thickness * x.y(), x.z()); });
    expect_brute_force_distances(flat, 100);
  }
  // Needles and caps of a height near and below the rounding error of the coordinates.
  for (const double rise : {1e-7, 1e-9, 1e-11, 1e-13, 0.0}) {
    Surface<3> s;
    s.vertices = {{0.1, 0.2, 0.3}, {0.9, 0.7, 0.5}, {0.5, 0.45 + rise, 0.4}, {0.1, 0.2, 0.3 + rise}};
    s.facets = {{0, 1, 2}, {0, 1, 3}};
    expect_brute_force_distances(s, 200, 1e-14 + std::min(rise, 1e-10));
  }
}

TEST(SignedDistance, OfABoxIsExact) {
  const Vec<3> min(0.2, 0.3, 0.1), max(0.8, 0.6, 0.9);
  const SignedDistance<3> distance(box(min, max));
  for (const Vec<3>& x : random_points<3>(1000, {0, 0, 0}, {1, 1, 1})) {
    const Vec<3> beyond = (min - x).cwiseMax(x - max);
    const double exact = beyond.cwiseMax(0).norm() + std::min(beyond.maxCoeff(), 0.0);
    EXPECT_NEAR(distance(x), exact, 1e-15);
  }
}

TEST(SignedDistance, OfASphereIsExactToSecondOrder) {
  double previous = 0;
  for (int level = 2; level < 5; ++level) {
    const SignedDistance<3> distance(unit_sphere(level));
    double error = 0;
    for (const Vec<3>& x : random_points<3>(500, {-2, -2, -2}, {2, 2, 2}))
      error = std::max(error, std::abs(distance(x) - (x.norm() - 1)));
    if (level > 2) {
      EXPECT_NEAR(previous / error, 4, 0.6);
    }
    previous = error;
  }
}

template <int Dim>
void expect_distance_function(const Surface<Dim>& surface) {
  const SignedDistance<Dim> distance(surface);
  const auto points = query_points(surface, 400, 5);
  int n_smooth = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Vec<Dim>& x = points[i];
    const ClosestPoint<Dim> c = distance.closest(x);
    EXPECT_NEAR(c.normal.norm(), 1, 1e-14);
    const Vec<Dim>& y = points[(i * 37 + 11) % points.size()];
    EXPECT_LE(std::abs(c.signed_distance - distance(y)), (x - y).norm() + 1e-15);
    // On the way to the closest point the distance falls with slope one.
    for (const double t : {0.25, 0.9})
      EXPECT_NEAR(distance(x - t * c.signed_distance * c.normal), (1 - t) * c.signed_distance, 1e-14);
    // The surface is reached along the normal.
    EXPECT_LT((x - c.signed_distance * c.normal - c.point).norm(), 1e-14);
    Vec<Dim> gradient;
    const double h = 1e-7;
    for (int k = 0; k < Dim; ++k)
      gradient[k] = (distance(x + h * Vec<Dim>::Unit(k)) - distance(x - h * Vec<Dim>::Unit(k))) / (2 * h);
    if ((gradient - c.normal).norm() < 1e-5) ++n_smooth;
  }
  // Differences across an edge of the surface or its medial axis say nothing; such points are few.
  EXPECT_GT(n_smooth, 0.8 * static_cast<double>(points.size()));
}

TEST(SignedDistance, IsLipschitzAndItsNormalIsItsGradient) {
  expect_distance_function(torus(0.6, 0.25, 40, 20));
  expect_distance_function(polygon(100, [](double t) { return 1 + 0.4 * std::cos(3 * t); }));
}

TEST(SignedDistance, NormalOnTheSurfaceIsThePseudonormalOfTheFeature) {
  const SignedDistance<3> distance(box({0, 0, 0}, {1, 1, 1}));
  EXPECT_LT((distance.closest({1, 0.3, 0.4}).normal - Vec<3>(1, 0, 0)).norm(), 1e-15);
  EXPECT_LT((distance.closest({1, 1, 0.4}).normal - Vec<3>(1, 1, 0).normalized()).norm(), 1e-15);
  // Weighted with angles the corner does not see how the square faces are cut into triangles.
  for (const Vec<3>& corner : distance.surface().vertices)
    EXPECT_LT((distance.closest(corner).normal - (corner - Vec<3>::Constant(0.5)).normalized()).norm(), 1e-15);
  const SignedDistance<2> square(polygon(4, [](double) { return 1.0; }));
  EXPECT_LT((square.closest({1, 0}).normal - Vec<2>(1, 0)).norm(), 1e-15);
}

TEST(SignedDistance, PseudonormalIsThatOfTheFeatureWithinRounding) {
  const SignedDistance<3> distance(box({0, 0, 0}, {1, 1, 1}));
  for (const double off : {-1e-15, 0.0, 1e-15}) {
    EXPECT_LT((distance.pseudonormal(distance.closest({1.5, 1 + off, 0.4})) - Vec<3>(1, 1, 0).normalized()).norm(),
              1e-14);
    EXPECT_LT((distance.pseudonormal(distance.closest({1.5, 1 + off, 1 - off})) - Vec<3>(1, 1, 1).normalized()).norm(),
              1e-14);
  }
  EXPECT_LT((distance.pseudonormal(distance.closest({1.5, 0.7, 0.4})) - Vec<3>(1, 0, 0)).norm(), 1e-15);
  const SignedDistance<2> square(polygon(4, [](double) { return 1.0; }));
  EXPECT_LT((square.pseudonormal(square.closest({1, 1e-15})) - Vec<2>(1, 0)).norm(), 1e-14);
}

TEST(Pseudonormals, DoNotDependOnWhereTheyLieInMemory) {
  const Surface<3> one = torus(0.6, 0.25, 40, 20);
  Surface<3> other = one;
  other.vertices.insert(other.vertices.begin(), Vec<3>::Zero());
  for (auto& facet : other.facets)
    for (Index& v : facet) ++v;
  const Pseudonormals<3> of_one(one), of_other(other);
  for (Index f = 0; f < static_cast<Index>(one.facets.size()); ++f)
    for (FeatureMask corner : {1u, 2u, 4u}) EXPECT_EQ(of_one(one, f, corner), of_other(other, f, corner));
}

TEST(SignedDistance, TakesTheFirstOfEquallyNearFacets) {
  Surface<3> cube = box({0, 0, 0}, {1, 1, 1});
  for (int turn = 0; turn < 12; ++turn) {
    EXPECT_EQ(SignedDistance<3>(cube).closest({0.5, 0.5, 0.5}).facet, 0);
    std::rotate(cube.facets.begin(), cube.facets.begin() + 5, cube.facets.end());
  }
}

TEST(SignedDistance, OfManyPointsFindsWhatItFindsOfEach) {
  const SignedDistance<3> sphere(unit_sphere(3));
  std::vector<Vec<3>> points;
  for (int i = 0; i < 150; ++i) points.emplace_back(1.5 * std::sin(0.1 * i), std::cos(0.7 * i), 0.01 * i - 0.6);
  std::vector<ClosestPoint<3>> found(points.size());
  sphere.closest(points, found);
  for (std::size_t i = 0; i < points.size(); ++i) {
    const ClosestPoint<3> one = sphere.closest(points[i]);
    EXPECT_EQ(found[i].facet, one.facet);
    EXPECT_EQ(found[i].signed_distance, one.signed_distance);
    EXPECT_EQ(found[i].point, one.point);
    EXPECT_EQ(found[i].normal, one.normal);
  }
}

TEST(SignedDistance, RefusesPointsThatAreNotFinite) {
  const SignedDistance<3> distance(unit_sphere(2));
  EXPECT_THROW(distance({std::nan(""), 0, 0}), std::logic_error);
  EXPECT_THROW(SignedDistance<3>(Surface<3>{}), std::logic_error);
}

}  // namespace
}  // namespace shellmatch
