#include "matching/result/recorder.h"

#include "energies/options.h"
#include "matching/derivative_check/gradient_report.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace shellmatch {

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
