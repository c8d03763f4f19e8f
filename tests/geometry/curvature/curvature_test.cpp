#include "geometry/curvature/curvature.h"

#include "tests/geometry/surface/test_surfaces.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>

namespace shellmatch {
namespace {

using namespace test;

void expect_orthonormal(const VertexCurvature& c) {
  Mat<3> frame;
  frame << c.d1, c.d2, c.normal;
  EXPECT_LT((frame.transpose() * frame - Mat<3>::Identity()).norm(), 1e-12);
  EXPECT_NEAR(c.d1.cross(c.d2).dot(c.normal), 1, 1e-12);
  EXPECT_GE(c.k1, c.k2);
}

TEST(Curvature, OfASphereIsOneOverItsRadius) {
  const double radius = 0.3;
  const Surface<3> s = mapped<3>(unit_sphere(4), [&](const Vec<3>& x) { return Vec<3>(radius * x); });
  const auto curvatures = vertex_curvatures(s);
  for (std::size_t v = 0; v < s.vertices.size(); ++v) {
    expect_orthonormal(curvatures[v]);
    EXPECT_NEAR(curvatures[v].k1, 1 / radius, 0.03 / radius);
    EXPECT_NEAR(curvatures[v].k2, 1 / radius, 0.03 / radius);
    EXPECT_GT(curvatures[v].normal.dot(s.vertices[v]), 0.999 * radius);
  }
  // With the orientation the sign changes.
  EXPECT_LT(vertex_curvatures(reversed(s))[17].k1, -0.97 / radius);
}

/// Largest error of both curvatures, and of the first direction where they differ enough, on the torus.
std::pair<double, double> torus_error(int n, const CurvatureOptions& options) {
  const double core = 1, tube = 0.4;
  const Surface<3> s = torus(core, tube, 5 * n, 2 * n);
  const auto curvatures = vertex_curvatures(s, options);
  double error = 0, direction_error = 0;
  for (std::size_t v = 0; v < s.vertices.size(); ++v) {
    const Vec<3>& x = s.vertices[v];
    const double rho = std::hypot(x.x(), x.y());
    const Vec<3> around = Vec<3>(-x.y(), x.x(), 0) / rho;
    error = std::max(error, std::abs(curvatures[v].k1 - 1 / tube));
    error = std::max(error, std::abs(curvatures[v].k2 - (rho - core) / (tube * rho)));
    direction_error = std::max(direction_error, std::abs(curvatures[v].d1.dot(around)));
  }
  return {error, direction_error};
}

TEST(Curvature, OfATorusConvergesWithTheOrderOfTheDegree) {
  for (const int degree : {2, 4}) {
    const auto [coarse, coarse_direction] = torus_error(12, {degree, 3});
    const auto [fine, fine_direction] = torus_error(24, {degree, 3});
    EXPECT_GT(std::log2(coarse / fine), degree - 1 - 0.1) << "degree " << degree;
    EXPECT_LT(fine, degree == 2 ? 0.3 : 0.05);
    EXPECT_LT(fine_direction, 0.05);
  }
}

TEST(Curvature, OfAnEllipsoidHasItsGaussianAndMeanCurvature) {
  const Vec<3> axes(1, 0.8, 0.6);
  const Surface<3> s = mapped<3>(unit_sphere(5), [&](const Vec<3>& x) { return Vec<3>(axes.cwiseProduct(x)); });
  const auto curvatures = vertex_curvatures(s, {4, 3});
  for (std::size_t v = 0; v < s.vertices.size(); ++v) {
    // For F = sum x_i^2 / a_i^2: K = (a b c)^-2 |grad F / 2|^-4, H from the divergence of the unit normal.
    const Vec<3> x = s.vertices[v], weights = axes.cwiseProduct(axes).cwiseInverse();
    const Vec<3> g = weights.cwiseProduct(x);
    const double gauss = std::pow(axes.prod(), -2) * std::pow(g.norm(), -4);
    const double twice_mean = weights.sum() / g.norm() - g.dot(weights.cwiseProduct(g)) / std::pow(g.norm(), 3);
    EXPECT_NEAR(curvatures[v].k1 * curvatures[v].k2, gauss, 5e-3 * gauss);
    EXPECT_NEAR(curvatures[v].k1 + curvatures[v].k2, twice_mean, 5e-3 * twice_mean);
  }
}

// A sphere whose caps are fans of n long triangles. All vertices of a fan's border are within two rings of each other,
// and the curvature is one of the place nonetheless: it does not change to the bit where the other side of the sphere
// does.
TEST(Curvature, BesideAVertexOfVeryManyEdges) {
  constexpr Index n = 1000, n_rows = 3;
  Surface<3> s;
  for (Index row = 0; row < n_rows; ++row)
    for (Index k = 0; k < n; ++k) {
      const double latitude = 0.05 * (row - n_rows / 2), longitude = 2 * std::numbers::pi * k / n;
      s.vertices.emplace_back(std::cos(latitude) * std::cos(longitude), std::cos(latitude) * std::sin(longitude),
                              std::sin(latitude));
    }
  const auto south = static_cast<Index>(s.vertices.size()), north = south + 1;
  s.vertices.emplace_back(0, 0, -1);
  s.vertices.emplace_back(0, 0, 1);
  for (Index k = 0; k < n; ++k) {
    const Index next = (k + 1) % n, top = (n_rows - 1) * n;
    for (Index row = 0; row + 1 < n_rows; ++row) {
      s.facets.push_back({row * n + k, row * n + next, (row + 1) * n + next});
      s.facets.push_back({row * n + k, (row + 1) * n + next, (row + 1) * n + k});
    }
    s.facets.push_back({south, next, k});
    s.facets.push_back({north, top + k, top + next});
  }
  const Surface<3> other = mapped<3>(s, [](const Vec<3>& x) { return Vec<3>(x.x() < -0.5 ? 1.5 * x : x); });
  const auto curvatures = vertex_curvatures(s), of_other = vertex_curvatures(other);
  for (Index v = 0; v < n_rows * n; ++v) {
    if (s.vertices[v].x() < 0.5) continue;
    expect_orthonormal(curvatures[v]);
    ASSERT_EQ(curvatures[v].k1, of_other[v].k1) << v;
    ASSERT_EQ(curvatures[v].k2, of_other[v].k2) << v;
  }
}

TEST(Curvature, IsNotANumberWhereThereAreTooFewVertices) {
  Surface<3> s = unit_sphere(0);
  s.vertices.emplace_back(5, 5, 5);
  // Six vertices determine a polynomial of degree 2 and no more; the last one belongs to no facet.
  const auto curvatures = vertex_curvatures(s, {3, 1});
  for (const VertexCurvature& c : curvatures) EXPECT_TRUE(std::isnan(c.k1));
}

TEST(Curvature, OfEverySecondVertexIsNoOther) {
  const std::vector<VertexCurvature> all = vertex_curvatures(unit_sphere(2)),
                                     some = vertex_curvatures(unit_sphere(2), {.every = 2});
  for (std::size_t v = 0; v < all.size(); ++v) {
    if (v % 2 == 0) EXPECT_EQ(some[v].k1, all[v].k1);
    else EXPECT_TRUE(std::isnan(some[v].k1));
  }
}

TEST(Curvature, FramesOnAHandAreOrthonormal) {
  const auto hand = data_surface("hands_makehuman/hand_woman_young.off");
  if (!hand) GTEST_SKIP() << "set SHELLMATCH_DATA to the data folder";
  for (const VertexCurvature& c : vertex_curvatures(*hand)) expect_orthonormal(c);
}

}  // namespace
}  // namespace shellmatch
