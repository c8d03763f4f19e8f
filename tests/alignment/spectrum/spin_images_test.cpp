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
  return spin_images(surface, surface_laplacian(surface, 2e-3), 0.08);
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

}  // namespace
}  // namespace shellmatch
