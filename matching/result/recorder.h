#pragma once
/// \file
/// An observer that records the history of a matching.

#include "matching/progress/observer.h"
#include "matching/result/history.h"
#include "matching/result/match_summary.h"

#include <string>
#include <vector>

namespace shellmatch {

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
