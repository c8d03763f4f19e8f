#include "geometry/distance/distortion.h"

#include "base/decompositions.h"
#include "tests/geometry/surface/test_surfaces.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <Eigen/LU>

#include <algorithm>

namespace shellmatch {
namespace {

using namespace test;

const Mat<3> linear_map = (Mat<3>() << 1.3, 0.2, -0.1, 0.4, 0.8, 0.3, 0.0, -0.2, 1.1).finished();

TEST(Distortion, OfALinearMapIsThatOfItsRestrictionToTheTangentPlanes) {
  const Surface<3> sphere = unit_sphere(3);
  const Surface<3> image = mapped<3>(sphere, [](const Vec<3>& x) { return Vec<3>(linear_map * x); });
  const auto ratios = facet_measure_ratios(sphere, image);
  const auto stretches = principal_stretches(sphere, image);
  const auto angles = angle_distortions(sphere, image), turns = turned_directions(sphere, image);
  const Mat<3> cofactor = linear_map.determinant() * linear_map.inverse().transpose();
  for (std::size_t f = 0; f < sphere.facets.size(); ++f) {
    const Vec<3> n = facet_normal(sphere, static_cast<Index>(f)).normalized();
    const Mat<3> p = Mat<3>::Identity() - n * n.transpose();
    const Vec<3> singular_values = jacobi_svd(Mat<3>(linear_map * p)).values;
    EXPECT_NEAR(ratios[f], (cofactor * n).norm(), 1e-13);
    EXPECT_NEAR(stretches[f].s1, singular_values[0], 1e-13);
    EXPECT_NEAR(stretches[f].s2, singular_values[1], 1e-13);
    EXPECT_NEAR(angles[f], singular_values[0] / singular_values[1], 1e-12);
    // The direction that turns most lies between the principal ones: tan^2 of its angle is s2 / s1 before, s1 / s2
    // after.
    const double before = std::atan(std::sqrt(1 / angles[f])), after = std::atan(angles[f] * std::sqrt(1 / angles[f]));
    EXPECT_NEAR(turns[f] * std::acos(-1) / 180, after - before, 1e-12);
  }
}

TEST(Distortion, InThePlaneIsTheRatioOfLengths) {
  const Mat<2> a = linear_map.topLeftCorner<2, 2>();
  const Surface<2> p = polygon(50, [](double t) { return 1 + 0.3 * std::cos(3 * t); });
  const Surface<2> image = mapped<2>(p, [&](const Vec<2>& x) { return Vec<2>(a * x); });
  const auto ratios = facet_measure_ratios(p, image);
  for (std::size_t f = 0; f < p.facets.size(); ++f) {
    const Vec<2> tangent = (p.vertices[p.facets[f][1]] - p.vertices[p.facets[f][0]]).normalized();
    EXPECT_NEAR(ratios[f], (a * tangent).norm(), 1e-13);
  }
}

TEST(Distortion, OfASimilarityIsItsFactorEverywhere) {
  const Surface<3> s = torus(0.6, 0.2, 20, 12);
  const Mat<3> turn = Eigen::AngleAxisd(0.7, Vec<3>(1, 2, 3).normalized()).toRotationMatrix();
  const Surface<3> image = mapped<3>(s, [&](const Vec<3>& x) { return Vec<3>(1.5 * (turn * x) + Vec<3>(3, 0, 1)); });
  for (const double ratio : vertex_measure_ratios(s, image)) EXPECT_NEAR(ratio, 2.25, 1e-12);
  for (const double angle : angle_distortions(s, image)) EXPECT_NEAR(angle, 1, 1e-7);
  for (const double ratio : facet_measure_ratios(s, image)) EXPECT_NEAR(ratio, 2.25, 1e-12);
}

TEST(Distortion, VertexRatiosAreAreaWeighted) {
  // Only the facets with x > 0 grow: vertices on the seam see both kinds.
  const Surface<2> p = polygon(4, [](double) { return 1.0; });
  const Surface<2> image = mapped<2>(p, [](const Vec<2>& x) { return Vec<2>(x.x() > 0.5 ? 7 * x : x); });
  const auto ratios = vertex_measure_ratios(p, image);
  const double grown = std::sqrt(50.0) / std::sqrt(2.0);
  EXPECT_NEAR(ratios[0], grown, 1e-14);
  EXPECT_NEAR(ratios[1], (1 + grown) / 2, 1e-14);
  EXPECT_NEAR(ratios[2], 1, 1e-14);
}

TEST(Distortion, CollapsedFacetsHaveNoMeasureAndMissingMeasuresAreNaN) {
  const Surface<3> cube = box({0, 0, 0}, {1, 1, 1});
  const Surface<3> flat = mapped<3>(cube, [](const Vec<3>& x) { return Vec<3>(x.x(), x.y(), 0); });
  EXPECT_EQ(std::ranges::count(facet_measure_ratios(cube, flat), 0), 8);
  EXPECT_TRUE(std::isinf(angle_distortions(cube, flat)[4]));
  EXPECT_TRUE(std::isnan(facet_measure_ratios(flat, cube)[4]));
  EXPECT_TRUE(std::isnan(angle_distortions(flat, cube)[4]));
  // The four facets that remain keep their areas.
  EXPECT_EQ(std::ranges::count(facet_measure_ratios(flat, cube), 1), 4);
}

TEST(Distortion, FacesAwayWhereFacetsAreReversed) {
  const auto count_facing_away = [](const auto& surface, const auto& distance) {
    return static_cast<std::size_t>(std::ranges::count(facing_away(surface, distance), 1));
  };
  const Surface<3> sphere = unit_sphere(3);
  const SignedDistance<3> distance(sphere);
  EXPECT_EQ(count_facing_away(sphere, distance), 0u);
  EXPECT_EQ(count_facing_away(reversed(sphere), distance), sphere.facets.size());
  Surface<3> mixed = sphere;
  for (std::size_t f = 10; f < 17; ++f) std::swap(mixed.facets[f][0], mixed.facets[f][1]);
  EXPECT_EQ(count_facing_away(mixed, distance), 7u);
  const Surface<2> p = polygon(20, [](double) { return 1.0; });
  EXPECT_EQ(count_facing_away(reversed(p), SignedDistance<2>(p)), 20u);
}

TEST(Distortion, RefusesSurfacesThatDoNotCorrespond) {
  EXPECT_THROW(facet_measure_ratios(unit_sphere(1), unit_sphere(2)), std::logic_error);
  EXPECT_THROW(facet_measure_ratios(unit_sphere(1), reversed(unit_sphere(1))), std::logic_error);
}

}  // namespace
}  // namespace shellmatch
