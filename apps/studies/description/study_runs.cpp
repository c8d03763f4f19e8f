#include "base/error.h"
#include "base/text.h"
#include "matching/cascade/schedule.h"
#include "matching/output/checksum.h"
#include "matching/experiment/option_text.h"
#include "solvers/minimizer.h"
#include "apps/studies/execution/run_inputs.h"
#include "apps/studies/description/study.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>

namespace shellmatch {

namespace {

// Protects against mistakes in the file; no study needs more.
constexpr std::size_t most_runs = 20000;

std::string energy_key_of(ExperimentOptions o, const std::string& inputs) {
  // Resets all options that do not change the function minimised last. Options not listed here are part of the key.
  const ScheduleStep last = schedule_of_level(o.cascade, o.cascade.max_level).back();
  const ExperimentOptions defaults;
  o.profile = defaults.profile;
  o.solver = defaults.solver;
  o.threads = defaults.threads;
  o.pictures = defaults.pictures;
  o.report = defaults.report;
  o.input.correspondence.clear();
  CascadeOptions& c = o.cascade;
  c.nu = last.nu;
  c.volume = last.volume_weight;
  c.nu_factor = c.volume_factor = 1;
  c.nu_substeps = 1;
  c.negligible_start_rise = c.negligible_rise = 0;
  c.intermediate_decrease = c.substep_decrease = 0;
  return text_checksum(portable_yaml(o) + inputs);
}

class Product {
 public:
  explicit Product(const Study& study) : study_(study) {}

  std::vector<StudyRun> all() {
    for (const StudyChoice& problem : study_.problems)
      for (const StudyChoice& solver : study_.solvers) {
        const std::size_t n_metrics = std::max<std::size_t>(1, study_.metrics.size());
        for (std::size_t m = 0; m < n_metrics; ++m) {
          std::vector<Override> changes = study_.common;
          changes.insert(changes.end(), problem.changes.begin(), problem.changes.end());
          changes.insert(changes.end(), solver.changes.begin(), solver.changes.end());
          if (!study_.metrics.empty()) changes.push_back(study_.metrics[m]);
          StudyRun run;
          run.problem = problem.name;
          run.solver = solver.name;
          grid(problem, changes, run, 0, m);
        }
      }
    return std::move(runs_);
  }

 private:
  // Recursion over the axes of parameters.
  void grid(const StudyChoice& problem, std::vector<Override>& changes, StudyRun& run, std::size_t axis,
            std::size_t metric) {
    if (axis == study_.parameters.size()) return add(problem, changes, run, metric);
    for (const Override& value : study_.parameters[axis].values) {
      changes.push_back(value);
      run.parameters.emplace_back(value.key, value.value);
      grid(problem, changes, run, axis + 1, metric);
      run.parameters.pop_back();
      changes.pop_back();
    }
  }

  void add(const StudyChoice& problem, std::vector<Override> changes, StudyRun run, std::size_t metric) {
    changes.insert(changes.end(), study_.overrides.begin(), study_.overrides.end());
    run.options =
        with_absolute_paths(problem.base.empty() ? make_experiment(changes) : read_experiment(problem.base, changes));
    const std::string where = fmt::format("{}: problems.{}", study_.file, run.problem);
    for (const auto& [key, source] : {std::pair{"reference", &run.options.input.reference},
                                      std::pair{"template", &run.options.input.template_file}})
      if (source->empty())
        throw_input_error("{}: input.{} is missing; set it, or name a base file that does", where, key);

    // Checkpoints are disabled, because the times of a resumed run would not be comparable.
    run.options.resume = {.enabled = false};
    const LevelwiseSolverOptions& solver = run.options.solver;
    const bool own = !make_minimizer(solver)->uses_metric() && solver.levels.entries.empty();
    run.metric = own ? "own" : std::string(enum_name(solver.metric));
    if (run.metric == "own" && metric > 0) return;
    const OptionNode tree = option_tree(run.options);
    // Options for single levels (solver.levels.6.name) stand in no tree: their values stay as the study says them.
    for (auto& [key, value] : run.parameters)
      if (const OptionNode* option = find_option(tree, key)) value = value_text(*option);
    run.config = to_yaml(run.options);
    const std::string inputs = inputs_.of(run.options, where);
    run.fingerprint = fingerprint_of(run.options, inputs);
    run.energy_key = energy_key_of(run.options, inputs);

    std::string name = run.problem + "-" + run.solver;
    if (!study_.metrics.empty() && run.metric != "own") name += "-" + run.metric;
    for (const auto& [key, value] : run.parameters) name += fmt::format("-{}={}", key, value);
    name = safe_file_name(name);
    for (run.repeat = 1; run.repeat <= study_.options.repeats; ++run.repeat) {
      run.name = fmt::format("{}-r{}", name, run.repeat);
      if (run.name.size() > 200)
        throw_input_error("{}: the run name {} is too long for a file; shorten names or values of parameters",
                          study_.file, run.name);
      if (!names_.try_emplace(run.name, 1).second)
        throw_input_error("{}: two runs are called {}; problems, solvers and values of parameters must differ",
                          study_.file, run.name);
      if (runs_.size() == most_runs)
        throw_input_error("{}: more than {} runs; split the study", study_.file, most_runs);
      runs_.push_back(run);
    }
  }

  const Study& study_;
  RunInputs inputs_;
  std::map<std::string, int> names_;
  std::vector<StudyRun> runs_;
};

}  // namespace

std::vector<StudyRun> runs_of(const Study& study) { return Product(study).all(); }

}  // namespace shellmatch
