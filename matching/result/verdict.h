#pragma once
/// \file
/// Whether two shapes match, as far as the figures of a matching tell (docs/verdict.md).

#include "matching/result/match_summary.h"

#include <optional>
#include <string>
#include <vector>

namespace shellmatch {

/// Places that a verdict points to, in the coordinates of the template's file. Empty where unknown.
struct VerdictPlaces {
  std::vector<double> deformed;        ///< of the deformed reference, farthest from the template
  std::vector<double> template_shape;  ///< of the template, farthest from the deformed reference
  std::vector<double> distorted;       ///< of the deformed reference, where areas and angles have changed most
};

/// The verdict of a complete or interrupted matching. "not-matched": a part of the template is not reached, or the
/// reference is distorted so much that points correspond wrongly. "look-here": a figure is unusual and says where to
/// look. The limits are those of docs/verdict.md.
Verdict judge(const MatchSummary& summary, const VerdictPlaces& places);

/// The end of a run in words: the distances both ways, the verdict, and a line for each of its reasons.
std::vector<std::string> verdict_lines(const MatchSummary& summary);

/// A length given in diagonals of the template, in words: "0.021 mm (1.2e-04 diagonals)".
std::string length_text(double diagonals, const MatchSummary& summary);

/// A warning before the run, where the shapes as placed lie apart from each other on average. None otherwise.
std::optional<std::string> far_apart_warning(const MatchSummary& summary);

/// A warning after a level, from the third on, which has left more than a tenth of the template unreached, hardly less
/// than the level before it: finer levels do not find what is that far away (docs/alignment.md). None otherwise.
std::optional<std::string> stuck_warning(const std::vector<LevelSummary>& levels);

}  // namespace shellmatch
