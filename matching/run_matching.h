#pragma once
/// \file
/// A whole run: two files in, an output folder out, and checkpoints on the way.

#include "matching/experiment/options.h"
#include "matching/progress/observer.h"
#include "matching/result/match_result.h"

#include <string>

namespace shellmatch {

/// What to do with what earlier runs of the same output folder have left.
struct EarlierRuns {
  bool force = false;    ///< replace the output folder that one has written
  bool restart = false;  ///< begin anew even where one that was stopped could be continued
};

/// Reads the shapes, matches them (matching/match_shapes.h) and writes the output folder, all of it or nothing. With
/// options.resume it keeps finished levels beside that folder and goes on after those that an earlier run of the same
/// experiment has kept (matching/checkpoint/checkpoints.h).
/// \return what was written, of the dimension of the shapes
/// \throws InputError, EnvironmentError, and Stopped (base/stop.h) where that was wanted: its text says which level was
///   reached and where it is kept
AnyMatchResult run_matching(const ExperimentOptions& options, const std::string& output_folder,
                            const EarlierRuns& earlier, Observer& observer);

}  // namespace shellmatch
