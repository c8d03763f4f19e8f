#pragma once
/// \file
/// Signed distances by fast marching on the nodes of an adaptive grid, as in the paper (section 5).

#include "grid/octree/octree.h"

#include <functional>
#include <vector>

namespace shellmatch {

/// Signed distances at all nodes: exact at the corners of the leaves that may meet the surface, and from there
/// outward and inward by the first order upwind scheme of J. A. Sethian, 'Fast marching methods', SIAM Review
/// 41(2), 1999. The signs are those of the starting values, and exact everywhere.
///
/// On a graded grid the scheme works leaf by leaf: a leaf at the node x offers one neighbour along each axis,
/// and the value at x is the least over its leaves of the u with sum_k ((u - a_k)/s_k)^2 = 1 over the
/// neighbours a_k < u at the distances s_k. On uniform grids this is Sethian's scheme. A hanging neighbour counts
/// with the mean of its parents, and where x is one of them the other parent takes its place, at twice the
/// distance. Affine distances solve these equations wherever the leaf from which the front comes lies in the
/// domain, also where the level changes. Since a parent may be reached later than x, values may improve after
/// they were passed on; then they are passed on again, so that the order of events has no influence on the result.
///
/// Hanging nodes get the mean of their parents. Serial on each side of the surface; both sides run at the same
/// time. Costs O(n log n), with a number of calls of `distance` in proportion to the leaves at the surface.
///
/// \param distance exact signed distance, negative inside, of a surface that meets the domain (checked); it is
///   called near the surface only, in parallel
template <int Dim>
std::vector<double> march_distance(const Octree<Dim>& grid,
                                   const std::function<double(const Vec<Dim>&)>& distance);

}  // namespace shellmatch
