// `check-gradient`: checks that every term's gradient is the derivative of its value.

#include "apps/commands.h"
#include "apps/experiment_overrides.h"
#include "apps/process/interrupt.h"
#include "apps/output_file.h"
#include "apps/terminal/progress.h"
#include "apps/terminal/words.h"
#include "base/error.h"
#include "matching/run_gradient_check.h"

#include <iostream>

namespace shellmatch {

void execute(const CheckGradientCommand& command) {
  GradientCheckRequest request;
  if (!command.level.empty()) request.level = whole_number(command.level, "--level", 1);
  if (!command.directions.empty()) request.settings.n_directions = whole_number(command.directions, "--directions", 1);
  if (!command.state.empty()) request.state = CheckState::parse(command.state);
  if (!command.json.empty()) check_report_file(command.json, command.settings.force);
  const ExperimentOptions options = read_run_options(command.config, command.settings);

  catch_interrupts();
  Progress progress(command.settings.verbosity, options.cascade.max_level);
  GradientReport report = run_gradient_check(options, request, progress);
  report.source = command.config;
  progress.finished();
  if (command.settings.verbosity != Verbosity::quiet) std::cout << gradient_report_text(report);
  if (!command.json.empty()) write_report_file(command.json, gradient_report_json(report), command.settings.force);
  if (!report.passed())
    throw CheckFailed(fmt::format("{}: wrong derivatives: {}", command.config, report.failed_terms()));
}

}  // namespace shellmatch
