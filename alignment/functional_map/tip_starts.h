#pragma once
/// \file
/// First matches of two surfaces from the ends of their limbs.

#include "alignment/functional_map/two_way_map.h"

namespace shellmatch {

/// Tips of surface 1 with those of surface 2, as indices in SpectralShape::tips.
struct TipAssignment {
  std::vector<std::pair<int, int>> pairs;
  double cost = 0;  ///< 0 where all correspond and have the same distances from one another
};

/// The n assignments of least cost of three tips or more, ascending. What is compared are the distances between tips,
/// in ratios, so that limbs may have other lengths, and what tips are left out. A mirrored assignment costs the same.
std::vector<TipAssignment> assign_tips(const std::vector<SurfaceTip>& tips_1, const std::vector<SurfaceTip>& tips_2,
                                       std::size_t n);

/// Samples matched by their distances from assigned tips.
VertexMatches match_by_tips(const ShapePairSpectra& pair, const TipAssignment& assignment, std::size_t n_queries);

}  // namespace shellmatch
