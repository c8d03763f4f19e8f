#pragma once
/// \file
/// Parts of a surface that lie inside the body it encloses, because it crosses itself.

#include "geometry/surface/surface.h"

#include <cstddef>
#include <vector>

namespace shellmatch {

/// Two parts of a posed body that press into each other, or bodies put together of parts that overlap. No implicit
/// surface has them, and a map without folds, which carries a surface that does not cross itself onto one that does
/// not, either, cannot reach both.
struct BuriedParts {
  std::vector<Index> facets;   ///< ascending
  std::size_t n_vertices = 0;  ///< all of whose facets are buried
  double depth = 0;  ///< largest distance of a buried vertex or centre of a facet from the rest of the surface
  double share = 0;  ///< of the area, in [0, 1]
};

/// In diagonals of the bounding box: parts that lie less deep everywhere count as not buried. A mesh is no closer to
/// the shape that it stands for (coverage.tolerance), and rough ones cross themselves in many places.
inline constexpr double least_burial_depth = 2e-4;

/// Facets about whose outer side, at their centre, the surface winds once or more instead of never. Facets that cross
/// others may be buried in part and are judged each by itself, those between by the largest of them. \param crossing
/// self_intersecting_facets() of the surface \pre closed and oriented outward
BuriedParts buried_parts(const Surface<3>& surface, const std::vector<Index>& crossing);

/// The evidence for a closed surface without its buried facets, which go to the unobserved ones.
Evidence<3> without_buried(const Surface<3>& surface, const Evidence<3>& evidence, const std::vector<Index>& buried);

/// The file's own facets of such evidence, buried ones included.
Surface<3> with_buried(const Evidence<3>& evidence);

}  // namespace shellmatch
