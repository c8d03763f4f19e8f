#pragma once
/// \file
/// Whether one of two surfaces is of the other side, as first maps tell.

#include "alignment/functional_map/map_candidate.h"

#include <vector>

namespace shellmatch {

/// FoundMaps::mirrored_gain (map_search.h) of maps on few functions, whose orientation nothing has held yet: compares
/// what tells maps apart beside their orientation. 0 if none of the most alike maps reverses it
double mirrored_gain(const ShapePairSpectra& pair, const std::vector<MapCandidate>& candidates);

}  // namespace shellmatch
