// What spectral matching reads of a surface does not depend on its position and size.
#include "alignment/spectrum/spectral_shape.h"
#include "tests/geometry/surface/test_surfaces.h"

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include <cmath>

namespace shellmatch {
namespace {

Surface<3> bean() {
  return test::mapped<3>(test::unit_sphere(4), [](const Vec<3>& x) {
    return Vec<3>(1.6 * x[0], x[1] * (1 + 0.2 * x[0]), 0.8 * x[2] + 0.3 * x[0] * x[0] + 0.1 * x[1]);
  });
}

AlignmentOptions few_functions() {
  AlignmentOptions options;
  options.functions = 40;
  return options;
}

TEST(SpectralShape, HasAreaOneAndItsCentreInTheOrigin) {
  const SpectralShape shape = make_spectral_shape(bean(), few_functions());
  EXPECT_NEAR(shape.mass.sum(), 1, 1e-12);
  Vec<3> centre = Vec<3>::Zero();
  for (std::size_t v = 0; v < shape.n_vertices(); ++v) centre += shape.mass[v] * shape.surface.vertices[v];
  EXPECT_LT(centre.norm(), 1e-12);
  EXPECT_LT((shape.in_input_coordinates(shape.surface.vertices[7]) - bean().vertices[7]).norm(), 1e-12);
}

TEST(SpectralShape, SpectrumAndSignatureDoNotChangeWithPositionAndSize) {
  const Mat<3> turn = Eigen::AngleAxisd(2, Vec<3>(1, 2, 3).normalized()).toRotationMatrix();
  const Surface<3> moved =
      test::mapped<3>(bean(), [&](const Vec<3>& x) { return Vec<3>(7 * turn * x + Vec<3>(100, 0, 3)); });
  const SpectralShape a = make_spectral_shape(bean(), few_functions()), b = make_spectral_shape(moved, few_functions());
  EXPECT_LT((a.values - b.values).cwiseAbs().maxCoeff(), 1e-7 * a.values.maxCoeff());
  EXPECT_LT((a.signature - b.signature).cwiseAbs().maxCoeff(), 1e-6);
}

TEST(SpectralShape, SmoothedCoordinatesApproachTheSurface) {
  const SpectralShape shape = make_spectral_shape(bean(), few_functions());
  const auto distance = [&](Eigen::Index k) {
    const Rows3 smooth = shape.functions.leftCols(k) * shape.coefficients.topRows(k);
    double sum = 0;
    for (std::size_t v = 0; v < shape.n_vertices(); ++v)
      sum += shape.mass[v] *
             (smooth.row(static_cast<Eigen::Index>(v)).transpose() - shape.surface.vertices[v]).squaredNorm();
    return std::sqrt(sum);
  };
  EXPECT_LT(distance(40), 0.005);
  EXPECT_LT(distance(20), 0.5 * distance(5));
}

TEST(SpectralShape, NormalsPointOutward) {
  const Surface<3> sphere = test::unit_sphere(4);
  const SpectralShape shape = make_spectral_shape(sphere, few_functions());
  for (std::size_t v = 0; v < sphere.vertices.size(); ++v)
    EXPECT_GT(shape.normals.row(static_cast<Eigen::Index>(v)).dot(sphere.vertices[v].transpose()), 0.999);
}

TEST(SpectralShape, TheMirroredShapeIsOrientedOutwardAndKnowsItsInput) {
  const SpectralShape shape = make_spectral_shape(bean(), few_functions()), mirrored = mirrored_shape(shape);
  EXPECT_NEAR(enclosed_measure(mirrored.surface), enclosed_measure(shape.surface), 1e-14);
  EXPECT_LT((mirrored.in_input_coordinates(mirrored.surface.vertices[9]) - bean().vertices[9]).norm(), 1e-12);
  const Rows3 normals = vertex_normals(mirrored.surface.facets, [&] {
    Rows3 rows(static_cast<Eigen::Index>(mirrored.n_vertices()), 3);
    for (std::size_t v = 0; v < mirrored.n_vertices(); ++v)
      rows.row(static_cast<Eigen::Index>(v)) = mirrored.surface.vertices[v];
    return rows;
  }());
  EXPECT_LT((normals - mirrored.normals).cwiseAbs().maxCoeff(), 1e-12);
}

}  // namespace
}  // namespace shellmatch
