// The Laplacian of a mesh: identities of linear finite elements, the spectrum of the sphere, slivers.
#include "alignment/spectrum/laplacian.h"
#include "base/error.h"
#include "tests/geometry/surface/test_surfaces.h"

#include <gtest/gtest.h>

#include <cmath>

namespace shellmatch {
namespace {

Surface<3> bumpy() {
  return test::mapped<3>(test::unit_sphere(3), [](const Vec<3>& x) {
    return Vec<3>(x * (1 + 0.3 * std::sin(3 * x[0]) * std::cos(4 * x[1] + x[2])));
  });
}

TEST(Laplacian, RowsSumToZeroAndTheMatrixIsSymmetric) {
  const SurfaceLaplacian laplacian = surface_laplacian(bumpy(), 2e-3);
  const Eigen::VectorXd ones = Eigen::VectorXd::Ones(laplacian.mass.size());
  EXPECT_LT((laplacian.stiffness * ones).cwiseAbs().maxCoeff(), 1e-13);
  const Eigen::SparseMatrix<double> transposed = laplacian.stiffness.transpose();
  EXPECT_EQ((laplacian.stiffness - transposed).norm(), 0);
}

TEST(Laplacian, EnergiesOfTheCoordinatesAddUpToTwiceTheArea) {
  // The gradients of the three coordinates along a surface have squares that add up to 2 everywhere.
  const Surface<3> surface = bumpy();
  const SurfaceLaplacian laplacian = surface_laplacian(surface, 0);
  double energy = 0;
  for (int k = 0; k < 3; ++k) {
    Eigen::VectorXd x(laplacian.mass.size());
    for (Eigen::Index v = 0; v < x.size(); ++v) x[v] = surface.vertices[static_cast<std::size_t>(v)][k];
    energy += x.dot(laplacian.stiffness * x);
  }
  EXPECT_NEAR(energy, 2 * test::boundary_measure(surface), 1e-12 * energy);
  EXPECT_NEAR(laplacian.mass.sum(), test::boundary_measure(surface), 1e-12);
}

TEST(Laplacian, EigenvaluesOfASphereConvergeWithSecondOrder) {
  const double radius = 1.7;
  const auto errors = [&](int level) {
    const Surface<3> sphere =
        test::mapped<3>(test::unit_sphere(level), [&](const Vec<3>& x) { return Vec<3>(radius * x); });
    const Eigen::VectorXd values = least_eigenpairs(surface_laplacian(sphere, 2e-3), 16).values;
    EXPECT_LT(values[0], 1e-9);
    Eigen::VectorXd error(15);
    int at = 1;
    for (int l = 1; l <= 3; ++l)
      for (int m = 0; m < 2 * l + 1; ++m, ++at) error[at - 1] = std::abs(values[at] - l * (l + 1) / (radius * radius));
    return error;
  };
  const Eigen::VectorXd coarse = errors(3), fine = errors(4);
  for (Eigen::Index i = 0; i < fine.size(); ++i) {
    EXPECT_LT(fine[i], 0.02 * 12 / (radius * radius)) << i;
    EXPECT_GT(std::log2(coarse[i] / fine[i]), 1.8) << i;
  }
}

TEST(Laplacian, EigenfunctionsAreOrthonormalAndSolveTheEquation) {
  const SurfaceLaplacian laplacian = surface_laplacian(bumpy(), 2e-3);
  const LaplacianEigenpairs pairs = least_eigenpairs(laplacian, 30);
  const Eigen::MatrixXd gram = pairs.functions.transpose() * laplacian.mass.asDiagonal() * pairs.functions;
  EXPECT_LT((gram - Eigen::MatrixXd::Identity(30, 30)).cwiseAbs().maxCoeff(), 1e-9);
  const Eigen::MatrixXd residual =
      laplacian.stiffness * pairs.functions - laplacian.mass.asDiagonal() * pairs.functions * pairs.values.asDiagonal();
  EXPECT_LT(residual.cwiseAbs().maxCoeff(), 1e-7);
  for (Eigen::Index i = 1; i < 30; ++i) EXPECT_GE(pairs.values[i], pairs.values[i - 1]);
}

TEST(Laplacian, MollificationLeavesWellShapedTrianglesAsTheyAre) {
  const Surface<3> surface = bumpy();
  const std::vector<Vec<3>> without = mollified_edge_lengths(surface, 0), with = mollified_edge_lengths(surface, 2e-3);
  for (std::size_t f = 0; f < with.size(); ++f) EXPECT_EQ(with[f], without[f]);
}

TEST(Laplacian, MollificationMakesFlatTrianglesProper) {
  const Surface<3> surface = test::wedge_with_flat_triangle(0.3);
  const double mollification = 2e-3;
  double mean = 0;
  for (const Vec<3>& l : mollified_edge_lengths(surface, 0))
    mean += l.mean() / static_cast<double>(surface.facets.size());
  for (const Vec<3>& l : mollified_edge_lengths(surface, mollification))
    EXPECT_GE(l.sum() - 2 * l.maxCoeff(), mollification * mean * (1 - 1e-9));
  const SurfaceLaplacian laplacian = surface_laplacian(surface, mollification);
  EXPECT_TRUE(Eigen::MatrixXd(laplacian.stiffness).allFinite());
  EXPECT_GT(laplacian.mass.minCoeff(), 0);
}

TEST(Laplacian, CoordinatesThatAreNotFiniteAreRefused) {
  Surface<3> surface = bumpy();
  surface.vertices[5][1] = std::nan("");
  EXPECT_THROW(least_eigenpairs(surface_laplacian(surface, 2e-3), 10), InputError);
}

}  // namespace
}  // namespace shellmatch
