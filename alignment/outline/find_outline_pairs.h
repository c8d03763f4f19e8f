#pragma once
/// \file
/// Automatic point pairs between two outlines in the plane, in any position and of any size.

#include "alignment/options.h"
#include "alignment/outline/outline_map.h"
#include "alignment/pairs/corresponding_points.h"

namespace shellmatch {

/// One of the best distinct maps.
struct OutlineCandidate {
  double score = 0;  ///< OutlineScore::total(); 0 is best
  OutlineScore score_parts;
  bool is_identity = false;  ///< began with the outlines as they lie
  bool is_mirrored = false;  ///< found for the mirrored reference
  bool is_symmetry = false;  ///< differs from the first candidate by a symmetry of the template alone
  Similarity<2> pose;        ///< of least squares of the pairs, reference to template
  std::vector<CorrespondingPointsIn<2>> pairs;
};

struct OutlinePairs {
  std::vector<OutlineCandidate> candidates;  ///< at least one; the chosen one first, the others by score
  /// Score of the best of the others over that of the first, those that differ by a symmetry left out; infinite without
  /// others.
  double margin = 0;

  const std::vector<CorrespondingPointsIn<2>>& pairs() const { return candidates.front().pairs; }
};

/// Pairs of points between two outlines of one or several closed curves, by arc length, turning and places: elastic
/// paths from many poses (docs/alignment.md). Of candidates that score alike, within options.identity_preference, the
/// one that began as the outlines lie comes first, else the one that turns least. Uses `pairs`, `refined`,
/// `identity_preference` and `mirror` of the options. \throws InputError where an outline has no closed curve
OutlinePairs find_outline_pairs(const Surface<2>& reference, const Surface<2>& template_outline,
                                const AlignmentOptions& options = {});

}  // namespace shellmatch
