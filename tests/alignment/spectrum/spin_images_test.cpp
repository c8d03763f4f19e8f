// What a surface looks like around a vertex: independence of position, the same all over a sphere, difference between
// dent and bump.
#include "alignment/spectrum/spin_images.h"

#include "alignment/spectrum/spectral_shape.h"
#include "tests/geometry/surface/test_surfaces.h"

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include <cmath>

namespace shellmatch {
namespace {

Eigen::MatrixXf images_of(const Surface<3>& surface) {
  constexpr double radius = 0.08;
  return spin_images(surface, surface_laplacian(surface, 2e-3), {&radius, 1});
}

Surface<3> sphere_of_area_one(int n) {
  const double radius = std::sqrt(surface_measure(test::unit_sphere(n)));
  return test::mapped<3>(test::unit_sphere(n), [&](const Vec<3>& x) { return Vec<3>(x / radius); });
}

TEST(SpinImages, DoNotChangeWithThePosition) {
  const Surface<3> bean = test::mapped<3>(
      sphere_of_area_one(4), [](const Vec<3>& x) { return Vec<3>(x[0], x[1] * (1 + x[0]), x[2] + x[0] * x[0]); });
  const Mat<3> turn = Eigen::AngleAxisd(2, Vec<3>(1, 2, 3).normalized()).toRotationMatrix();
  const Eigen::MatrixXf a = images_of(bean), b = images_of(test::mapped<3>(bean, [&](const Vec<3>&x) {
                                               return Vec<3>(turn * x + Vec<3>(5, 0, 1));
                                             }));
  // A neighbour at the border of two bins may change sides by rounding.
  EXPECT_LT((a - b).squaredNorm() / static_cast<float>(a.cols()), 1e-3);
  EXPECT_NEAR(a.col(17).norm(), 1, 1e-6);
}

TEST(SpinImages, TellADentFromABump) {
  const auto deformed = [](double height) {
    return test::mapped<3>(sphere_of_area_one(5), [&](const Vec<3>& x) {
      return Vec<3>(x * (1 + height * std::exp(-(x - Vec<3>(0, 0, x.norm())).squaredNorm() / 2e-3)));
    });
  };
  const Surface<3> sphere = sphere_of_area_one(5);
  Eigen::Index pole = 0, antipode = 0;
  for (std::size_t v = 0; v < sphere.vertices.size(); ++v)
    if (sphere.vertices[v][2] > sphere.vertices[static_cast<std::size_t>(pole)][2]) pole = static_cast<Eigen::Index>(v);
  for (std::size_t v = 0; v < sphere.vertices.size(); ++v)
    if (sphere.vertices[v][2] < sphere.vertices[static_cast<std::size_t>(antipode)][2])
      antipode = static_cast<Eigen::Index>(v);
  const Eigen::MatrixXf bump = images_of(deformed(0.08)), dent = images_of(deformed(-0.08)), flat = images_of(sphere);
  EXPECT_GT((bump.col(pole) - dent.col(pole)).squaredNorm(), 0.5);
  // Far from there nothing has changed but the size, by which all is measured.
  EXPECT_LT((flat.col(pole) - bump.col(antipode)).squaredNorm(), 0.1);
}

TEST(SpinImages, DoNotSeeALimbThatOnlyComesNear) {
  const Surface<3> one = sphere_of_area_one(4);
  Surface<3> both = one;
  const double diameter = 2 * one.vertices[0].norm();
  const auto n = static_cast<Index>(one.vertices.size());
  for (const Vec<3>& x : one.vertices) both.vertices.push_back(x + Vec<3>(diameter + 0.02, 0, 0));
  for (const auto& [a, b, c] : one.facets) both.facets.push_back({a + n, b + n, c + n});
  EXPECT_LT((images_of(both).leftCols(n) - images_of(one)).squaredNorm() / static_cast<float>(n), 1e-3);
}

TEST(SpinImages, OfSeveralRadiiStandBelowEachOther) {
  const Surface<3> sphere = sphere_of_area_one(4);
  const SurfaceLaplacian laplacian = surface_laplacian(sphere, 2e-3);
  constexpr double radii[] = {0.08, 0.2};
  const Eigen::MatrixXf images = spin_images(sphere, laplacian, radii);
  ASSERT_EQ(images.rows(), 2 * SpinImages::n_entries);
  EXPECT_NEAR(images.col(5).norm(), 1, 1e-6);
  EXPECT_LT((std::sqrt(2.0f) * images.topRows(SpinImages::n_entries) - images_of(sphere)).norm(), 1e-5);
}

}  // namespace
}  // namespace shellmatch
