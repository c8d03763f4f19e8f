#pragma once
/// \file
/// Reports the progress of a run to the user.

#include "apps/terminal/time_left.h"
#include "apps/terminal/words.h"
#include "matching/progress/observer.h"

#include <chrono>
#include <mutex>
#include <optional>
#include <string>

namespace shellmatch {

/// Writes to stderr. On a terminal, one line with the stage, energy and estimated time is rewritten, at least once a
/// second, and one line per finished level stays; elsewhere each stage and each minimisation writes a line at its
/// beginning, and minimisations also at their end. Between stages and iterations the observer stops the run on request
/// (base/stop.h).
class Progress final : public Observer {
 public:
  Progress(Verbosity verbosity, int max_level);
  ~Progress() override;

  void note(const std::string& text) override;
  void warn(const std::string& text) override;
  void stage(const std::string& name) override;
  void trial_iterated() override;
  void minimisation_started(const LevelStart& start) override;
  bool iterated(const LevelStart& start, const IterationRecord& record) override;
  /// Ends the rewritten line. Call it before other output.
  void finished();
  void gradient_checked(const LevelStart& start, const GradientReport& report) override;
  void minimisation_finished(const LevelStart& start, const MinimizerSummary& summary) override;

 private:
  double now() const;
  // The functions below are called with the mutex held.
  void line(const std::string& text);     // writes a line that stays, unless quiet
  void say(const std::string& text);      // the same where it is quiet, too
  void rewrite(const std::string& text);  // writes a line that the next one replaces
  void clear();
  void beat();
  void show_activity();
  std::string left() const;  // the estimate with a comma before it, or nothing

  Verbosity verbosity_;
  int max_level_;
  bool terminal_;         // stderr is a terminal, on which lines are rewritten
  bool pending_ = false;  // the last line is one to be replaced
  double last_rewrite_ = -1;
  std::string doing_;  // the stage, or the place in the cascade
  double doing_since_ = 0;
  bool has_estimate_ = false;
  TimeLeft time_left_;
  std::chrono::steady_clock::time_point begin_ = std::chrono::steady_clock::now();
  std::mutex mutex_;
  std::optional<Heartbeat> heartbeat_;  // last: it ends first
};

}  // namespace shellmatch
