#pragma once
/// \file
/// Ends of limbs: where the mean distance to the rest of a surface is largest around.

#include "alignment/spectrum/edge_graph.h"

#include <vector>

namespace shellmatch {

/// A local maximum of the mean distance. Lengths are those of the graph.
struct SurfaceTip {
  Index vertex;
  double prominence;              ///< how far the mean distance falls at least on a way to a larger one
  std::vector<double> distances;  ///< to all vertices, along edges
};

/// The most prominent tips, at most n of them, descending by their prominence, which is `least_prominence` or more.
/// After M. Hilaga, Y. Shinagawa, T. Kohmura and T. Kunii, 'Topology matching for fully automatic similarity estimation
/// of 3D shapes', SIGGRAPH 2001 (mean distances), and H. Edelsbrunner, D. Letscher and A. Zomorodian, 'Topological
/// persistence and simplification', 2002. \param samples vertices well spread over the surface, to which distances are
/// measured
std::vector<SurfaceTip> surface_tips(const EdgeGraph& graph, const std::vector<Index>& samples, std::size_t n,
                                     double least_prominence);

}  // namespace shellmatch
