#pragma once
/// \file
/// Nodal fields from functions of space.

#include "grid/octree/octree.h"

#include <functional>
#include <vector>

namespace shellmatch {

enum class HangingValues {
  interpolated,  ///< the mean of the parents: the field is continuous and lies in the finite element space
  exact          ///< the value of the function: not conforming; for comparisons
};

/// Values of `function` at all nodes. `function` is called in parallel.
template <int Dim>
std::vector<double> sample_nodes(const Octree<Dim>& grid, const std::function<double(const Vec<Dim>&)>& function,
                                 HangingValues hanging = HangingValues::interpolated);

}  // namespace shellmatch
