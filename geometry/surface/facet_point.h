#pragma once
/// \file
/// The point of one facet nearest to a given point, and the feature of the facet that carries it.

#include "base/types.h"
#include "geometry/surface/surface.h"

namespace shellmatch {

/// The corners of a facet that carry a point of it, as bits: 1, 2 or 4 for a single corner, 3, 5 or 6 for the
/// edge between two, all bits for the inside. In the plane 1, 2 and 3.
using FeatureMask = unsigned;
template <int Dim>
inline constexpr FeatureMask inside_facet = (1u << Dim) - 1;

template <int Dim>
struct FacetPoint {
  Vec<Dim> point;
  FeatureMask feature;
};

/// Has the facet, given by its edge vectors from the first corner, so little area that its normal is rounding
/// noise? Such a facet is treated as the union of its edges.
bool is_degenerate(const Vec<3>& edge_1, const Vec<3>& edge_2);

/// Nearest point of facet f to x. A facet without area counts as its edges, an edge without length as its
/// first corner.
template <int Dim>
FacetPoint<Dim> closest_point_on_facet(const Surface<Dim>& surface, Index f, const Vec<Dim>& x);

}  // namespace shellmatch
