#pragma once
/// \file
/// Signed distances by fast marching on the nodes of an adaptive grid, as in the paper (section 5).

#include "grid/octree/octree.h"

#include <functional>
#include <vector>

namespace shellmatch {

/// Signed distances at all nodes. They are exact at the corners of the leaves that may meet the surface, and
/// are computed from there in both directions by the first order upwind scheme of J. A. Sethian, 'Fast
/// marching methods', SIAM Review 41(2), 1999. The signs are exact everywhere.
///
/// On a graded grid the scheme works leaf by leaf. In each leaf, a node x has one neighbour along each axis;
/// let a_k be its value and s_k its distance. The value at x is the minimum over the leaves at x of the
/// solution u of sum_k ((u - a_k)/s_k)^2 = 1, where the sum is over the neighbours with a_k < u. On uniform
/// grids this is Sethian's scheme. The value of a hanging neighbour is the mean of its parents; if x is one
/// of the parents, the other parent replaces the hanging node, at twice the distance. Affine distances solve
/// these equations wherever the upwind leaf lies in the domain, also where the level changes. A parent may be
/// reached later than x, so a value may decrease after its neighbours were computed from it; they are then
/// computed again, and the result does not depend on the order.
///
/// Hanging nodes get the mean of their parents. Each side of the surface is computed serially, the two sides
/// in parallel. Costs O(n log n) and a number of calls of `distance` proportional to the number of leaves at
/// the surface.
///
/// \param distance exact signed distance, negative inside, of a surface that meets the domain (checked). It
///   is called near the surface only, in parallel.
template <int Dim>
std::vector<double> march_distance(const Octree<Dim>& grid, const std::function<double(const Vec<Dim>&)>& distance);

}  // namespace shellmatch
