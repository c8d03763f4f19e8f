#pragma once
/// \file
/// From what a generator returns to what the checks work on.

#include "geometry/generate/generate_shape.h"
#include "geometry/surface/surface.h"

#include <algorithm>

namespace shellmatch {

inline Surface<3> as_surface(const OriginalShape<3>& shape) {
  Surface<3> s{shape.vertices, {}};
  for (const auto& p : shape.polygons) s.facets.push_back({p[0], p[1], p[2]});
  return s;
}

inline Surface<2> as_surface(const OriginalShape<2>& shape) {
  Surface<2> s{shape.vertices, {}};
  for (const auto& ring : shape.polygons)
    for (std::size_t i = 0; i < ring.size(); ++i) s.facets.push_back({ring[i], ring[(i + 1) % ring.size()]});
  return s;
}

inline Surface<3> generated_surface(const char* name, const char* variant, double edge_length,
                                    const GeneratorParameters& parameters = {}) {
  return as_surface(std::get<OriginalShape<3>>(generate_shape(name, variant, edge_length, parameters)));
}

inline Surface<2> generated_outline(const char* name, const char* variant, double edge_length,
                                    const GeneratorParameters& parameters = {}) {
  return as_surface(std::get<OriginalShape<2>>(generate_shape(name, variant, edge_length, parameters)));
}

}  // namespace shellmatch
