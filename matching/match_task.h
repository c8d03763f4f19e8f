#pragma once
/// \file
/// A matching with all that it can be given besides the shapes: for programs that go on from an earlier one, or do
/// something with every level.

#include "geometry/distance/signed_distance.h"
#include "matching/cascade/cascade.h"
#include "matching/result/correspondence.h"
#include "matching/experiment/shape_pair.h"
#include "matching/result/match_result.h"
#include "matching/result/recorder.h"
#include "matching/result/run_clock.h"

#include <functional>
#include <optional>

namespace shellmatch {

/// The end of a level. All references are good until the callback returns.
template <int Dim>
struct LevelEnd {
  const LevelResult& level;
  const LevelState<Dim>& state;                  ///< grid and phi
  const ShapePair<Dim>& shapes;                  ///< as of the task
  const Similarity<Dim>& placement;
  const Surface<Dim>& deformed;                  ///< the reference's surface moved by phi, unit domain
  const SignedDistance<Dim>& template_distance;  ///< unit domain
  const MatchSummary& summary;                   ///< with all that is known so far
  const History& history;
};

template <int Dim>
struct MatchTask {
  ShapePair<Dim> shapes;      ///< surfaces in the unit domain, originals in the user's coordinates
  Similarity<Dim> placement;  ///< that has brought the surfaces there
  Correspondence<Dim> truth;  ///< true positions of some vertices, or none
  std::optional<MatchProgress<Dim>> before;            ///< go on after its last level
  std::function<void(const LevelEnd<Dim>&)> finished;  ///< called at the end of every level; may be empty
};

/// Runs it. `recorder` and `clock` belong to the caller, who may look at them after an exception or go on counting.
/// \throws as match_shapes, and whatever `finished` throws
template <int Dim>
MatchResult<Dim> run_task(MatchTask<Dim> task, const ExperimentOptions& options, Recorder& recorder, RunClock& clock);

}  // namespace shellmatch
