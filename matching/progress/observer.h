#pragma once
/// \file
/// The interface by which a matching reports its progress and can be stopped.

#include "base/types.h"
#include "solvers/minimizer.h"

#include <string>

namespace shellmatch {

struct GradientReport;

/// The parameters of one minimisation of the cascade, reported as it begins.
struct LevelStart {
  int level = 0;
  /// Number of the minimisation on this grid, from 1, and the most that there can be: `rounds`
  /// (matching/cascade/level_minimisation.cpp) for each step of nu, some of which may be skipped.
  int substep = 1, n_substeps = 1;
  double nu = 0, volume_weight = 0, sigma = 0;
  Index n_nodes = 0, n_free_nodes = 0, n_cells = 0;
};

/// Receives the progress of a matching. All functions are called by the thread that called match_shapes or
/// run_matching. An exception thrown by an observer ends the matching; no incomplete output is left.
class Observer {
 public:
  virtual ~Observer() = default;
  /// A remark for the user, such as the number of welded vertices.
  virtual void note(const std::string& /*text*/) {}
  /// Something that the result lacks. The program says it where it is quiet, too; observers of notes need not tell them
  /// apart.
  virtual void warn(const std::string& text) { note(text); }
  /// What the run begins to do, in words for the user: run_matching reports "reading", "alignment" (where there is
  /// any), "matching", "measuring", "writing" and "writing the page", match_shapes the three in the middle,
  /// run_gradient_check "reading" and its own. The phases of phase_seconds, by which time is measured
  /// (matching/progress/phase_clock.h), are finer and not reported.
  virtual void stage(const std::string& /*name*/) {}
  /// Called after every step of the trials that choose among starts, before the first minimisation (align.mode auto).
  /// It stops the matching, which has no result yet, by an exception.
  virtual void trial_iterated() {}
  /// Called at the beginning of every minimisation, of which a level has up to `start.n_substeps`.
  virtual void minimisation_started(const LevelStart& /*start*/) {}
  /// Called after every accepted step. Return false to stop the matching; it then ends with the result so far.
  virtual bool iterated(const LevelStart& /*start*/, const IterationRecord& /*record*/) { return true; }
  /// Called when derivatives were checked after an iteration (check_gradient.every), before its iterated().
  virtual void gradient_checked(const LevelStart& /*start*/, const GradientReport& /*report*/) {}
  /// Called at the end of every minimisation.
  virtual void minimisation_finished(const LevelStart& /*start*/, const MinimizerSummary& /*summary*/) {}
};

}  // namespace shellmatch
