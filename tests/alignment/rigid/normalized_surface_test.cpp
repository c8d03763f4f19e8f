// Moments and samples against closed forms.
#include "alignment/rigid/iterated_points.h"
#include "base/error.h"
#include "geometry/generate/round.h"
#include "tests/geometry/surface/test_surfaces.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace shellmatch {
namespace {

TEST(NormalizedSurface, HasTheCentreAxesAndSizeOfABox) {
  const Vec<3> size(1, 2, 4), middle(5, 6, 7);
  const NormalizedSurface box(test::box(middle - size / 2, middle + size / 2));
  EXPECT_LT((box.centre() - middle).norm(), 1e-12);
  // Integrals of x_k^2 over the six sides: the two across axis k, and of the four others a twelfth of the square of the
  // length.
  const double area = 2 * (size[0] * size[1] + size[1] * size[2] + size[2] * size[0]);
  double sum = 0;
  for (int k = 0; k < 3; ++k) {
    const double across = 2 * size[(k + 1) % 3] * size[(k + 2) % 3];
    sum += size[k] * size[k] * (across / 4 + (area - across) / 12) / area;
  }
  EXPECT_NEAR(box.radius(), std::sqrt(sum), 1e-12);
  EXPECT_LT((box.axes().cwiseAbs() - Mat<3>::Identity()).norm(), 1e-9);
  EXPECT_NEAR(box.axes().determinant(), 1, 1e-12);
}

TEST(NormalizedSurface, SamplesLieOnItEverywhere) {
  Surface<3> sphere = geodesic_sphere(10);
  for (Vec<3>& x : sphere.vertices) x = 3 * x + Vec<3>(1, 2, 3);
  const NormalizedSurface surface(sphere);
  const std::size_t n = 2000;
  const std::vector<SurfacePoint> samples = surface.samples(n);
  ASSERT_EQ(samples.size(), n);
  Vec<3> mean = Vec<3>::Zero();
  Mat<3> second = Mat<3>::Zero();
  for (const SurfacePoint& s : samples) {
    mean += s.point / n;
    second += s.point * s.point.transpose() / n;
    EXPECT_NEAR(s.point.norm(), 1, 0.02);
    EXPECT_GT(s.normal.dot(s.point), 0.97);
    const SurfacePoint nearest = surface.nearest(1.3 * s.point);
    EXPECT_LT((nearest.point - s.point).norm(), 0.06);
    EXPECT_GT(nearest.normal.dot(s.point), 0.97);
  }
  EXPECT_LT(mean.norm(), 0.01);
  EXPECT_LT((second - Mat<3>::Identity() / 3).norm(), 0.01);
}

TEST(SampleCloud, FindsTheNearestOfItsSamples) {
  const NormalizedSurface box(test::box({0, 0, 0}, {1, 2, 3}));
  const SampleCloud cloud(box.samples(77));
  ASSERT_EQ(cloud.samples().size(), 77u);
  for (const SurfacePoint& from : box.samples(300)) {
    const Vec<3> x = 1.4 * from.point;
    double least = 1e9;
    for (const SurfacePoint& s : cloud.samples()) least = std::min(least, (s.point - x).norm());
    const SurfacePoint& found = cloud.nearest(x);
    EXPECT_NEAR((found.point - x).norm(), least, 1e-6);
    EXPECT_NEAR(found.normal.norm(), 1, 1e-12);
  }
}

}  // namespace
}  // namespace shellmatch
