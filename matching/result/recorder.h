#pragma once
/// \file
/// Observers of a matching: its history, and its cost for the summary.

#include "matching/progress/observer.h"
#include "matching/progress/phase_clock.h"
#include "matching/result/match_result.h"
#include "matching/result/match_summary.h"

#include <chrono>
#include <string>
#include <vector>

namespace shellmatch {

/// Wall times of a matching since the construction of this object, and of earlier runs from which it was resumed.
class RunClock {
 public:
  /// Seconds by phase, set by PhaseClock.
  PhaseSeconds phases;

  /// Adds the times of the levels that earlier runs have finished.
  void add_earlier(const RunFigures& figures);

  /// Seconds since the construction, of this process alone.
  double seconds() const;

  /// Sets times, memory, threads and compiler in `figures`; leaves `level_seconds` and `resumed_after` unchanged.
  void state(RunFigures& figures) const;

 private:
  std::chrono::steady_clock::time_point begin_ = std::chrono::steady_clock::now();
  double earlier_ = 0;
};

/// Records the history and the checks of derivatives, and passes all calls on to another observer.
class Recorder final : public Observer {
 public:
  /// `next` must outlive this object.
  explicit Recorder(Observer& next);

  void note(const std::string& text) override { next_.note(text); }
  void warn(const std::string& text) override { next_.warn(text); }
  void stage(const std::string& name) override { next_.stage(name); }
  void trial_iterated() override { next_.trial_iterated(); }
  void minimisation_started(const LevelStart& start) override;
  bool iterated(const LevelStart& start, const IterationRecord& record) override;
  void gradient_checked(const LevelStart& start, const GradientReport& report) override;
  void minimisation_finished(const LevelStart& start, const MinimizerSummary& summary) override {
    next_.minimisation_finished(start, summary);
  }

  History history;
  std::vector<GradientCheckSummary> gradient_checks;
  int level = 0;  ///< the level started last; 0 before the first

 private:
  Observer& next_;
};

}  // namespace shellmatch
