#pragma once
/// \file
/// Messages about the quality of a matching at the end of a run.

#include "matching/result/match_summary.h"

#include <string>
#include <vector>

namespace shellmatch {

/// One line for each message: the distances between the deformed reference and the template, and signs that they do not
/// match at all. These are no errors; they hint at wrong units, positions or pairs of shapes.
std::vector<std::string> verdict(const MatchSummary& summary);

}  // namespace shellmatch
