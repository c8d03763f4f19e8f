#include "alignment/spectrum/spin_images.h"

#include "base/error.h"
#include "base/parallel.h"

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <Eigen/SparseCholesky>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <utility>

namespace shellmatch {

Rows3 vertex_normals(const std::vector<std::array<Index, 3>>& facets, const Rows3& coordinates) {
  Rows3 normals = Rows3::Zero(coordinates.rows(), 3);
  for (const auto& [a, b, c] : facets) {
    const Vec<3> origin = coordinates.row(a);
    const Vec<3> u = coordinates.row(b).transpose() - origin, v = coordinates.row(c).transpose() - origin;
    const Vec<3> normal = u.cross(v);
    for (const Index corner : {a, b, c}) normals.row(corner) += normal;
  }
  for (Eigen::Index i = 0; i < normals.rows(); ++i) {
    const double length = normals.row(i).norm();
    if (length > 0) normals.row(i) /= length;
  }
  return normals;
}

namespace {

constexpr double smoothing_time = 6e-4;  // heat flow over about 0.05 roots of the area
constexpr int n_radii = 3, n_heights = 4, n_angles = 8;
static_assert(n_radii == 3 && n_radii * n_heights * n_angles == SpinImages::n_entries);

/// Which entry counts a neighbour. \param square, height of its offset, in radii
int entry_of(double square, double height, double cosine) {
  const int r = (9 * square >= 1 ? 1 : 0) + (9 * square >= 4 ? 1 : 0);
  const int h = std::clamp(static_cast<int>((height + 1) * (0.5 * n_heights)), 0, n_heights - 1);
  const int a = std::clamp(static_cast<int>((cosine + 1) * (0.5 * n_angles)), 0, n_angles - 1);
  return (r * n_heights + h) * n_angles + a;
}

/// After a step of implicit heat flow, of unit length.
Rows3 smoothed(const Rows3& normals, const SurfaceLaplacian& laplacian) {
  Eigen::SparseMatrix<double> matrix = smoothing_time * laplacian.stiffness;
  matrix.diagonal() += laplacian.mass;
  const Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> factor(matrix);
  if (factor.info() != Eigen::Success) throw_input_error("the Laplacian of the surface cannot be factorised");
  return factor.solve(laplacian.mass.asDiagonal() * normals).rowwise().normalized();
}

/// The vertices in ascending order of one coordinate, in which those near a vertex lie together.
std::vector<Index> order_along(const Rows3& coordinates, int axis) {
  std::vector<Index> order(static_cast<std::size_t>(coordinates.rows()));
  std::iota(order.begin(), order.end(), 0);
  std::sort(order.begin(), order.end(),
            [&](Index a, Index b) { return std::pair(coordinates(a, axis), a) < std::pair(coordinates(b, axis), b); });
  return order;
}

// The fewer are that far away along one axis, the better.
int longest_axis(const Rows3& coordinates) {
  if (coordinates.rows() == 0) return 0;
  int axis = 0;
  (coordinates.colwise().maxCoeff() - coordinates.colwise().minCoeff()).maxCoeff(&axis);
  return axis;
}

}  // namespace

SpinImages::SpinImages(const Rows3& coordinates, const Rows3& normals, const Eigen::VectorXd& areas, double radius)
    : axis_(longest_axis(coordinates)),
      radius_(radius),
      order_(order_along(coordinates, axis_)),
      position_(order_.size()),
      coordinates_(coordinates.rows(), 3),
      normals_(coordinates.rows(), 3),
      areas_(coordinates.rows()) {
  for (std::size_t k = 0; k < order_.size(); ++k) {
    const Index v = order_[k];
    const auto at = static_cast<Eigen::Index>(k);
    position_[static_cast<std::size_t>(v)] = at;
    coordinates_.row(at) = coordinates.row(v);
    normals_.row(at) = normals.row(v);
    areas_[at] = static_cast<float>(areas[v]);
  }
}

// The entries are computed for many at a time, without branches, and then counted.
void SpinImages::compute(Index point, Eigen::Ref<Eigen::VectorXf> image) const {
  constexpr Eigen::Index at_once = 128;
  constexpr int outside = n_entries;
  const Eigen::Index at = position_[static_cast<std::size_t>(point)], n = coordinates_.rows();
  const Vec<3> x = coordinates_.row(at), normal = normals_.row(at);
  const double *along = &coordinates_(0, axis_), *px = &coordinates_(0, 0), *py = &coordinates_(0, 1),
               *pz = &coordinates_(0, 2);
  const double *nx = &normals_(0, 0), *ny = &normals_(0, 1), *nz = &normals_(0, 2);
  const auto begin = std::upper_bound(along, along + at, x[axis_] - radius_) - along;
  const auto end = std::lower_bound(along + at, along + n, x[axis_] + radius_) - along;
  const double radius2 = radius_ * radius_, per_radius = 1 / radius_;
  std::array<float, n_entries + 1> sums{};
  std::array<int, at_once> entries;
  for (Eigen::Index first = begin; first < end; first += at_once) {
    const Eigen::Index count = std::min(at_once, end - first);
    for (Eigen::Index i = 0; i < count; ++i) {
      const Eigen::Index k = first + i;
      const double dx = px[k] - x[0], dy = py[k] - x[1], dz = pz[k] - x[2];
      const double square = dx * dx + dy * dy + dz * dz;
      const double height = (dx * normal[0] + dy * normal[1] + dz * normal[2]) * per_radius;
      const double cosine = nx[k] * normal[0] + ny[k] * normal[1] + nz[k] * normal[2];
      const int entry = entry_of(square * per_radius * per_radius, height, cosine);
      entries[static_cast<std::size_t>(i)] = square < radius2 ? entry : outside;
    }
    for (Eigen::Index i = 0; i < count; ++i)
      sums[static_cast<std::size_t>(entries[static_cast<std::size_t>(i)])] += areas_[first + i];
  }
  image = Eigen::Map<const Eigen::VectorXf>(sums.data(), n_entries);
  image = (image / image.sum()).cwiseSqrt();
}

namespace {

/// Spin images of what can be reached from a vertex along edges without leaving the ball around it.
class ConnectedSpinImages {
 public:
  ConnectedSpinImages(const Rows3& coordinates, const Rows3& normals, const SurfaceLaplacian& laplacian)
      : coordinates_(coordinates.transpose()), normals_(normals.transpose()), laplacian_(laplacian) {}

  /// \param seen an entry for each vertex, none of them `point` before
  void compute(Index point, double radius, std::vector<Index>& seen, Eigen::Ref<Eigen::VectorXf> image) const {
    image.setZero();
    const Vec<3> x = coordinates_.col(point), normal = normals_.col(point);
    const double per_radius = 1 / radius;
    std::vector<Index> open{point};
    seen[point] = point;
    while (!open.empty()) {
      const Index v = open.back();
      open.pop_back();
      const Vec<3> offset = (coordinates_.col(v) - x) * per_radius;
      image[entry_of(offset.squaredNorm(), offset.dot(normal), normals_.col(v).dot(normal))] +=
          static_cast<float>(laplacian_.mass[v]);
      // The Laplacian has an entry for every edge.
      for (Eigen::SparseMatrix<double>::InnerIterator it(laplacian_.stiffness, v); it; ++it) {
        const auto w = static_cast<Index>(it.row());
        if (seen[w] == point) continue;
        seen[w] = point;
        if ((coordinates_.col(w) - x).squaredNorm() < radius * radius) open.push_back(w);
      }
    }
    image = (image / image.sum()).cwiseSqrt();
  }

 private:
  Eigen::Matrix3Xd coordinates_, normals_;
  const SurfaceLaplacian& laplacian_;
};

}  // namespace

Eigen::MatrixXf spin_images(const Surface<3>& surface, const SurfaceLaplacian& laplacian,
                            std::span<const double> radii) {
  const std::size_t n = surface.vertices.size();
  Rows3 coordinates(static_cast<Eigen::Index>(n), 3);
  for (std::size_t v = 0; v < n; ++v) coordinates.row(static_cast<Eigen::Index>(v)) = surface.vertices[v];
  const Rows3 normals = smoothed(vertex_normals(surface.facets, coordinates), laplacian);
  const ConnectedSpinImages spin(coordinates, normals, laplacian);
  constexpr Eigen::Index n_entries = SpinImages::n_entries;
  Eigen::MatrixXf images(n_entries * static_cast<Eigen::Index>(radii.size()), static_cast<Eigen::Index>(n));
  parallel_chunks(n, 512, [&](const Chunk& chunk) {
    std::vector<Index> seen(n, no_index);
    for (std::size_t k = 0; k < radii.size(); ++k) {
      std::ranges::fill(seen, no_index);
      for (std::size_t v = chunk.begin; v < chunk.end; ++v)
        spin.compute(
            static_cast<Index>(v), radii[k], seen,
            images.col(static_cast<Eigen::Index>(v)).segment(n_entries * static_cast<Eigen::Index>(k), n_entries));
    }
  });
  return images / std::sqrt(static_cast<float>(radii.size()));
}

Eigen::MatrixXf main_components(std::span<const Eigen::MatrixXf* const> images,
                                std::span<const Eigen::VectorXd* const> masses, Eigen::Index n) {
  const Eigen::Index n_entries = images[0]->rows();
  const double share = 1 / static_cast<double>(images.size());
  Eigen::MatrixXd products = Eigen::MatrixXd::Zero(n_entries, n_entries);
  Eigen::VectorXd mean = Eigen::VectorXd::Zero(n_entries);
  for (std::size_t s = 0; s < images.size(); ++s) {
    const Eigen::MatrixXd image = images[s]->cast<double>();
    mean += share * image * *masses[s];
    products += share * image * masses[s]->asDiagonal() * image.transpose();
  }
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(products - mean * mean.transpose());
  return solver.eigenvectors().rightCols(n).cast<float>();
}

}  // namespace shellmatch
