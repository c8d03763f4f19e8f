#pragma once
/// \file
/// Messages about the quality of a matching at the end of a run.

#include "matching/result/match_summary.h"

#include <optional>
#include <string>
#include <vector>

namespace shellmatch {

/// One line for each message: the distances between the deformed reference and the template, and signs that they do not
/// match at all. These are no errors; they hint at wrong units, positions or pairs of shapes.
std::vector<std::string> verdict(const MatchSummary& summary);

/// A warning after a level, from the third on, which has left more than a tenth of the template unreached, hardly less than the level
/// before it: finer levels do not find what is that far away (docs/alignment.md). None otherwise.
std::optional<std::string> stuck_warning(const std::vector<LevelSummary>& levels);

}  // namespace shellmatch
