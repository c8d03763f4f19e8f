#include "matching/result/recorder.h"

#include "base/parallel.h"
#include "energies/energy_options.h"
#include "matching/derivative_check/gradient_report.h"
#include "matching/progress/process_info.h"

#include <algorithm>
#include <cmath>
#include <utility>

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

Recorder::Recorder(Observer& next) : next_(next) {
  history.term_names.assign(term_names().begin(), term_names().end());
}

void Recorder::minimisation_started(const LevelStart& start) {
  level = start.level;
  next_.minimisation_started(start);
}

bool Recorder::iterated(const LevelStart& start, const IterationRecord& record) {
  history.rows.push_back({start.level, start.substep, start.nu, record});
  return next_.iterated(start, record);
}

void Recorder::gradient_checked(const LevelStart& start, const GradientReport& report) {
  GradientCheckSummary s{start.level, start.substep, report.iteration, report.passed(), report.failed_terms()};
  for (const TermCheck& t : report.terms) {
    s.worst_functor_error = std::max(s.worst_functor_error, t.gradient_error);
    for (const DirectionCheck& d : t.directions)
      for (const double order : d.orders)
        if (std::abs(order - 2) > std::abs(s.worst_order - 2)) s.worst_order = order;
  }
  gradient_checks.push_back(std::move(s));
  next_.gradient_checked(start, report);
}

}  // namespace shellmatch
