#pragma once
/// \file
/// Search for the map between two surfaces: starts, rotations, upsampling, choice.

#include "alignment/functional_map/map_score.h"

namespace shellmatch {

/// A map with its score.
struct MapCandidate {
  Eigen::MatrixXd c;      ///< functional map
  VertexMatches matches;  ///< of samples; of all vertices after refine_candidates()
  MapScore coarse_score;  ///< at 40 eigenfunctions
  MapScore score;         ///< at all

  bool is_identity = false;  ///< began with the surfaces as they lie

  double total() const { return 0.5 * (coarse_score.total() + score.total()); }
};

/// The best distinct maps, ascending by their score.
std::vector<MapCandidate> search_maps(const ShapePairSpectra& pair, const AlignmentOptions& options);

}  // namespace shellmatch
