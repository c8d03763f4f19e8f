#pragma once
/// \file
/// The point of one facet nearest to a given point, and the feature of the facet that carries it.

#include "base/types.h"
#include "geometry/surface/surface.h"

#include <array>

namespace shellmatch {

/// The feature of a facet that contains a point, as a bit for each of its corners: 1, 2 or 4 for a corner, 3,
/// 5 or 6 for an edge, 7 for the interior. In the plane 1 and 2 for the ends and 3 for the interior.
using FeatureMask = unsigned;
template <int Dim>
inline constexpr FeatureMask inside_facet = (1u << Dim) - 1;

template <int Dim>
struct FacetPoint {
  Vec<Dim> point;
  FeatureMask feature;
};

/// True if the area of the facet, given by its edge vectors from the first corner, is so small that its
/// normal consists of rounding errors. Such a facet is treated as the union of its edges.
bool is_degenerate(const Vec<3>& edge_1, const Vec<3>& edge_2);

/// Nearest point of facet f to x. A facet without area is treated as the union of its edges, an edge without
/// length as its first corner.
template <int Dim>
FacetPoint<Dim> closest_point_on_facet(const Surface<Dim>& surface, Index f, const Vec<Dim>& x);

/// Barycentric coordinates of such a point: >= 0, sum 1, and exactly 0 at the corners that do not belong to its
/// feature.
template <int Dim>
std::array<double, Dim> barycentric_coordinates(const Surface<Dim>& surface, Index f, const FacetPoint<Dim>& nearest);

}  // namespace shellmatch
