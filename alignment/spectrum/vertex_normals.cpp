#include "alignment/spectrum/vertex_normals.h"

#include <Eigen/Geometry>

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

}  // namespace shellmatch
