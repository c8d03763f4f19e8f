// What a surface looks like around a vertex: exact curvature on spheres, independence of position and pose, difference between front and back.
#include "alignment/spectrum/local_descriptors.h"

#include "alignment/spectrum/spectral_shape.h"
#include "tests/geometry/surface/test_surfaces.h"

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include <cmath>

namespace shellmatch {
namespace {

LocalDescriptors descriptors_of(const Surface<3>& surface) { return local_descriptors(surface, surface_laplacian(surface, 2e-3)); }

Surface<3> sphere_of_area_one(int n) {
  const double radius = std::sqrt(surface_measure(test::unit_sphere(n)));
  return test::mapped<3>(test::unit_sphere(n), [&](const Vec<3>& x) { return Vec<3>(x / radius); });
}

TEST(LocalDescriptors, AStepOfHeatFlowShrinksASphereByItsCurvature) {
  // x_t = x / (1 + 2 t / R^2), so that n . (x - x_t) / sqrt t = 2 sqrt t / R / (1 + 2 t / R^2).
  const Surface<3> sphere = sphere_of_area_one(5);
  const double t = 6e-4, r = sphere.vertices[0].norm();
  const double exact = 2 * std::sqrt(t) / r / (1 + 2 * t / (r * r));
  const LocalDescriptors local = descriptors_of(sphere);
  EXPECT_NEAR(local.curvature.mean(), exact, 0.01 * exact);
  EXPECT_LT((local.curvature.array() - exact).abs().maxCoeff(), 0.05 * exact);
}

TEST(LocalDescriptors, DoNotChangeWithThePositionAndTheOrderOfVertices) {
  const Surface<3> bean = test::mapped<3>(sphere_of_area_one(4), [](const Vec<3>& x) { return Vec<3>(x[0], x[1] * (1 + x[0]), x[2] + x[0] * x[0]); });
  const Mat<3> turn = Eigen::AngleAxisd(2, Vec<3>(1, 2, 3).normalized()).toRotationMatrix();
  const LocalDescriptors a = descriptors_of(bean),
                         b = descriptors_of(test::mapped<3>(bean, [&](const Vec<3>& x) { return Vec<3>(turn * x + Vec<3>(5, 0, 1)); }));
  EXPECT_LT((a.curvature - b.curvature).cwiseAbs().maxCoeff(), 1e-9);
  // A neighbour at the border of two bins may change sides by rounding.
  EXPECT_LT((a.spin - b.spin).squaredNorm() / static_cast<float>(a.spin.cols()), 1e-3);
  EXPECT_NEAR(a.spin.col(17).norm(), 1, 1e-6);
}

TEST(LocalDescriptors, TellADentFromABump) {
  const auto deformed = [](double height) {
    return test::mapped<3>(sphere_of_area_one(5), [&](const Vec<3>& x) {
      return Vec<3>(x * (1 + height * std::exp(-(x - Vec<3>(0, 0, x.norm())).squaredNorm() / 2e-3)));
    });
  };
  const Surface<3> sphere = sphere_of_area_one(5);
  Eigen::Index pole = 0;
  for (std::size_t v = 0; v < sphere.vertices.size(); ++v)
    if (sphere.vertices[v][2] > sphere.vertices[static_cast<std::size_t>(pole)][2]) pole = static_cast<Eigen::Index>(v);
  const LocalDescriptors bump = descriptors_of(deformed(0.08)), dent = descriptors_of(deformed(-0.08));
  EXPECT_GT(bump.curvature[pole], 0);
  EXPECT_LT(dent.curvature[pole], 0);
  EXPECT_GT((bump.spin.col(pole) - dent.spin.col(pole)).squaredNorm(), 0.5);
}

}  // namespace
}  // namespace shellmatch
