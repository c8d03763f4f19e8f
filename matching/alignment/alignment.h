#pragma once
/// \file
/// What is found out about two shapes before the cascade: the pose of the reference, and pairs of points.

#include "geometry/distance/surface_bend.h"
#include "geometry/surface/placement.h"
#include "matching/pairs/landmarks.h"
#include "matching/result/match_summary.h"

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace shellmatch {

/// What pairs that were found are called.
inline std::string pair_name(std::size_t n_before) { return "pair " + std::to_string(n_before + 1); }

template <int Dim>
struct Alignment {
  Similarity<Dim> pose;  ///< moves the reference onto the template, user's coordinates; the identity if it stays
  /// Moves the reference's surface before that, and points of the reference with it; null where it stays. Of the
  /// forward direction alone.
  std::shared_ptr<const SurfaceBend<Dim>> bend = {};
  std::vector<Landmark<Dim>> pairs;  ///< found automatically, in the user's coordinates, before bend and pose
  /// Without pairs, too, no part begins far from where it belongs.
  bool is_near = false;
  bool is_of_part = false;  ///< of a shape that was searched as a part of the other
  double spread = 1;        ///< of the pairs' errors over those of nearly isometric shapes; at least 1
  /// Where landmarks took part in the search: a factor on their weight, below 1 where they are noisier than the pairs.
  std::optional<double> landmark_trust = {};
  std::optional<AlignmentSummary> summary;  ///< none with align.mode none
};

/// The same alignment seen from the template, which its pose moves then: what was found does not depend on which of
/// both is deformed.
template <int Dim>
Alignment<Dim> inverse(Alignment<Dim> alignment) {
  alignment.pose = inverse(alignment.pose);
  alignment.pairs = exchanged(std::move(alignment.pairs));
  if (alignment.summary) alignment.summary->scale = alignment.pose.scale;
  return alignment;
}

}  // namespace shellmatch
