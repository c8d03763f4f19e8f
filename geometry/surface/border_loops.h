#pragma once
/// \file
/// The borders of an oriented surface.

#include "geometry/surface/surface.h"

#include <optional>
#include <vector>

namespace shellmatch {

/// A hole, as it is seen by what fills it.
struct BorderLoop {
  std::vector<Index> vertices;  ///< each facet that fills the hole runs through them in this order
  std::vector<Index> opposite;  ///< the third corner of the facet beside vertices k and k + 1
};

/// The holes of a surface in the order of their first edges. None where an edge has more than two facets or two that
/// run through it in the same direction, or where two borders meet in a vertex.
std::optional<std::vector<BorderLoop>> border_loops(const Surface<3>& surface);

}  // namespace shellmatch
