#pragma once
/// \file
/// Poses and point pairs of surfaces without features, such as ellipsoids and organs, whose spectra say little.

#include "alignment/options.h"
#include "alignment/pairs/corresponding_points.h"
#include "alignment/pose/fit_pose.h"
#include "alignment/rigid/iterated_points.h"

namespace shellmatch {

/// One of the best distinct poses.
struct RigidCandidate {
  double score = 0;  ///< RigidScore::total(); 0 is best
  RigidScore score_parts;
  bool is_identity = false;  ///< the surfaces as they lie, their centres on each other, or within 10 degrees of that
  bool is_mirrored = false;  ///< found for the mirrored reference
  bool is_symmetry = false;  ///< differs from the first candidate by a symmetry of the template alone
  Pose pose;  ///< a similarity that makes both the same size; residual: median distance of the pairs after it
  std::vector<CorrespondingPoints>
      pairs;  ///< points of the reference and the nearest ones of the template after the pose
};

struct RigidPairs {
  std::vector<RigidCandidate> candidates;  ///< at least one; the chosen one first, the others by score
  /// Score of the best of the others over that of the first, those that differ by a symmetry left out; infinite without
  /// others.
  double margin = 0;

  const std::vector<CorrespondingPoints>& pairs() const { return candidates.front().pairs; }
};

/// Poses by distance: from the surfaces as they lie, principal axes in all orders and directions, and 144 rotations all
/// around begin iterated closest points. Of candidates that score alike, within options.identity_preference, the
/// surfaces as they lie come first, else the one that turns least. Surfaces whose limbs lie otherwise may come nearest
/// to each other in a wrong pose: this is for where find_pairs() is doubtful. Uses `pairs`, `refined`,
/// `identity_preference` and `mirror` of the options. \param n_sweeps most of the last iteration, from what has nearly
/// converged: fewer where the caller iterates further itself \throws InputError for surfaces without area
RigidPairs find_rigid_pairs(const Surface<3>& reference, const Surface<3>& template_surface,
                            const AlignmentOptions& options = {}, int n_sweeps = 28);

}  // namespace shellmatch
