#include "alignment/spectrum/spin_images.h"

#include "base/error.h"
#include "base/parallel.h"

#include <Eigen/SparseCholesky>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

namespace shellmatch {

namespace {

constexpr double smoothing_time = 6e-4;  // heat flow over about 0.05 roots of the area
constexpr int n_radii = 3, n_heights = 4, n_angles = 8;
static_assert(n_radii * n_heights * n_angles == SpinImages::n_entries);

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
  std::sort(order.begin(), order.end(),
            [&](Index a, Index b) { return std::pair(coordinates(a, 0), a) < std::pair(coordinates(b, 0), b); });
  return order;
}

}  // namespace

SpinImages::SpinImages(Rows3 coordinates, Rows3 normals, Eigen::VectorXd areas, double radius)
    : coordinates_(std::move(coordinates)),
      normals_(std::move(normals)),
      areas_(std::move(areas)),
      radius_(radius),
      order_(order_along_x(coordinates_)),
      position_(order_.size()) {
  for (std::size_t k = 0; k < order_.size(); ++k)
    position_[static_cast<std::size_t>(order_[k])] = static_cast<Index>(k);
}

void SpinImages::compute(Index point, Eigen::Ref<Eigen::VectorXf> image) const {
  const Vec<3> x = coordinates_.row(point), n = normals_.row(point);
  const auto at = static_cast<std::size_t>(position_[static_cast<std::size_t>(point)]);
  image.setZero();
  const auto add = [&](Index other) {
    const Vec<3> d = coordinates_.row(other).transpose() - x;
    if (d.squaredNorm() >= radius_ * radius_) return;
    const int r = bin(d.norm() / radius_, n_radii), h = bin((d.dot(n) / radius_ + 1) / 2, n_heights);
    const int a = bin((normals_.row(other).dot(n) + 1) / 2, n_angles);
    image[(r * n_heights + h) * n_angles + a] += static_cast<float>(areas_[other]);
  };
  for (std::size_t k = at; k < order_.size() && coordinates_(order_[k], 0) - x[0] < radius_; ++k) add(order_[k]);
  for (std::size_t k = at; k-- > 0 && x[0] - coordinates_(order_[k], 0) < radius_;) add(order_[k]);
  image = (image / image.sum()).cwiseSqrt();
}

Eigen::MatrixXf spin_images(const Surface<3>& surface, const SurfaceLaplacian& laplacian, double radius) {
  Rows3 coordinates(static_cast<Eigen::Index>(surface.vertices.size()), 3);
  for (std::size_t v = 0; v < surface.vertices.size(); ++v)
    coordinates.row(static_cast<Eigen::Index>(v)) = surface.vertices[v];
  Rows3 normals = smoothed(vertex_normals(surface.facets, coordinates), laplacian);
  const SpinImages spin(std::move(coordinates), std::move(normals), laplacian.mass, radius);
  Eigen::MatrixXf images(SpinImages::n_entries, static_cast<Eigen::Index>(surface.vertices.size()));
  parallel_for(spin.order().size(), [&](std::size_t k) {
    const Index v = spin.order()[k];
    spin.compute(v, images.col(v));
  });
  return images;
}

}  // namespace shellmatch
