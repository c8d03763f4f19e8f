#pragma once
/// \file
/// Maps between two outlines of several closed curves: their refinement from a pose, and what they score.

#include "alignment/outline/closed_curve.h"
#include "alignment/outline/elastic_path.h"
#include "geometry/surface/placement.h"

#include <cmath>

namespace shellmatch {

/// Closed curves about their common centre, divided by the root of their mean square distance from it.
struct NormalizedOutline {
  std::vector<ClosedCurve> curves;  ///< the longest first; `on_input` in the coordinates of the input
  double length = 0;                ///< of all curves
};

/// Curves shorter than 1/50 of all and those beyond the 24 longest are left out.
/// \param n samples of each curve \param smoothing as of smoothed_curve
/// \throws InputError where there is no closed curve
NormalizedOutline normalized_outline(const Surface<2>& outline, std::size_t n, double smoothing);

/// Curves of two outlines that correspond, sample by sample.
struct CurveMatch {
  std::size_t first, second;
  ElasticPath path;
};

/// The parts of a map's score, each 0 for an outline and its moved self. Means are over the length.
struct OutlineScore {
  double pose = 0;         ///< root mean square distance after the best rigid motion, in the unit of NormalizedOutline
  double orientation = 0;  ///< mean of (1 - n . n') / 2 over the normals after it
  double turning = 0;      ///< mean difference of the curves' turning angles over pi, three scales
  double stretching = 0;   ///< root mean square logarithm of the ratio of steps along both, half of it
  double unmatched = 0;    ///< share of the length of both that has no partner
  double total() const { return pose + orientation + turning + stretching + unmatched; }
};

struct OutlineMap {
  Similarity<2> pose;               ///< between the normalised outlines; rigid
  std::vector<CurveMatch> matches;  ///< each curve is in at most one
  OutlineScore score;
  bool is_identity = false;  ///< began with the outlines as they lie
};

/// Costs of pairs of samples: squared distance after the pose, angle between normals, differences of turning.
Eigen::MatrixXd pair_costs(const ClosedCurve& first, const ClosedCurve& second, const Similarity<2>& pose);

/// Alternates curves that lie on each other, elastic paths between them, and the rigid motion of least squares.
/// \pre all curves of both have the same number of samples
OutlineMap refined_map(const NormalizedOutline& first, const NormalizedOutline& second, const Similarity<2>& start);

/// The stretching of elastic_path that goes with pair_costs.
inline constexpr double path_stretching = 0.03;

}  // namespace shellmatch
