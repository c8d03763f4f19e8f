#include "alignment/spectrum/spin_images.h"

#include "alignment/spectrum/vertex_normals.h"
#include "base/error.h"
#include "base/parallel.h"

#include <Eigen/SparseCholesky>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace shellmatch {

namespace {

constexpr double smoothing_time = 6e-4;  // heat flow over about 0.05 roots of the area
constexpr int n_radii = 3, n_heights = 4, n_angles = 8;

/// After a step of implicit heat flow, of unit length.
Rows3 smoothed(const Rows3& normals, const SurfaceLaplacian& laplacian) {
  Eigen::SparseMatrix<double> matrix = smoothing_time * laplacian.stiffness;
  matrix.diagonal() += laplacian.mass;
  const Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> factor(matrix);
  if (factor.info() != Eigen::Success) throw_input_error("the Laplacian of the surface cannot be factorised");
  return factor.solve(laplacian.mass.asDiagonal() * normals).rowwise().normalized();
}

int bin(double position, int n) { return std::clamp(static_cast<int>(position * n), 0, n - 1); }

/// The vertices in ascending order of their first coordinate, in which those near a vertex lie together.
std::vector<Index> order_along_x(const Rows3& coordinates) {
  std::vector<Index> order(static_cast<std::size_t>(coordinates.rows()));
  std::iota(order.begin(), order.end(), 0);
  std::sort(order.begin(), order.end(), [&](Index a, Index b) { return std::pair(coordinates(a, 0), a) < std::pair(coordinates(b, 0), b); });
  return order;
}

}  // namespace

Eigen::MatrixXf spin_images(const Surface<3>& surface, const SurfaceLaplacian& laplacian, double radius) {
  Rows3 coordinates(static_cast<Eigen::Index>(surface.vertices.size()), 3);
  for (std::size_t v = 0; v < surface.vertices.size(); ++v) coordinates.row(static_cast<Eigen::Index>(v)) = surface.vertices[v];
  const Rows3 normals = smoothed(vertex_normals(surface.facets, coordinates), laplacian);
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
      image[(r * n_heights + h) * n_angles + a] += static_cast<float>(laplacian.mass[w]);
    };
    for (std::size_t k = at; k < order.size() && coordinates(order[k], 0) - x[0] < radius; ++k) add(k);
    for (std::size_t k = at; k-- > 0 && x[0] - coordinates(order[k], 0) < radius;) add(k);
    image = (image / image.sum()).cwiseSqrt();
  });
  return images;
}

}  // namespace shellmatch
