#pragma once
/// \file
/// The map that carries the reference to the template, in whichever direction the matching was solved.

#include "geometry/surface/surface.h"
#include "matching/level/deformation.h"
#include "matching/result/inverse_carrier.h"

#include <optional>
#include <vector>

namespace shellmatch {

template <int Dim>
class ReferenceMap {
 public:
  /// \param moving the shape that phi deforms where that is the template, unit domain; null where phi deforms the
  /// reference \param grid, phi must outlive this object
  ReferenceMap(const Surface<Dim>* moving, const Octree<Dim>& grid, const std::vector<Vec<Dim>>& phi)
      : grid_(&grid), phi_(&phi) {
    if (moving) inverse_.emplace(*moving, grid, phi);
  }

  /// In the unit domain.
  Surface<Dim> operator()(const Surface<Dim>& surface) const {
    return inverse_ ? (*inverse_)(surface) : deformed_surface(surface, *grid_, *phi_);
  }

  /// Points of the reference as it was read, in the user's coordinates. \param frame how this map lies in them
  /// \param reference in the unit domain; tells which way the points face
  std::vector<Vec<Dim>> carried(std::vector<Vec<Dim>> points, const Deformation<Dim>& frame,
                                const Surface<Dim>& reference) const;

  double finest_side() const { return grid_->finest_side(); }

 private:
  const Octree<Dim>* grid_;
  const std::vector<Vec<Dim>>* phi_;
  std::optional<InverseCarrier<Dim>> inverse_;
};

}  // namespace shellmatch
