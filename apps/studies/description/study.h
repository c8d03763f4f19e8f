#pragma once
/// \file
/// A comparison study, problems x solvers x metrics x parameters x repeats: its description, and the list of its runs.

#include "apps/studies/description/option_file.h"
#include "apps/studies/execution/run_task.h"
#include "base/options.h"
#include "matching/experiment/options.h"
#include "matching/experiment/yaml_options.h"

#include <string>
#include <utility>
#include <vector>

namespace shellmatch {

/// The options of a study's file.
struct StudyOptions {
  int version = 1;
  std::string title, folder;
  int repeats = 1;
  RunLimits limits;
  FreeSection set, problems, solvers, metrics, parameters;
  static void describe(auto& self, auto& visit) {
    visit("version", self.version, {.min = 1, .meaning = "of the form of this file; 1"});
    visit("title", self.title, {.meaning = "heading of the summary"});
    visit("folder", self.folder,
          {.meaning = "absolute folder to which the paths of this file are relative; empty: that of the file. The copy "
                      "in the output folder names it, so that the copy can be run from anywhere"});
    visit("repeats", self.repeats,
          {.unit = "runs",
           .min = 1,
           .max = 1000,
           .meaning = "how often each combination runs: evaluations repeat to the bit, seconds do not"});
    visit("limits", self.limits, {.meaning = "what one run may cost"});
    visit("set", self.set, {.meaning = "options of an experiment for all runs"});
    visit("problems", self.problems, {.meaning = "name: {base: FILE.yaml, set: options of an experiment}"});
    visit("solvers", self.solvers, {.meaning = "name: options below `solver`; or a list of methods"});
    visit("metrics", self.metrics, {.meaning = "list of values of solver.metric"});
    visit("parameters", self.parameters, {.meaning = "option of an experiment: list of its values"});
  }
};

/// A named choice, and the settings that it stands for.
struct StudyChoice {
  std::string name;
  std::string base;               ///< YAML file of an experiment; may be empty
  std::vector<Override> changes;  ///< in the order of their application
};

/// One axis of the product: an option and its values.
struct StudyParameter {
  std::string key;
  std::vector<Override> values;
};

/// A study as its file describes it. Later settings win: base, set, problem, solver, metric, parameters, overrides.
struct Study {
  std::string file;
  StudyOptions options;
  std::vector<Override> common;  ///< of the key `set`
  std::vector<StudyChoice> problems, solvers;
  std::vector<Override> metrics;  ///< of solver.metric; empty keeps the solvers' own
  std::vector<StudyParameter> parameters;
  std::vector<Override> overrides;  ///< of the command line
};

/// \param overrides options of an experiment for all runs, or keys of the study such as limits.seconds
/// \throws InputError naming file, line and key: unknown keys, another version, no runs
Study read_study(const std::string& path, std::vector<Override> overrides = {});

/// One run of a study, with all options resolved.
/// Its name is as "leaf-newton-energy.delta=0.5-r1", its fingerprint that of `options` and the contents of their input
/// files.
struct StudyRun : RunTask {
  std::string problem, solver;
  std::string metric;                                           ///< as resolved; "own" for a method with its own metric
  std::vector<std::pair<std::string, std::string>> parameters;  ///< key and value in YAML's notation
  int repeat = 1;                                               ///< counted from 1
  ExperimentOptions options;
  std::string energy_key;  ///< equal for runs that minimise the same function on the finest level

  /// The solver with its metric: "lbfgs (l2)".
  std::string method() const { return metric == "own" ? solver : solver + " (" + metric + ")"; }
};

/// The product, in which problems vary slowest and repeats fastest. A method with its own metric runs once, not for
/// every metric. \throws InputError for an invalid option, a missing input or two runs of the same name
std::vector<StudyRun> runs_of(const Study& study);

}  // namespace shellmatch
