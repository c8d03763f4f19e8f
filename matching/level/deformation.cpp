#include "matching/level/deformation.h"

#include "grid/fields/interpolation.h"

namespace shellmatch {

template <int Dim>
Vec<Dim> Deformation<Dim>::apply_in_unit_domain(const Vec<Dim>& x) const {
  const Vec<Dim> inside = x.cwiseMax(0.0).cwiseMin(1.0);
  return evaluate(grid, phi, inside) + (x - inside);
}

template struct Deformation<2>;
template struct Deformation<3>;

}  // namespace shellmatch
