#pragma once
/// \file
/// Nearest facets of many points in any order.

#include "geometry/distance/facet_tree.h"

#include <vector>

namespace shellmatch {

/// FacetTree::nearest() of every point, in parallel and in the order of a Morton curve, as queries are faster the
/// nearer consecutive points lie to each other.
template <int Dim>
std::vector<Index> nearest_facets(const FacetTree<Dim>& tree, const std::vector<Vec<Dim>>& points);

}  // namespace shellmatch
