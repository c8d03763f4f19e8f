#pragma once
/// \file
/// A whole run: two shapes in, an output folder out.

#include "base/types.h"
#include "matching/experiment/options.h"
#include "solvers/minimizer.h"

#include <string>

namespace shellmatch {

struct GradientReport;

/// One minimisation of the cascade, as it begins.
struct LevelStart {
  int level = 0;
  int substep = 1, n_substeps = 1;  ///< minimisations with decreasing nu on the same grid, counted from 1
  double nu = 0, volume_weight = 0, sigma = 0;
  Index n_nodes = 0, n_free_nodes = 0, n_cells = 0;
};

/// What wants to know how a run goes on. Every function is called by the thread that called run_matching.
/// An exception thrown by an observer ends the run with nothing half-written.
class Observer {
 public:
  virtual ~Observer() = default;
  /// Something worth telling the user once, such as vertices that were welded.
  virtual void note(const std::string& /*text*/) {}
  /// The run turns to something else: "reading", "distances", "writing".
  virtual void phase(const std::string& /*name*/) {}
  virtual void level_started(const LevelStart& /*start*/) {}
  /// After every accepted step. Return false to stop cleanly.
  virtual bool iterated(const LevelStart& /*start*/, const IterationRecord& /*record*/) { return true; }
  /// Derivatives were checked after an iteration (check_gradient.every); before iterated() of that iteration.
  virtual void gradient_checked(const LevelStart& /*start*/, const GradientReport& /*report*/) {}
  virtual void level_finished(const LevelStart& /*start*/, const MinimizerSummary& /*summary*/) {}
};

/// What to do with what earlier runs of the same output folder have left.
struct EarlierRuns {
  bool force = false;    ///< replace the output folder that one has written
  bool restart = false;  ///< begin anew even where one that was stopped could be continued
};

/// Reads and places the shapes, runs the cascade and writes the output folder, all of it or nothing. With
/// options.resume it keeps finished levels beside that folder and goes on after those that an earlier run of the same
/// experiment has kept (matching/checkpoint/checkpoints.h).
/// \throws InputError, EnvironmentError, and Stopped (base/stop.h) where that was wanted: its text says which level was
///   reached and where it is kept
void run_matching(const ExperimentOptions& options, const std::string& output_folder, const EarlierRuns& earlier,
                  Observer& observer);

}  // namespace shellmatch
