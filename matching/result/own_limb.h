#pragma once
/// \file
/// Where limbs touch, a map of space may carry a vertex next to another limb than the one it belongs to.

#include "geometry/surface/surface.h"
#include "matching/level/deformation.h"
#include "matching/pairs/landmarks.h"

#include <vector>

namespace shellmatch {

/// A point of the reference and the point of the template that corresponds to it, as a search has found them.
struct SurfacePair {
  Vec<3> on_reference, on_template;
};

/// Lays carried points on their own limbs. A point is beside its limb if the facet or the vertex of the template that
/// is nearest to it lies farther than 0.15 along the surface from the partner of the nearest pair. If its facet does,
/// it moves to the nearest that does not; then towards a vertex of that limb until this one is the nearest. Points
/// farther than 0.05 from their limb stay, and so do those without a pair within 0.1 along the reference, and all if
/// more than a third are beside their limbs: the map does not follow the pairs then. Lengths are in square roots of the
/// template's area (along the reference of its own). \param reference, template_shape closed surfaces \param pairs
/// points of these \param points of the reference, in its coordinates \param carried the same points moved onto the
/// template; changed \return number of points that were moved
std::size_t lay_on_own_limbs(const Surface<3>& reference, const Surface<3>& template_shape,
                             const std::vector<SurfacePair>& pairs, const std::vector<Vec<3>>& points,
                             std::vector<Vec<3>>& carried);

/// Closed surfaces in the unit domain, as they lie before the bend.
struct PlacedSurfaces {
  const Surface<3>&reference, &template_shape;
};

/// The same for what is in the user's coordinates. \param pairs of the shape that phi deforms and of the other one
std::size_t lay_on_own_limbs(const MapFrame<3>& frame, const std::vector<Landmark<3>>& pairs,
                             const PlacedSurfaces& surfaces, const std::vector<Vec<3>>& points,
                             std::vector<Vec<3>>& carried);

}  // namespace shellmatch
