// `check-gradient`: checks that every term's gradient is the derivative of its value.

#include "apps/commands.h"
#include "apps/experiment_overrides.h"
#include "apps/process/interrupt.h"
#include "apps/output_file.h"
#include "apps/progress.h"
#include "base/error.h"
#include "matching/run_gradient_check.h"

#include <charconv>
#include <iostream>

namespace shellmatch {

namespace {

int to_integer(const std::string& option, const std::string& text, int least) {
  int value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (text.empty() || error != std::errc() || end != text.data() + text.size() || value < least)
    throw_input_error("{} {}: expected an integer >= {}", option, text, least);
  return value;
}

}  // namespace

void execute(const CheckGradientCommand& command) {
  GradientCheckRequest request;
  if (!command.level.empty()) request.level = to_integer("--level", command.level, 1);
  if (!command.directions.empty()) request.settings.n_directions = to_integer("--directions", command.directions, 1);
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
  if (!report.passed()) throw CheckFailed(fmt::format("{}: wrong derivatives: {}", command.config, report.failed_terms()));
}

}  // namespace shellmatch
