#include "matching/level/deformation.h"

#include "base/parallel.h"
#include "grid/fields/interpolation.h"
#include "grid/octree/constraints.h"

#include <Eigen/LU>

namespace shellmatch {

template <int Dim>
std::vector<Vec<Dim>> sampled_map(const Deformation<Dim>& map, const Octree<Dim>& grid) {
  std::vector<Vec<Dim>> phi(static_cast<std::size_t>(grid.n_nodes()));
  parallel_for(phi.size(),
               [&](std::size_t i) { phi[i] = map.apply_in_unit_domain(grid.node_position(static_cast<Index>(i))); });
  distribute(grid, phi);
  return phi;
}

template <int Dim>
Surface<Dim> deformed_surface(const Surface<Dim>& surface, const Octree<Dim>& grid, const std::vector<Vec<Dim>>& phi) {
  Surface<Dim> deformed = surface;
  parallel_for(deformed.vertices.size(),
               [&](std::size_t i) { deformed.vertices[i] = evaluate(grid, phi, surface.vertices[i]); });
  return deformed;
}

template <int Dim>
Vec<Dim> Deformation<Dim>::apply_in_unit_domain(const Vec<Dim>& x) const {
  const Vec<Dim> inside = x.cwiseMax(0.0).cwiseMin(1.0);
  return evaluate(grid, phi, inside) + (x - inside);
}

template <int Dim>
Mat<Dim> Deformation<Dim>::jacobian_in_unit_domain(const Vec<Dim>& x) const {
  Mat<Dim> jacobian = evaluate_gradient<Dim>(grid, phi, locate_local(grid, x));
  for (int k = 0; k < Dim; ++k)
    if (x[k] < 0 || x[k] > 1) jacobian.col(k) = Vec<Dim>::Unit(k);
  return jacobian;
}

template <int Dim>
std::optional<Mat<Dim>> PointMap<Dim>::jacobian(const Vec<Dim>& x) const {
  if (!inverse_) return map_->jacobian(x);
  const std::optional<Vec<Dim>> preimage = (*inverse_)(x);
  if (!preimage) return std::nullopt;
  const Mat<Dim> forward = map_->jacobian(*preimage);
  if (forward.determinant() == 0) return std::nullopt;
  return Mat<Dim>(forward.inverse());
}

SHELLMATCH_2D_3D(deformed_surface);
template struct Deformation<2>;
template struct Deformation<3>;
template class PointMap<2>;
template class PointMap<3>;
SHELLMATCH_2D_3D(sampled_map);

}  // namespace shellmatch
