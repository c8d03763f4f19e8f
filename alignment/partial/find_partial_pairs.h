#pragma once
/// \file
/// Automatic point pairs between a part and a whole in another pose, without learning.

#include "alignment/options.h"
#include "alignment/pairs/corresponding_points.h"
#include "alignment/spectrum/prepared_surface.h"

#include <optional>
#include <span>
#include <vector>

namespace shellmatch {

/// One of the best distinct maps of a part.
struct PartialCandidate {
  double score = 0;  ///< PartialMap::total(); 0 is best
  double order = 0;  ///< PartialMap::order(): less is better, among candidates of the same surfaces
  std::optional<double> landmark_distance =
      {};  ///< median distance of landmarks from where the map takes them, in roots of the whole's area
  std::vector<CorrespondingPoints> pairs;  ///< on_reference is on the part
  std::vector<Index> map;                  ///< for each vertex of the prepared part one of the prepared whole
};

struct PartialPairs {
  PreparedSurface part, whole;
  double scale = 1;  ///< of the part, with which it is like the whole: the ratio of the sizes of two individuals
  std::vector<PartialCandidate>
      candidates;     ///< at least one, ascending by order; where landmarks tell, by their distance
  double margin = 0;  ///< the least margin_between() the first and others; infinite without
};

/// Pairs between a surface with borders and one of which it is a part, or a part of another individual of half to twice
/// the size. docs/alignment.md describes the steps. The result does not depend on the number of threads. \param
/// landmarks known pairs, those on the part as on_reference; four or more order the candidates \throws InputError for
/// surfaces without area or with coordinates that are not finite
PartialPairs find_partial_pairs(const Surface<3>& part, const Surface<3>& whole, const AlignmentOptions& options = {},
                                std::span<const CorrespondingPoints> landmarks = {});

}  // namespace shellmatch
