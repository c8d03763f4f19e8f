// `cohort`: one shape matched onto many, and their statistics.

#include "apps/cohorts/execution/kept_results.h"
#include "apps/cohorts/execution/run_cohort.h"
#include "apps/cohorts/execution/stage_tasks.h"
#include "apps/cohorts/output/own_files.h"
#include "apps/cohorts/output/write_cohort.h"
#include "apps/cohorts/subjects/mirrored.h"
#include "apps/commands.h"
#include "apps/experiment_overrides.h"
#include "apps/process/interrupt.h"
#include "apps/process/limits.h"
#include "apps/runs/runs.h"
#include "base/error.h"
#include "base/parallel.h"
#include "base/stop.h"
#include "geometry/mesh_text/read_text.h"
#include "matching/cascade/size_estimate.h"
#include "matching/experiment/option_text.h"
#include "matching/input/shape_source.h"
#include "matching/progress/process_info.h"

#include <algorithm>
#include <filesystem>
#include <iostream>
#include <optional>

namespace shellmatch {

namespace {

class CohortProgress final : public RunsProgress, public CohortObserver {
 public:
  explicit CohortProgress(bool is_quiet) : RunsProgress(is_quiet) {}
  void stage_started(const Stage& stage, std::size_t n_subjects) override {
    say(fmt::format("{}: {} subject{}", stage.name(), n_subjects, n_subjects == 1 ? "" : "s"));
  }
  void round_ended(const AtlasRound& round) override {
    say(fmt::format("round {}: the mean of {} subjects is {:.2g} diagonals from the atlas (their spread: {:.2g})",
                    round.round, round.n_subjects, round.change, round.spread));
  }
  void note(const std::string& text) override { say(text); }
};

bool is_yaml_file(const std::string& name) { return name.ends_with(".yaml") || name.ends_with(".yml"); }

// What to ask a cluster for: of one matching of the last stage.
struct CohortCost {
  int threads = 1;
  double seconds = 0;  ///< wall time; meant to be too much
  double memory_mb = 0;
};

// A minimisation takes up to some hundred steps of some microseconds for each node; a core of 2020 needs
// about a tenth of it.
constexpr double seconds_per_node = 2e-3, least_seconds = 120, reserve = 2;

template <int Dim>
SizeEstimate size_of(Surface<Dim> surface, const ExperimentOptions& options) {
  const Box<Dim> box = bounding_box(surface.vertices);
  const double side = (box.max - box.min).maxCoeff(), scale = (1 - 2 * options.input.margin) / side;
  for (Vec<Dim>& x : surface.vertices) x = (x - box.min) * scale + Vec<Dim>::Constant(options.input.margin);
  return estimate_size<Dim>(refined_measures(surface, surface, options), options.cascade.min_level,
                            options.cascade.max_level);
}

// The cohort's limits where it has some; otherwise from the size of the finest grid of the atlas matched
// onto itself (matching/cascade/size_estimate.h), with as much again for subjects that are larger.
CohortCost estimate_cost(const Cohort& cohort) {
  CohortCost cost{std::max(1, cohort.experiment.threads), cohort.options.limits.seconds,
                  cohort.options.limits.memory_mb};
  if (cost.seconds > 0 && cost.memory_mb > 0) return cost;
  const std::string& atlas = cohort.options.atlas.shape;
  const auto subject = std::ranges::find(cohort.subjects, atlas, &Subject::id);
  const InputOptions& input = cohort.experiment.input;
  const AnyShape shape =
      open_shape(subject == cohort.subjects.end() ? atlas : subject->source, input.close, volume_space(input));
  const SizeEstimate size = std::visit([&](const auto& s) { return size_of(s.surface, cohort.experiment); }, shape);
  if (cost.seconds == 0) cost.seconds = least_seconds + reserve * seconds_per_node * size.n_nodes / cost.threads;
  if (cost.memory_mb == 0) cost.memory_mb = reserve * size.memory_bytes / 1e6;
  return cost;
}

Cohort cohort_of(const CohortCommand& command) {
  CohortWords words;
  words.table = command.table;
  words.atlas = command.atlas;
  std::string file;
  for (const std::string& name : command.shapes) {
    if (!is_yaml_file(name)) {
      words.shapes.push_back(name);
    } else if (command.shapes.size() > 1) {
      throw_input_error("{}: is the file of a cohort, which names all its shapes; give it alone", name);
    } else {
      file = name;
    }
  }
  // An atlas that is named is meant to be it.
  if (!command.atlas.empty() && command.kind.empty() && file.empty())
    words.overrides.push_back({"atlas.kind", "given", "--atlas"});
  if (!command.kind.empty()) words.overrides.push_back({"atlas.kind", command.kind, "--kind " + command.kind});
  if (!command.atlas_landmarks.empty())
    words.overrides.push_back({"atlas.landmarks", command.atlas_landmarks, "--atlas-landmarks"});
  RunSettings settings;
  settings.levels = command.levels;
  settings.assignments = command.assignments;
  for (Override& change : overrides_of(settings)) words.overrides.push_back(std::move(change));
  return read_cohort(file, words);
}

// The subjects of a shard "I/N": every N-th one, from the I-th on.
std::vector<std::size_t> shard_of(const std::string& text, std::size_t n_subjects) {
  const std::size_t slash = text.find('/');
  const auto first = shellmatch::to_integer(text.substr(0, slash)),
             n = slash == std::string::npos ? std::nullopt : shellmatch::to_integer(text.substr(slash + 1));
  if (!first || !n || *n < 1 || *first < 1 || *first > *n)
    throw_input_error("--shard {}: expected I/N with 1 <= I <= N, as 3/16", text);
  std::vector<std::size_t> subjects;
  for (auto k = static_cast<std::size_t>(*first - 1); k < n_subjects; k += static_cast<std::size_t>(*n))
    subjects.push_back(k);
  return subjects;
}

std::vector<std::size_t> only(const Cohort& cohort, const std::vector<std::string>& ids) {
  std::vector<std::string> known;
  for (const Subject& subject : cohort.subjects) known.push_back(subject.id);
  std::vector<std::size_t> subjects;
  for (const std::string& id : ids) {
    const auto found = std::ranges::find(known, id);
    if (found == known.end()) {
      const std::string near = nearest_word(id, known);
      throw_input_error("--only {}: the cohort has no such subject; {}--list lists them", id,
                        near.empty() ? "" : fmt::format("did you mean {}? ", near));
    }
    const auto subject = static_cast<std::size_t>(found - known.begin());
    if (std::ranges::find(subjects, subject) == subjects.end()) subjects.push_back(subject);
  }
  return subjects;
}

// Sets the part; false where a shard is empty, as there are more of them than subjects.
bool choose_part(const CohortCommand& command, const Cohort& cohort, CohortPart& part) {
  if (!command.only.empty() && !command.shard.empty()) throw_input_error("--only and --shard exclude each other");
  if (command.collect && (!command.only.empty() || !command.shard.empty()))
    throw_input_error("--collect is for the whole cohort, not for --only or --shard");
  part.collect = command.collect;
  part.subjects = command.only.empty() ? std::vector<std::size_t>{} : only(cohort, command.only);
  if (!command.shard.empty()) part.subjects = shard_of(command.shard, cohort.subjects.size());
  if (command.stage.empty()) return command.shard.empty() || !part.subjects.empty();
  if (part.subjects.empty() && command.shard.empty() && !part.collect)
    throw_input_error("--stage {}: is for --only, --shard or --collect", command.stage);
  const auto round = shellmatch::to_integer(command.stage);
  if (command.stage != "last" && command.stage != "first" && (!round || *round < 1 || *round > 100))
    throw_input_error("--stage {}: expected the number of a round, first or last", command.stage);
  part.stage = Stage{round ? static_cast<int>(*round) : command.stage == "first" ? Stage::first_part : 0};
  return part.collect || !part.subjects.empty();
}

void list(const Cohort& cohort, const CohortCommand& command) {
  const std::optional<CohortCost> cost =
      command.verbosity == Verbosity::verbose ? std::optional(estimate_cost(cohort)) : std::nullopt;
  for (const Subject& subject : cohort.subjects) {
    std::cout << subject.id;
    if (cost) std::cout << fmt::format("\t{}\t{:.0f}\t{:.0f}", cost->threads, cost->seconds, cost->memory_mb);
    std::cout << "\n";
  }
}

void list_stages(const Cohort& cohort) {
  for (int k = 1; k <= n_rounds(cohort); ++k) std::cout << k << "\n";
  if (!first_subjects(cohort).empty()) std::cout << "first\n";
  std::cout << "last\n";
}

// A file of the user's own, from which the cohort was read, stays as it is, comments and all.
bool is_its_own(const Cohort& cohort, const std::string& copy) {
  std::error_code error;
  return std::filesystem::equivalent(cohort.name, copy, error);
}

}  // namespace

void execute(const CohortCommand& command) {
  if (command.options) {
    std::cout << cohort_reference();
    return;
  }
  Cohort cohort = cohort_of(command);
  const int threads = std::max(1, cohort.experiment.threads);
  const TaskSettings settings{checked_program(command.program),
                              number_of_jobs(command.jobs, std::max(1, n_threads() / threads)), command.retry};
  if (command.list) return list(cohort, command);
  if (command.list_stages) return list_stages(cohort);
  if (command.output.empty() && cohort.name == "cohort")
    throw_input_error("cohort: say where to write: -o DIR (see shellmatch cohort --help)");
  const std::string output =
      command.output.empty() ? "out/" + std::filesystem::path(cohort.name).stem().string() : command.output;
  CohortPart part;
  if (!choose_part(command, cohort, part)) return;
  check_inputs_are_kept(cohort, output);
  if (!is_its_own(cohort, output + "/cohort.yaml")) check_copy_place(output + "/cohort.yaml", to_yaml(cohort));
  const RunsFolder folder(output, cohort_folder_kind, part.subjects.empty());
  if (const std::string copy = folder.path() + "/cohort.yaml"; !is_its_own(cohort, copy))
    keep_copy(copy, to_yaml(cohort));
  keep_memory_of_runs(cohort.options.limits, settings.jobs);
  catch_interrupts();
  CohortProgress progress(command.verbosity == Verbosity::quiet);
  CohortOutcome outcome = run_cohort(cohort, folder, settings, part, progress);
  if (outcome.end == CohortEnd::stopped) throw Stopped(matchings_are_kept(output), stop_cause());
  if (outcome.end == CohortEnd::in_part) return;
  std::vector<std::string> notes;
  std::string without_result;
  bool needs_memory = false;
  const auto write = [&]<int Dim>(FinishedCohort<Dim>& finished) {
    needs_memory = memory_limit_bytes() > 0 && std::ranges::any_of(finished.stage.subjects, lacks_memory);
    WrittenCohort written = write_cohort(cohort, std::move(finished), folder.path(), notes);
    for (const std::string& line : written.figures) progress.say(line);
    without_result = std::move(written.without_result);
  };
  if (auto* planar = std::get_if<FinishedCohort<2>>(&outcome.result)) write(*planar);
  if (auto* spatial = std::get_if<FinishedCohort<3>>(&outcome.result)) write(*spatial);
  for (const std::string& note : notes) progress.say(note);
  progress.say(fmt::format("written: {}/report.html", output));
  if (needs_memory) throw MemoryError(without_result + "; all are in " + output + "/subjects.csv");
  if (!without_result.empty())
    throw CheckFailed(fmt::format("{}; all are in {}/subjects.csv, and --retry repeats them", without_result, output));
}

}  // namespace shellmatch
