#pragma once
/// \file
/// The connected parts of a closed surface.

#include "geometry/surface/surface.h"

namespace shellmatch {

/// Removes the parts that enclose less than `least`, but for the largest, and the vertices that are left without a
/// facet. \return their number
std::size_t drop_small_parts(Surface<3>& surface, double least);

}  // namespace shellmatch
