#pragma once
/// \file
/// What a run tells the user on the way.

#include "apps/commands.h"
#include "apps/time_left.h"
#include "matching/progress/observer.h"

#include <chrono>
#include <string>

namespace shellmatch {

/// Writes to stderr: on a terminal one line that is rewritten, with energy and time left, and one that stays
/// per finished level; elsewhere a line as each minimisation begins and ends. Between phases and iterations it stops
/// the run where that is wanted (base/stop.h).
class Progress final : public Observer {
 public:
  Progress(Verbosity verbosity, int max_level);
  ~Progress() override;

  void note(const std::string& text) override;
  void phase(const std::string& name) override;
  void level_started(const LevelStart& start) override;
  bool iterated(const LevelStart& start, const IterationRecord& record) override;
  /// Nothing more will be rewritten: what follows goes elsewhere.
  void finished() { clear(); }
  void gradient_checked(const LevelStart& start, const GradientReport& report) override;
  void level_finished(const LevelStart& start, const MinimizerSummary& summary) override;

 private:
  double now() const;
  void line(const std::string& text);     // one that stays
  void rewrite(const std::string& text);  // one that the next replaces
  void clear();

  Verbosity verbosity_;
  int max_level_;
  bool terminal_;            // stderr is one, and lines are rewritten there
  bool pending_ = false;     // a line stands there that is to be replaced
  double last_rewrite_ = -1;
  TimeLeft time_left_;
  std::chrono::steady_clock::time_point begin_ = std::chrono::steady_clock::now();
};

}  // namespace shellmatch
