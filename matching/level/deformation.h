#pragma once
/// \file
/// The answer: a volumetric map phi on its grid, with the placement that leads from the user's coordinates
/// to the unit domain and back.

#include "geometry/surface/placement.h"
#include "grid/octree/octree.h"

#include <vector>

namespace shellmatch {

template <int Dim>
struct Deformation {
  Octree<Dim> grid;
  std::vector<Vec<Dim>> phi;     ///< deformed position of every node, hanging ones included; unit domain
  Similarity<Dim> placement;

  /// phi of a point of the unit domain; outside it, the displacement of the nearest point of the domain.
  Vec<Dim> operator()(const Vec<Dim>& x) const;

  /// The same for a point in the coordinates of the shapes as the user gave them.
  Vec<Dim> apply(const Vec<Dim>& x) const { return placement.inverse((*this)(placement(x))); }
};

}  // namespace shellmatch
