// `check-gradient`: checks that every term's gradient is the derivative of its value.
// `self-test`: checks what this program computes on this machine against what is known.

#include "apps/commands.h"
#include "apps/experiment_overrides.h"
#include "apps/output_file.h"
#include "apps/process/interrupt.h"
#include "apps/terminal/progress.h"
#include "apps/terminal/words.h"
#include "base/error.h"
#include "base/parallel.h"
#include "base/printable.h"
#include "base/text.h"
#include "geometry/io/picture_height.h"
#include "matching/experiment/yaml_options.h"
#include "matching/input/shape_source.h"
#include "matching/pairs/slicer_points.h"
#include "matching/pairs/tps_specimens.h"
#include "matching/run_gradient_check.h"
#include "matching/self_test/self_test.h"
#include "matching/shape_report/inspection.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <iostream>

namespace shellmatch {

void execute(const ConfigCommand& command) {
  std::vector<Override> overrides;
  if (!command.profile.empty()) overrides.push_back({"profile", command.profile, "--profile " + command.profile});
  print_reference(std::cout, make_experiment(overrides).profile,
                  command.markdown ? ReferenceFormat::markdown : ReferenceFormat::yaml);
}

void execute(const PrintCommand& command) { std::cout << command.text; }

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

namespace {

void inspect_points(const InspectCommand& command) {
  const SlicerPoints file = read_slicer_points(command.file);
  if (command.json) std::cout << slicer_points_json(file);
  else std::cout << slicer_points_text(file);
}

}  // namespace

void execute(const InspectCommand& command) {
  if (is_slicer_file(command.file)) return inspect_points(command);
  if (const auto specimens = listed_specimens(command.file)) {
    std::cout << (command.json ? specimens_json(command.file, *specimens) : specimens_text(command.file, *specimens));
    return;
  }
  Progress progress(isatty(STDERR_FILENO) != 0 ? Verbosity::normal : Verbosity::quiet, 0);
  progress.stage("reading");
  const AnyShape shape = open_shape(command.file, Closing::automatic);
  progress.stage("measuring");
  const Inspection inspection = std::visit([](const auto& s) { return inspect_shape(s); }, shape);
  progress.finished();
  std::cout << (command.json ? inspection_json(inspection) : inspection_text(inspection));
  if (const double height = command.json ? 0 : picture_height(command.file); height > 0)
    std::cout << fmt::format(
        "  y axis                upward, from 0 at the bottom of the picture to {:g} at its top, in pixels\n", height);
}

void execute(const SelfTestCommand& command) {
  catch_interrupts();
  set_n_threads(command.threads.empty() ? 0 : whole_number(command.threads, "--threads", 0));
  const auto checks = run_self_test([&](const std::string& group) {
    if (command.verbosity == Verbosity::verbose) std::cerr << fmt::format("{} ...\n", group);
  });
  if (command.verbosity != Verbosity::quiet) std::cout << self_test_text(checks);
  const auto n_failed = std::ranges::count_if(checks, [](const SelfCheck& c) { return !c.passed(); });
  if (n_failed > 0)
    throw CheckFailed(
        fmt::format("self-test: {} of {} checks failed: {}", n_failed, checks.size(), failed_checks(checks)));
}

}  // namespace shellmatch
