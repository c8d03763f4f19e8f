#pragma once
/// \file
/// What to tell at the end of a run.

#include "matching/result/match_summary.h"

#include <string>
#include <vector>

namespace shellmatch {

/// A line each: how near the deformed reference and the template are, and what looks as if the two did not match at
/// all, which no error is: units, places or shapes that do not belong together.
std::vector<std::string> verdict(const MatchSummary& summary);

}  // namespace shellmatch
