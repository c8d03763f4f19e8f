#pragma once
/// \file
/// The ends of a surface's limbs, how they lie to one another, and how well a map takes them to those of another
/// surface.

#include "alignment/spectrum/edge_graph.h"

#include <cstddef>
#include <span>
#include <vector>

namespace shellmatch {

/// A local maximum of the mean distance. Lengths are those of the graph.
struct SurfaceTip {
  Index vertex;
  double prominence;              ///< how far the mean distance falls at least on a way to a larger one
  std::vector<double> distances;  ///< to all vertices, along edges
  int twin = 0;                   ///< in the list of tips: twins_of_tips()
};

/// Samples to which surface_tips() measures distances.
inline constexpr std::size_t n_tip_samples = 50;

/// There are 130 thousand ways to match as many tips.
inline constexpr std::size_t n_most_tips = 7;

/// The most prominent tips of a connected surface of area 1, at most n of them, descending by their prominence. Of tips
/// near each other, such as a heel and toes, the most prominent one stands for all.
/// After M. Hilaga, Y. Shinagawa, T. Kohmura and T. Kunii, 'Topology matching for fully automatic similarity estimation
/// of 3D shapes', SIGGRAPH 2001 (mean distances), and H. Edelsbrunner, D. Letscher and A. Zomorodian, 'Topological
/// persistence and simplification', 2002. \param samples vertices well spread over the surface, of which the first
/// n_tip_samples count
std::vector<SurfaceTip> surface_tips(const EdgeGraph& graph, std::span<const Index> samples,
                                     std::size_t n = n_most_tips);

/// Of each tip the one that corresponds to it by the surface's own bilateral symmetry: itself where it lies on the
/// plane of symmetry, where its twin is no tip, and where there is no symmetry. Only distances between tips count, so
/// that it holds in any pose.
std::vector<int> twins_of_tips(const std::vector<SurfaceTip>& tips);

/// How far a map between two surfaces is from taking tips to tips, and twins to twins: 0 to 3, the mean over the tips
/// of both, weighted by their prominence. \param images_s of the tips of surface s, vertices of the other one; 0
/// without tips on either
double tip_disorder(const std::vector<SurfaceTip>& tips_1, const std::vector<Index>& images_1,
                    const std::vector<SurfaceTip>& tips_2, const std::vector<Index>& images_2);

/// The factor by which tip_disorder() raises what tells how little alike two surfaces look under a map.
inline double tip_factor(double disorder) { return 1 + 0.25 * disorder; }

}  // namespace shellmatch
