#pragma once
/// \file
/// The result of a matching: a volumetric map phi on its grid, the similarity between the user's coordinates and the unit
/// domain, and the pose that was taken out before.

#include "geometry/surface/placement.h"
#include "grid/octree/octree.h"

#include <vector>

namespace shellmatch {

template <int Dim>
struct Deformation {
  Octree<Dim> grid;
  std::vector<Vec<Dim>> phi;     ///< deformed positions of all nodes, hanging nodes included; unit domain
  Similarity<Dim> placement;
  Similarity<Dim> pose = {};     ///< moves points of the reference before anything else; user's coordinates

  Vec<Dim> to_unit_domain(const Vec<Dim>& x) const { return placement(pose(x)); }

  /// The image of a point, both in the user's coordinates.
  Vec<Dim> apply(const Vec<Dim>& x) const { return placement.inverse(apply_in_unit_domain(to_unit_domain(x))); }

  /// The same in coordinates of the unit domain: phi(x). A point outside it gets the displacement of the nearest point of
  /// the domain.
  Vec<Dim> apply_in_unit_domain(const Vec<Dim>& x) const;
};

}  // namespace shellmatch
