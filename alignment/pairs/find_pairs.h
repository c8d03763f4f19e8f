#pragma once
/// \file
/// Automatic point pairs between two surfaces that are nearly isometric, in any position and pose, without learning.

#include "alignment/functional_map/map_score.h"
#include "alignment/pairs/corresponding_points.h"
#include "alignment/spectrum/prepared_surface.h"

#include <memory>
#include <optional>
#include <span>
#include <string>

namespace shellmatch {

/// One of the best distinct maps.
struct PairCandidate {
  double score = 0;             ///< MapScore::total(), the mean of both resolutions; 0 is best: how nearly isometric
  double order = 0;             ///< MapCandidate::order(): less is better, among candidates of the same surfaces
  double margin = 1;            ///< margin_between() the first of the same handedness and this one
  std::size_t n_landmarks = 0;  ///< that took part: neither double nor on a component left out, and four at least
  MapScore coarse_score, score_parts;
  /// Where landmarks tell: the median of landmark_distances() before they were among the pairs, in roots of the area.
  std::optional<double> landmark_distance;
  double landmark_trust = 1;  ///< landmark_trust() of the best candidate; 1 where landmarks do not tell
  bool is_identity = false;   ///< began with the surfaces as they lie
  bool is_mirrored = false;   ///< found for the mirrored reference
  /// Confident ones. None, and no map, of a candidate whose order is more than twice that of the best.
  std::vector<CorrespondingPoints> pairs;
  std::vector<CorrespondingPoints>
      contradicting;       ///< ConfidentPairs::contradicting: evidence against the map, and of no other use
  std::vector<Index> map;  ///< for each vertex of the prepared reference one of the prepared template
};

struct AutomaticPairs {
  PreparedSurface reference, template_surface;
  std::vector<PairCandidate>
      candidates;     ///< at least one; the chosen one first, ascending by order, the mirrored ones behind equals
  double margin = 0;  ///< the least of the others of the same handedness; infinite without, 1 where ambiguous
  bool is_ambiguous = false;                        ///< spectra are_ambiguous()
  double mirrored_gain = 0;                         ///< FoundMaps::mirrored_gain
  std::shared_ptr<const SpectralShape> spectra[2];  ///< of the prepared surfaces

  const std::vector<CorrespondingPoints>& pairs() const { return candidates.front().pairs; }
  /// Image of a vertex of the reference as it was given: the nearest vertex of the map at both ends, a vertex of the
  /// prepared template; no_index on components left out.
  Index image(Index reference_vertex) const;
};

/// Pairs of points between a reference and a template. docs/alignment.md describes the steps. The result depends on
/// neither the number of threads nor the position of the surfaces up to rounding, except that the map which begins with
/// the surfaces as they lie comes first where another differs by less than rounding and sampling do. \param landmarks
/// known pairs, in the coordinates of the surfaces; four or more give a start of their own, take part in the order
///   of candidates, and make their pairs more exact. Those that contradict most others count little.
/// \throws InputError for surfaces without area or with coordinates that are not finite, and with fewer than 40
/// options.functions
AutomaticPairs find_pairs(const Surface<3>& reference, const Surface<3>& template_surface,
                          const AlignmentOptions& options = {}, std::span<const CorrespondingPoints> landmarks = {});

/// Whether the mirrored reference has a map that is nearly isometric, with a total score below `most_score`, and an
/// order below `most_order`.
bool fits_mirrored(const SpectralShape& reference, const SpectralShape& template_shape, const AlignmentOptions& options,
                   double most_score, double most_order);

}  // namespace shellmatch
