#pragma once
/// \file
/// The map that carries the reference to the template, in whichever direction the matching was solved: where the
/// template was deformed the inverse of phi, which is kept from stretching what lies beside phi(M2).

#include "geometry/distance/nearest_facets.h"
#include "geometry/surface/surface.h"
#include "grid/inverse/inverse_map.h"
#include "grid/octree/octree.h"
#include "matching/level/deformation.h"

#include <optional>
#include <span>
#include <vector>

namespace shellmatch {

/// In the unit domain. Vertices of the reference that phi(M2) misses by a hundredth of a diagonal lie in space that phi
/// has compressed, between limbs that it brought together, and the inverse alone draws them out to spurs of a tenth.
/// Here a point that is d away from the nearest part of phi(M2) that faces its way, phi(p), stays where the inverse has
/// it up to 2 d from p; one that is drawn out farther comes to lie between 2 d and d from p, the nearer the more it was
/// drawn out. For this d counts more the larger it is, up to twice from two sides of the finest cells on, where a point
/// may be part of something that the other shape lacks: a limb that the inverse stretches fourfold stays as it is. A
/// tenth of a side is added to it.
template <int Dim>
class InverseCarrier {
 public:
  /// \param moving the shape that phi deforms \param grid, phi must outlive this object
  InverseCarrier(const Surface<Dim>& moving, const Octree<Dim>& grid, const std::vector<Vec<Dim>>& phi);
  InverseCarrier(const InverseCarrier&) = delete;
  InverseCarrier& operator=(const InverseCarrier&) = delete;

  /// \param normal of the surface at x, of any length; zero where unknown, where the inverse alone decides. \return
  /// none where x is no image
  std::optional<Vec<Dim>> operator()(const Vec<Dim>& x, const Vec<Dim>& normal) const;

  /// Points with their normals. One without an image moves as the nearest one that has one.
  std::vector<Vec<Dim>> carried(const std::vector<Vec<Dim>>& points, const std::vector<Vec<Dim>>& normals) const;

  Surface<Dim> operator()(const Surface<Dim>& surface) const {
    return {carried(surface.vertices, vertex_normals(surface)), surface.facets};
  }

 private:
  InverseMap<Dim> inverse_;
  Surface<Dim> moving_, moved_;  ///< subdivided to the finest cells
  OrientedFacets<Dim> facets_;   ///< of moved_
  double reach_;
  double slack_;  ///< as p is interpolated in facets, which phi bends
};

/// For each point the normal of the surface's nearest facet.
template <int Dim>
std::vector<Vec<Dim>> nearest_normals(const Surface<Dim>& surface, std::span<const Vec<Dim>> points);

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
