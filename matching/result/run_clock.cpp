#include "matching/result/run_clock.h"

#include "base/parallel.h"
#include "matching/progress/process_info.h"

#include <algorithm>

namespace shellmatch {

void RunClock::add_earlier(const RunFigures& figures) {
  for (const auto& [phase, seconds] : figures.phase_seconds) phases[phase] += seconds;
  earlier_ += figures.seconds;
}

double RunClock::seconds() const {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin_).count();
}

void RunClock::state(RunFigures& figures) const {
  figures.compiler = compiler_name();
  figures.threads = n_threads();
  figures.seconds = seconds() + earlier_;
  figures.phase_seconds = {phases.begin(), phases.end()};
  figures.peak_memory_bytes = std::max(figures.peak_memory_bytes, peak_memory_bytes());
}

}  // namespace shellmatch
