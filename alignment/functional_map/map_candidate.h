#pragma once
/// \file
/// A map that the search considers.

#include "alignment/functional_map/map_score.h"

#include <algorithm>

namespace shellmatch {

/// A map with its score.
struct MapCandidate {
  Eigen::MatrixXd c;      ///< functional map
  VertexMatches matches;  ///< of samples
  MapScore coarse_score;  ///< at 40 eigenfunctions
  MapScore score;         ///< at all, before the landmarks were among the pairs

  double landmark_trust =
      1;  ///< landmark_trust() of the best map: the factor on the landmarks' weights in the last refinement of all

  Features tips[2];  ///< rows that hold a map that began with tips near them, a column for each vertex; none of others

  bool is_identity = false;      ///< began with the surfaces as they lie
  bool is_by_landmarks = false;  ///< began with landmarks

  double total() const { return 0.5 * (coarse_score.total() + score.total()); }
  /// The lower, the better: what tells maps apart, beyond the noise of sampling, and the more, the farther landmarks
  /// are.
  double order() const { return order_of(score); }
  /// The same with what tells maps apart on some samples alone.
  double order_of(const MapScore& of_samples) const {
    return (1e-3 + of_samples.distinction()) * (1 + score.landmarks / std::max(total(), 0.1));
  }
};

}  // namespace shellmatch
