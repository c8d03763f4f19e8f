#pragma once
/// \file
/// A matching of shapes that are placed, with all its inputs: besides the shapes the state of an earlier matching to
/// resume from, and a callback for the end of every level.

#include "geometry/distance/signed_distance.h"
#include "matching/alignment/prepare_pair.h"
#include "matching/cascade/cascade.h"
#include "matching/input/shape_pair.h"
#include "matching/pairs/landmarks.h"
#include "matching/result/correspondence.h"
#include "matching/result/match_result.h"
#include "matching/result/recorder.h"

#include <functional>
#include <optional>
#include <vector>

namespace shellmatch {

/// The end of a level. The references are valid until the callback returns.
template <int Dim>
struct LevelEnd {
  const LevelResult& level;
  const LevelState<Dim>& state;  ///< grid and phi
  const ShapePair<Dim>& shapes;  ///< those of the inputs
  const PreparedPair<Dim>& prepared;
  const Surface<Dim>& deformed;  ///< the deformed reference's surface, unit domain
  const std::vector<double>&
      distance;                 ///< of its vertices to the template's; unit domain, NaN where a shape has no data
  const MatchSummary& summary;  ///< of the levels finished so far
  const History& history;
  const std::vector<LevelVertices<Dim>>& levels;  ///< this one and those before; none without options.report
};

/// What a matching starts from.
template <int Dim>
struct MatchInputs {
  ShapePair<Dim> shapes;                         ///< surfaces in the unit domain, originals in the user's coordinates
  PreparedPair<Dim> prepared;                    ///< how they have come there
  Correspondence<Dim> truth;                     ///< true positions of some vertices; may be empty
  std::vector<Landmark<Dim>> landmarks;          ///< in the user's coordinates; may be empty
  std::vector<PairSet<Dim>> pairs;               ///< further terms of point pairs, in the unit domain
  std::optional<MatchProgress<Dim>> checkpoint;  ///< resume after its last level
  std::optional<FinishedLevel<Dim>> start;       ///< without `checkpoint`: begin after this level of another matching
  std::function<void(const LevelEnd<Dim>&)> finished;  ///< called at the end of every level; may be empty
};

/// Matches shapes that lie in the unit domain. `recorder` and `clock` belong to the caller, who may read them after an
/// exception and go on measuring.
/// \throws as match_shapes, and whatever `finished` throws
template <int Dim>
MatchResult<Dim> match_placed_shapes(MatchInputs<Dim> inputs, const ExperimentOptions& options, Recorder& recorder,
                                     RunClock& clock);

}  // namespace shellmatch
