#include "alignment/spectrum/local_descriptors.h"

#include "alignment/spectrum/vertex_normals.h"
#include "base/error.h"
#include "base/parallel.h"
#include "geometry/distance/surface_distance.h"

#include <Eigen/SparseCholesky>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace shellmatch {

namespace {

constexpr double smoothing_time = 6e-4;  // heat flow over about 0.05 roots of the area
constexpr double radius = 0.08;
constexpr int n_radii = 3, n_heights = 4, n_angles = 8;

/// Coordinates and normals after a step of implicit heat flow.
struct Smoothed {
  Rows3 coordinates, normals;
};

Smoothed smooth(const Rows3& coordinates, const Rows3& normals, const SurfaceLaplacian& laplacian) {
  Eigen::SparseMatrix<double> matrix = smoothing_time * laplacian.stiffness;
  matrix.diagonal() += laplacian.mass;
  const Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> factor(matrix);
  if (factor.info() != Eigen::Success) throw_input_error("the Laplacian of the surface cannot be factorised");
  Eigen::MatrixXd right(coordinates.rows(), 6);
  right << coordinates, normals;
  const Eigen::MatrixXd solution = factor.solve(laplacian.mass.asDiagonal() * right);
  return {solution.leftCols(3), solution.rightCols(3).rowwise().normalized()};
}

Eigen::VectorXd clipped(Eigen::VectorXd curvature) {
  std::vector<double> sizes(static_cast<std::size_t>(curvature.size()));
  std::transform(curvature.begin(), curvature.end(), sizes.begin(), [](double h) { return std::abs(h); });
  const double most = quantile(std::move(sizes), 0.98);
  return curvature.cwiseMax(-most).cwiseMin(most);
}

int bin(double position, int n) { return std::clamp(static_cast<int>(position * n), 0, n - 1); }

/// The vertices in ascending order of their first coordinate, in which those near a vertex lie together.
std::vector<Index> order_along_x(const Rows3& coordinates) {
  std::vector<Index> order(static_cast<std::size_t>(coordinates.rows()));
  std::iota(order.begin(), order.end(), 0);
  std::sort(order.begin(), order.end(), [&](Index a, Index b) { return std::pair(coordinates(a, 0), a) < std::pair(coordinates(b, 0), b); });
  return order;
}

Eigen::MatrixXf spin_images(const Rows3& coordinates, const Rows3& normals, const Eigen::VectorXd& mass) {
  const std::vector<Index> order = order_along_x(coordinates);
  Eigen::MatrixXf images = Eigen::MatrixXf::Zero(n_radii * n_heights * n_angles, coordinates.rows());
  parallel_for(order.size(), [&](std::size_t at) {
    const Index v = order[at];
    const Vec<3> x = coordinates.row(v), n = normals.row(v);
    auto image = images.col(v);
    const auto add = [&](std::size_t other) {
      const Index w = order[other];
      const Vec<3> d = coordinates.row(w).transpose() - x;
      if (d.squaredNorm() >= radius * radius) return;
      const int r = bin(d.norm() / radius, n_radii), h = bin((d.dot(n) / radius + 1) / 2, n_heights);
      const int a = bin((normals.row(w).dot(n) + 1) / 2, n_angles);
      image[(r * n_heights + h) * n_angles + a] += static_cast<float>(mass[w]);
    };
    for (std::size_t k = at; k < order.size() && coordinates(order[k], 0) - x[0] < radius; ++k) add(k);
    for (std::size_t k = at; k-- > 0 && x[0] - coordinates(order[k], 0) < radius;) add(k);
    image = (image / image.sum()).cwiseSqrt();
  });
  return images;
}

}  // namespace

LocalDescriptors local_descriptors(const Surface<3>& surface, const SurfaceLaplacian& laplacian) {
  Rows3 coordinates(static_cast<Eigen::Index>(surface.vertices.size()), 3);
  for (std::size_t v = 0; v < surface.vertices.size(); ++v) coordinates.row(static_cast<Eigen::Index>(v)) = surface.vertices[v];
  const Smoothed smoothed = smooth(coordinates, vertex_normals(surface.facets, coordinates), laplacian);
  const Eigen::VectorXd curvature = (smoothed.normals.cwiseProduct(coordinates - smoothed.coordinates)).rowwise().sum() / std::sqrt(smoothing_time);
  return {clipped(curvature), spin_images(coordinates, smoothed.normals, laplacian.mass)};
}

}  // namespace shellmatch
