// `match` and `run`: run an experiment given on the command line or by a YAML file.

#include "apps/commands.h"
#include "apps/experiment_overrides.h"
#include "apps/process/interrupt.h"
#include "apps/terminal/progress.h"
#include "base/error.h"
#include "matching/experiment/yaml_options.h"
#include "matching/result/verdict.h"
#include "matching/run_matching.h"

#include <algorithm>
#include <filesystem>
#include <string>
#include <vector>

namespace shellmatch {

namespace {

// The verdicts that --fail-on makes a failure.
std::vector<std::string> failures(const std::string& fail_on) {
  if (fail_on.empty()) return {};
  if (fail_on == "not-matched") return {"not-matched"};
  if (fail_on == "look-here") return {"look-here", "not-matched"};
  throw_input_error("--fail-on {}: expected look-here or not-matched", fail_on);
}

void match(const ExperimentOptions& options, const std::string& output, const RunSettings& settings) {
  const std::vector<std::string> failing = failures(settings.fail_on);
  catch_interrupts();
  Progress progress(settings.verbosity, options.cascade.max_level);
  const AnyMatchResult result =
      run_matching(options, output, {.force = settings.force, .restart = settings.restart}, progress);
  const MatchSummary& summary = summary_of(result);
  for (const std::string& line : verdict_lines(summary)) progress.note(line);
  progress.note(fmt::format("written: {}", output));
  if (std::ranges::find(failing, summary.verdict->outcome) == failing.end()) return;
  progress.finished();
  throw CheckFailed(fmt::format("{}: the verdict is {} (--fail-on {}): {}", output, summary.verdict->outcome,
                                settings.fail_on, summary.verdict->reasons.front().what));
}

}  // namespace

void execute(const MatchCommand& command) {
  std::vector<Override> overrides = {{"input.reference", command.reference, "REFERENCE"},
                                     {"input.template", command.template_shape, "TEMPLATE"}};
  for (Override& change : overrides_of(command.settings)) overrides.push_back(std::move(change));
  match(make_experiment(overrides), command.settings.output, command.settings);
}

void execute(const RunCommand& command) {
  const ExperimentOptions options = read_run_options(command.config, command.settings);
  const std::string name = std::filesystem::path(command.config).stem().string();
  match(options, command.settings.output.empty() ? "out/" + name : command.settings.output, command.settings);
}

}  // namespace shellmatch
