#pragma once
/// \file
/// Functions of space as nodal fields.

#include "grid/octree/octree.h"

#include <functional>
#include <vector>

namespace shellmatch {

enum class HangingValues {
  interpolated,  ///< mean of the parents: the field is continuous, an element of the finite element space
  exact          ///< the function itself: not conforming, for comparisons
};

/// Values of `function` at all nodes. It is called in parallel.
template <int Dim>
std::vector<double> sample_nodes(const Octree<Dim>& grid,
                                 const std::function<double(const Vec<Dim>&)>& function,
                                 HangingValues hanging = HangingValues::interpolated);

}  // namespace shellmatch
