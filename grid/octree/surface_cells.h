#pragma once
/// \file
/// Which cells a surface meets: the criterion of refinement.

#include "grid/octree/octree.h"

#include <functional>
#include <vector>

namespace shellmatch {

/// True where the values at the leaf's corners change sign or one of them is 0: then the surface d = 0 meets
/// the leaf. Misses thin parts that pass between the corners.
template <int Dim>
bool changes_sign(const Octree<Dim>& grid, const std::vector<double>& nodal_distance, Index leaf);

/// True where the surface meets the closed cube of this centre and side. It does if its distance to the
/// centre is at most half the side, and it does not if the distance exceeds half the diagonal. In between,
/// the cube is subdivided into 2^Dim parts, recursively to `depth`; parts that remain undecided count as met.
/// `distance` is an exact distance, signed or unsigned, and therefore 1-Lipschitz.
template <int Dim>
bool cube_meets_surface(const std::function<double(const Vec<Dim>&)>& distance, const Vec<Dim>& centre, double side,
                        int depth = 3);

/// True where the surface meets the leaf. The nodal distances decide most leaves; the others need `distance`.
/// \pre `nodal_distance` has the values of `distance` at the free nodes; values at hanging nodes may be
/// interpolated
template <int Dim>
bool meets_surface(const Octree<Dim>& grid, const std::vector<double>& nodal_distance,
                   const std::function<double(const Vec<Dim>&)>& distance, Index leaf);

}  // namespace shellmatch
