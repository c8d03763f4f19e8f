#pragma once
/// \file
/// A whole run: reads two files and writes an output folder, with checkpoints after finished levels.

#include "matching/experiment/options.h"
#include "matching/progress/observer.h"
#include "matching/result/match_result.h"

#include <string>

namespace shellmatch {

/// What to do with the results of earlier runs for the same output folder.
struct EarlierRuns {
  bool force = false;    ///< replace the output folder of an earlier run
  bool restart = false;  ///< ignore the checkpoint of an earlier run
};

/// Reads the shapes, matches them (matching/match_placed_shapes.h) and writes the output folder, all of it or nothing.
/// With options.resume it writes a checkpoint after finished levels, and resumes from that of an earlier run of the
/// same experiment (matching/checkpoint/checkpoints.h). \return the result that was written, of the dimension of the
/// shapes \throws InputError as match_shapes, and for files that cannot be read; EnvironmentError; and Stopped
/// (base/stop.h) on request or at a limit of the user; its text names the level that was reached and the folder of the
/// checkpoint
AnyMatchResult run_matching(const ExperimentOptions& options, const std::string& output_folder,
                            const EarlierRuns& earlier, Observer& observer);

}  // namespace shellmatch
