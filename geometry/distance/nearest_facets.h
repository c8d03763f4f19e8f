#pragma once
/// \file
/// Nearest facets of many points in any order, and of those facets that face the way a point's own surface does.

#include "geometry/distance/facet_tree.h"
#include "geometry/surface/facet_point.h"
#include "geometry/surface/surface.h"

#include <optional>
#include <vector>

namespace shellmatch {

/// Of two limbs that touch, the nearest facet as such may belong to the other one, or to the other side of a thin part.
template <int Dim>
class OrientedFacets {
 public:
  struct Nearest {
    Index facet;
    FacetPoint<Dim> point;
    double distance;
  };

  /// \param surface must outlive this object; its coordinates are finite
  explicit OrientedFacets(const Surface<Dim>& surface);

  /// A near facet whose normal has a positive product with the given one. The facets are kept in groups by the largest
  /// component of their normals; of each group to whose side the given normal points the nearest one is looked at, and
  /// of these the nearest that faces its way is returned. That is the nearest of all whose normals differ by less than
  /// 35 degrees, unless one that faces away lies before it; none where all of them face away.
  std::optional<Nearest> nearest(const Vec<Dim>& x, const Vec<Dim>& normal) const;

 private:
  /// The facets whose normals have their largest component along one axis, with one sign.
  struct Side {
    std::vector<Index> facets;
    std::optional<FacetTree<Dim>> tree;
  };

  const Surface<Dim>* surface_;
  std::vector<Side> sides_;  ///< 2 k for the positive direction of axis k, 2 k + 1 for the negative one
};

/// FacetTree::nearest() of every point, in parallel and in the order of a Morton curve, as queries are faster the
/// nearer consecutive points lie to each other.
template <int Dim>
std::vector<Index> nearest_facets(const FacetTree<Dim>& tree, const std::vector<Vec<Dim>>& points);

}  // namespace shellmatch
