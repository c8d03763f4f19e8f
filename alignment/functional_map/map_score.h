#pragma once
/// \file
/// How plausible a map between two surfaces is, without knowledge of the true one.

#include "alignment/functional_map/two_way_map.h"

namespace shellmatch {

/// Each is 0 for a surface and its moved copy.
struct MapScore {
  double functions = 0;       ///< root of the mean of |functions_1 C - functions_2|^2 over that of |functions_2|^2
  double signature = 0;       ///< mean relative difference of the wave kernel signatures
  double orientation = 0;     ///< mean of (1 - n . n') / 2 over normals and pulled back normals
  double pose = 0;            ///< root mean square distance after a proper rotation, in roots of the area
  double spin = 0;            ///< mean square difference of spin images, at most 2
  double tips = 0;            ///< tip_disorder(); no part of the total
  double landmarks = 0;       ///< median of landmark_distances(), 0 without landmarks; no part of the total
  double landmark_noise = 0;  ///< landmark_noise(); no part of the total

  double total() const { return functions + signature + orientation + pose; }
  /// What tells right from wrong among maps of the same two surfaces. Where limbs point does not count: poses do not
  /// tell front from back.
  double distinction() const { return (functions + signature + orientation) * spin * tip_factor(tips); }
};

/// The errors of a map with this total score over those of maps between nearly isometric surfaces; at least 1.
double error_growth(double total_score);

/// How far landmarks may be trusted, 0 to 1: less, the noisier they are than a map of this total score explains. Noise
/// of a few per cent would spoil a map that is more exact. \param landmark_noise as in MapScore
double landmark_trust(double total_score, double landmark_noise);

MapScore score_map(const ShapePairSpectra& pair, const VertexMatches& matches, const Eigen::MatrixXd& c);

/// The same without landmarks, of any samples. \pre at least one
MapScore score_samples(const ShapePairSpectra& pair, const VertexMatches& matches, const Eigen::MatrixXd& c);

/// The rotation R, det R = 1, that minimises the sum of |R x_1 + t - x_2|^2 with the best t over all pairs, for
/// coordinates smoothed to k eigenfunctions. W. Kabsch, Acta Crystallographica A 32, 1976.
Mat<3> proper_rotation(const ShapePairSpectra& pair, const VertexMatches& matches, int k);

}  // namespace shellmatch
