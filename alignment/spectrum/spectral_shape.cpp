#include "alignment/spectrum/spectral_shape.h"

#include "base/stop.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

namespace shellmatch {

Eigen::MatrixXd wave_kernel_signature(const LaplacianEigenpairs& pairs, const Eigen::VectorXd& mass, int n_energies) {
  // The constant function says nothing of a place, so that energies begin at the second eigenvalue.
  const Eigen::Index k = pairs.values.size() - 1;
  const Eigen::ArrayXd logs = pairs.values.tail(k).array().max(1e-12).log();
  const Eigen::MatrixXd squares = pairs.functions.rightCols(k).cwiseAbs2();
  const double low = logs[0], high = logs[k - 1];
  const double width = 7 * std::max(high - low, 1e-12) / n_energies;
  Eigen::MatrixXd signature(squares.rows(), n_energies);
  for (int e = 0; e < n_energies; ++e) {
    const double energy = low + (high - low) * e / std::max(1, n_energies - 1);
    const Eigen::VectorXd weights = (-(logs - energy).square() / (2 * width * width)).exp();
    signature.col(e) = squares * weights;
    signature.col(e) *= mass.sum() / mass.dot(signature.col(e));
  }
  return signature;
}

namespace {

// Which way feet and a face point decides between front and back; the smaller radius tells hands and feet where limbs
// come near, and draws points to where they belong: on 120 pairs of bodies maps err 6 % less than with the larger
// alone.
constexpr double spin_radii[] = {0.2, 0.1};

/// A vertex that depends on the shape alone, not on the order of its vertices or its position.
Index extreme_vertex(const LaplacianEigenpairs& pairs) {
  Eigen::Index at = 0;
  pairs.functions.col(1).cwiseAbs().maxCoeff(&at);
  return static_cast<Index>(at);
}

}  // namespace

SpectralShape mirrored_shape(SpectralShape shape) {
  shape.handedness *= -1;
  for (Vec<3>& x : shape.surface.vertices) x[0] *= -1;
  for (auto& facet : shape.surface.facets) std::swap(facet[1], facet[2]);
  shape.coefficients.col(0) *= -1;
  shape.normals.col(0) *= -1;
  return shape;
}

SpectralShape make_spectral_shape(Surface<3> surface, const AlignmentOptions& options) {
  const Activity activity("spectra");
  SurfaceLaplacian laplacian = surface_laplacian(surface, options.mollification);
  const double area = laplacian.mass.sum();
  Vec<3> centre = Vec<3>::Zero();
  for (std::size_t v = 0; v < surface.vertices.size(); ++v) centre += laplacian.mass[v] / area * surface.vertices[v];
  for (Vec<3>& x : surface.vertices) x = (x - centre) / std::sqrt(area);
  laplacian.mass /= area;
  const auto n = static_cast<int>(surface.vertices.size());
  const LaplacianEigenpairs pairs = least_eigenpairs(laplacian, std::min(options.functions, (n - 1) / 2));
  Rows3 coordinates(n, 3);
  for (int v = 0; v < n; ++v) coordinates.row(v) = surface.vertices[v];
  EdgeGraph graph(surface);
  std::vector<Index> samples = farthest_point_samples(graph, extreme_vertex(pairs), n_spectral_samples);
  Rows3 coefficients = pairs.functions.transpose() * laplacian.mass.asDiagonal() * coordinates;
  Rows3 normals = vertex_normals(surface.facets, coordinates);
  Eigen::MatrixXd signature = wave_kernel_signature(pairs, laplacian.mass, 50);
  Eigen::MatrixXf spin = spin_images(surface, laplacian, spin_radii);
  std::vector<SurfaceTip> tips = surface_tips(graph, samples);
  return {std::move(surface), std::move(graph),        std::move(laplacian.mass), pairs.values,
          pairs.functions,    std::move(coefficients), std::move(normals),        std::move(signature),
          std::move(spin),    std::move(samples),      std::move(tips),           centre,
          std::sqrt(area)};
}

namespace {

Columns4 normals_of(std::span<const std::array<Index, 3>> facets, const Columns4& coordinates) {
  Columns4 normals = Columns4::Zero(4, coordinates.cols());
  for (const auto& [a, b, c] : facets) {
    const Eigen::Vector4f origin = coordinates.col(a);
    const Eigen::Vector4f u = coordinates.col(b) - origin, v = coordinates.col(c) - origin;
    const Eigen::Vector4f normal = u.cross3(v);
    for (const Index corner : {a, b, c}) normals.col(corner) += normal;
  }
  for (Eigen::Index i = 0; i < normals.cols(); ++i) {
    const float length = normals.col(i).norm();
    if (length > 0) normals.col(i) /= length;
  }
  return normals;
}

}  // namespace

SmoothedSurfaces::SmoothedSurfaces(const SpectralShape& shape, int n_functions)
    : shape_(&shape), data_(std::make_shared<Data>()) {
  data_->functions = shape.functions.leftCols(n_functions).cast<float>();
  data_->entries = std::vector<Entry>(static_cast<std::size_t>(n_functions) + 1);
}

SmoothedSurface SmoothedSurfaces::combined(const Rows3& coefficients,
                                           std::span<const std::array<Index, 3>> facets) const {
  Eigen::Matrix<float, Eigen::Dynamic, 4> padded =
      Eigen::Matrix<float, Eigen::Dynamic, 4>::Zero(coefficients.rows(), 4);
  padded.leftCols(3) = coefficients.cast<float>();
  const Eigen::Matrix<float, Eigen::Dynamic, 4> rows = data_->functions.leftCols(coefficients.rows()) * padded;
  SmoothedSurface surface;
  surface.coordinates = rows.transpose();
  surface.normals = normals_of(facets, surface.coordinates);
  return surface;
}

const SmoothedSurface& SmoothedSurfaces::with(int k) const {
  Entry& entry = data_->entries[static_cast<std::size_t>(k)];
  std::call_once(entry.is_known,
                 [&] { entry.surface = combined(shape_->coefficients.topRows(k), shape_->surface.facets); });
  return entry.surface;
}

}  // namespace shellmatch
