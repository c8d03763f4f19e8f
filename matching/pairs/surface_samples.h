#pragma once
/// \file
/// Vertices that represent a surface in sums over it.

#include "geometry/surface/surface.h"

#include <cstddef>
#include <functional>
#include <vector>

namespace shellmatch {

template <int Dim>
struct SurfaceSample {
  Index vertex;
  Vec<Dim> x;
  Vec<Dim> normal;  ///< of length 1: the mean over the facets around, by their area (length)
  double area;      ///< that it stands for (length)
};

/// Samples of the vertices that have an area and a normal and for which `contains` holds: all or, where there are more,
/// at most `most`, each of which stands for a multiple of total area / most. They are taken along a Morton curve, which
/// spreads them evenly.
template <int Dim>
std::vector<SurfaceSample<Dim>> sample_vertices(const Surface<Dim>& surface, std::size_t most,
                                                const std::function<bool(const Vec<Dim>&)>& contains);

}  // namespace shellmatch
