#pragma once
/// \file
/// How a matching tells of its progress, and how it is stopped on its way.

#include "base/types.h"
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

/// What wants to know how a matching goes on. Every function is called by the thread that called match_shapes or
/// run_matching. An exception thrown by an observer ends the matching with nothing half-written.
class Observer {
 public:
  virtual ~Observer() = default;
  /// Something worth telling the user once, such as vertices that were welded.
  virtual void note(const std::string& /*text*/) {}
  /// The run turns to something else: "reading", "matching", "writing".
  virtual void phase(const std::string& /*name*/) {}
  virtual void level_started(const LevelStart& /*start*/) {}
  /// After every accepted step. Return false to stop cleanly.
  virtual bool iterated(const LevelStart& /*start*/, const IterationRecord& /*record*/) { return true; }
  /// Derivatives were checked after an iteration (check_gradient.every); before iterated() of that iteration.
  virtual void gradient_checked(const LevelStart& /*start*/, const GradientReport& /*report*/) {}
  virtual void level_finished(const LevelStart& /*start*/, const MinimizerSummary& /*summary*/) {}
};

}  // namespace shellmatch
