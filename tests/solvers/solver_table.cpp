// Prints a Markdown table: every method on every published problem, iterations and evaluations, or why not.
#include "tests/support/published_trials.h"

#include <fmt/format.h>

#include <cstdio>

int main() {
  using namespace shellmatch;
  const auto problems = testing::more_garbow_hillstrom();
  std::string head = "| method |", rule = "|---|", rows, notes;
  for (const auto& p : problems) {
    head += fmt::format(" {} |", p->name());
    rule += "---|";
  }
  int n_notes = 0;
  for (const std::string& method : minimizer_names()) {
    rows += fmt::format("| `{}` |", method);
    for (const auto& p : problems) {
      const testing::Trial trial = testing::try_method(method, *p);
      if (trial.wrong.empty()) {
        rows += fmt::format(" {} / {} |", trial.summary.iterations, trial.summary.value_evaluations);
        continue;
      }
      const std::string reason = testing::expected_failure(method, p->name());
      rows += fmt::format(" no ({}) |", ++n_notes);
      notes += fmt::format("{}. `{}`, {}: {}\n", n_notes, method, p->name(), reason.empty() ? trial.wrong : reason);
    }
    rows += "\n";
  }
  fmt::print("{}\n{}\n{}\n{}", head, rule, rows, notes);
}
