#pragma once
/// \file
/// Parts of a surface that lie inside the body it encloses, because it crosses itself.

#include "geometry/surface/surface.h"

#include <cstddef>

namespace shellmatch {

/// A map without folds carries a surface that does not cross itself onto one that does not, either. Where two parts of the template
/// overlap, its image follows one of them or runs between them, and the largest distance from the template is of the order of `depth`.
struct BuriedParts {
  std::size_t n_vertices = 0;  ///< those of buried facets that cross no other
  double depth = 0;            ///< largest distance of such a vertex from all facets but those of the part to which it belongs
};

/// Parts between facets that cross others, about whose outer side the surface winds once or more instead of never. Of the
/// 64 largest parts, each of which takes the time of winding_number(). \pre closed and oriented outward
BuriedParts buried_parts(const Surface<3>& surface);

}  // namespace shellmatch
