#include "alignment/spectrum/smoothed_surface.h"

#include <Eigen/Geometry>

namespace shellmatch {

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
