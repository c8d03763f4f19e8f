#pragma once
/// \file
/// Measures wall time by phase.

#include <chrono>
#include <map>
#include <string>

namespace shellmatch {

/// Seconds of wall time by name of the phase: `reading` the shapes; on every level `distances`, `coefficients`,
/// `set-up`, `minimisation`, `report` and `refinement`; `output`, which is checkpoints, pictures and the files of the
/// result; `page`, which is report.html.
using PhaseSeconds = std::map<std::string, double>;

/// Adds the time from start(name) to the next start() or to destruction to seconds[name].
class PhaseClock {
 public:
  explicit PhaseClock(PhaseSeconds& seconds) : seconds_(seconds) {}
  ~PhaseClock() { stop(); }
  PhaseClock(const PhaseClock&) = delete;
  PhaseClock& operator=(const PhaseClock&) = delete;

  void start(const std::string& phase) {
    stop();
    phase_ = phase;
    begin_ = std::chrono::steady_clock::now();
  }
  void stop() {
    if (phase_.empty()) return;
    seconds_[phase_] += std::chrono::duration<double>(std::chrono::steady_clock::now() - begin_).count();
    phase_.clear();
  }

 private:
  PhaseSeconds& seconds_;
  std::string phase_;
  std::chrono::steady_clock::time_point begin_;
};

}  // namespace shellmatch
