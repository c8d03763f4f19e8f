#pragma once
/// \file
/// Which elements a surface meets: what the cascade refines.

#include "grid/octree/octree.h"

#include <functional>
#include <vector>

namespace shellmatch {

/// Do the values at the leaf's corners change sign, or vanish somewhere? Then the surface d = 0 meets the
/// leaf. Thin parts that pass between the corners are missed.
template <int Dim>
bool changes_sign(const Octree<Dim>& grid, const std::vector<double>& nodal_distance, Index leaf);

/// Does the surface meet the closed cube of this centre and side? Certain "yes" if it comes nearer to the
/// centre than half the side, certain "no" if not nearer than half the diagonal; between them the cube is
/// halved and its parts are asked, `depth` times, and what is left uncertain counts as met. `distance` is an
/// exact, signed or unsigned, distance: 1-Lipschitz.
template <int Dim>
bool cube_meets_surface(const std::function<double(const Vec<Dim>&)>& distance, const Vec<Dim>& centre,
                        double side, int depth = 3);

/// Does the surface meet the leaf? The nodal distances decide most leaves, the distance itself the others.
/// \pre nodal_distance are the values of `distance` at the free nodes; hanging ones may be interpolated
template <int Dim>
bool meets_surface(const Octree<Dim>& grid, const std::vector<double>& nodal_distance,
                   const std::function<double(const Vec<Dim>&)>& distance, Index leaf);

}  // namespace shellmatch
