#include "apps/cohorts/execution/run_cohort.h"

#include "base/error.h"
#include "apps/cohorts/execution/atlas.h"
#include "apps/cohorts/execution/kept_results.h"
#include "apps/cohorts/execution/round_record.h"
#include "apps/cohorts/execution/stage_tasks.h"
#include "apps/cohorts/subjects/mirrored.h"
#include "matching/input/shape_source.h"
#include "matching/output/checksum.h"
#include "matching/pairs/point_frame.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace shellmatch {

namespace {

// The folder of a round holds the mean that it has come to.
const RunsFolderKind round_folder_kind{"cohort", {}, {"mean.ply", "mean.csv", "mean_landmarks.csv", "round.json"}, ""};

// All but the contents of files on which the means of rounds depend.
std::string text_of_rounds(const Cohort& cohort) {
  Cohort c = cohort;
  c.options.title.clear();
  c.options.table.clear();  // to_yaml() lists the subjects instead
  c.options.limits = {};
  c.options.statistics = {};
  c.options.statistics.procrustes = cohort.options.statistics.procrustes;
  std::string text = to_yaml(c);
  for (const Subject& subject : cohort.subjects)
    text += fmt::format("\n{} {} {}", subject.id, subject.landmarks, subject.reflect);
  return text;
}

const Subject* find_subject(const Cohort& cohort, const std::string& id) {
  const auto found = std::ranges::find(cohort.subjects, id, &Subject::id);
  return found == cohort.subjects.end() ? nullptr : &*found;
}

template <int Dim>
class CohortRun {
 public:
  CohortRun(const Cohort& cohort, const RunsFolder& folder, const TaskSettings& settings, const CohortPart& part,
            CohortObserver& observer)
      : cohort_(cohort),
        folder_(folder),
        settings_(settings),
        part_(part),
        observer_(observer),
        tasks_(cohort, folder.path() + "/mirrored"),
        checksum_(text_checksum(text_of_rounds(cohort))) {
    all_.resize(cohort.subjects.size());
    std::iota(all_.begin(), all_.end(), std::size_t{0});
  }

  CohortOutcome go(OriginalShape<Dim> shape, const std::string& landmarks) {
    Atlas<Dim> atlas = make_atlas<Dim>(shape, read_landmarks_of(shape, landmarks), folder_.path() + "/atlas", "start");
    const AtlasKind kind = cohort_.options.atlas.kind;
    const int n = n_rounds(cohort_);
    if (n == 0 && kind != AtlasKind::given && !is_part())
      observer_.note(
          fmt::format("a cohort of one subject has no mean{}, and no rounds are done for it",
                      find_subject(cohort_, cohort_.options.atlas.shape) == nullptr
                          ? ""
                          : "; without another shape for the atlas (--atlas FILE) it is matched onto itself"));
    for (int k = 1; k <= n; ++k) {
      const Stage stage{k};
      const std::optional<CohortEnd> end = perform_round(stage, atlas);
      if (end) return {*end};
      const RoundRecord record = *read_round(stage.folder(folder_.path()) + "/round.json");
      rounds_.push_back(record.round);
      atlas = kind == AtlasKind::medoid ? atlas_of_subject(record.nearest)
                                        : read_atlas<Dim>(stage.folder(folder_.path()), "mean");
      if (kind == AtlasKind::mean) atlas.files.runs = stage.folder(folder_.path()) + "/runs";
      if (record.converged) break;
      if (k == n && kind == AtlasKind::mean && !is_part())
        observer_.note(
            fmt::format("the mean still moved by {:.2g} diagonals in the last of {} rounds (atlas.rounds, "
                        "atlas.tolerance)",
                        record.round.change, k));
    }
    Atlas<Dim> last = make_atlas<Dim>(atlas.shape, atlas.landmarks, folder_.path(), "atlas");
    last.files.runs = atlas.files.runs;
    return last_stage(std::move(last));
  }

 private:
  bool is_part() const { return !part_.subjects.empty(); }

  std::vector<NamedPoint<Dim>> read_landmarks_of(const OriginalShape<Dim>& shape, const std::string& file) const {
    std::vector<std::string> notes;
    if (file.empty()) return {};
    const Space space = space_beside(shape, file, wanted_space(cohort_.experiment.input));
    return read_named_points<Dim>(file, shape.vertices, space, space, notes, nullptr, shape.frame);
  }

  Atlas<Dim> atlas_of_subject(const std::string& id) {
    const Subject* found = find_subject(cohort_, id);
    if (found == nullptr)
      throw_input_error("{}: {} is the medoid and no longer a subject: close the rounds again with --collect",
                        folder_.path(), id);
    const Subject& subject = *found;
    Shape<Dim> shape = std::get<Shape<Dim>>(
        open_shape(tasks_.source_of(subject), cohort_.experiment.input.close, volume_space(cohort_.experiment.input)));
    std::vector<NamedPoint<Dim>> landmarks = read_landmarks_of(shape.original, tasks_.landmarks_of(subject));
    return make_atlas<Dim>(std::move(shape.original), std::move(landmarks), folder_.path() + "/atlas", "medoid");
  }

  std::vector<std::string> landmark_files() const {
    std::vector<std::string> files;
    for (const Subject& subject : cohort_.subjects) files.push_back(tasks_.landmarks_of(subject));
    return files;
  }

  // All on which the mean of a round depends.
  std::string checksum_of(const RunsFolder& runs, const std::vector<RunTask>& tasks) const {
    std::string text = checksum_;
    for (const RunTask& task : tasks)
      text += fmt::format("\n{} {} {}", task.name, task.fingerprint, status_name(runs.result_of(task).status));
    return text_checksum(text);
  }

  // Matches what is asked for; false if that was stopped.
  bool match(const Stage& stage, const std::vector<RunTask>& tasks, const RunsFolder& runs) {
    observer_.stage_started(stage, tasks.size());
    return run_tasks(tasks_of(tasks), cohort_.options.limits, runs, settings_, observer_);
  }

  static std::size_t n_unmatched(const std::vector<RunTask>& tasks, const RunsFolder& runs) {
    return static_cast<std::size_t>(std::ranges::count_if(
        tasks, [&](const RunTask& task) { return runs.result_of(task).status == RunStatus::not_run; }));
  }
  static bool is_matched(const std::vector<RunTask>& tasks, const RunsFolder& runs) {
    return n_unmatched(tasks, runs) == 0;
  }

  // How the work ends with this round; nothing where it goes on.
  std::optional<CohortEnd> perform_round(const Stage& stage, const Atlas<Dim>& atlas) {
    const std::string folder = stage.folder(folder_.path()), record_file = folder + "/round.json";
    const std::optional<RoundRecord> earlier = read_round(record_file);
    const bool is_known = earlier && earlier->cohort == checksum_ && has_atlas(folder, "mean", Dim);
    if (is_part()) {
      const bool is_ours = !part_.stage || *part_.stage == stage;
      // A subject whose file has changed is matched again, though the round was closed with it.
      if (is_known &&
          is_matched(tasks_.of(stage, atlas.files, part_.subjects), RunsFolder(folder, round_folder_kind, false)))
        return is_ours && part_.stage ? std::optional(CohortEnd::in_part) : std::nullopt;
      if (!is_ours)
        throw_input_error("{}: {} waits for {}: close that with --collect", folder_.path(), part_.stage->name(),
                          stage.name());
      const RunsFolder runs(folder, round_folder_kind, false);
      return match(stage, tasks_.of(stage, atlas.files, part_.subjects), runs) ? CohortEnd::in_part
                                                                               : CohortEnd::stopped;
    }
    const RunsFolder runs(folder, round_folder_kind, folder_.is_whole());
    const std::vector<RunTask> tasks = tasks_.of(stage, atlas.files, all_);
    if (!part_.collect && !match(stage, tasks, runs)) return CohortEnd::stopped;
    if (const std::size_t n_left = n_unmatched(tasks, runs); n_left > 0)
      throw_input_error("{}: {}: {} of {} subjects have no result yet", folder_.path(), stage.name(), n_left,
                        tasks.size());
    if (const std::string results = checksum_of(runs, tasks); !is_known || earlier->results != results)
      close(stage, atlas, tasks, runs, results);
    observer_.round_ended(read_round(record_file)->round);
    return part_.stage == stage ? std::optional(CohortEnd::in_part) : std::nullopt;
  }

  // Makes the mean of a round, which is the atlas of the next one.
  void close(const Stage& stage, const Atlas<Dim>& atlas, const std::vector<RunTask>& tasks, const RunsFolder& runs,
             const std::string& results) {
    const StageResult<Dim> matched = read_stage<Dim>(cohort_, stage, runs, tasks, atlas, landmark_files());
    if (matched.rows.empty() && std::ranges::all_of(matched.subjects, lacks_memory))
      throw MemoryError(
          fmt::format("{}: {}: no subject can be used for the mean, since all ended at their limit of memory",
                      folder_.path(), stage.name()));
    if (matched.rows.empty())
      throw_input_error("{}: {}: no subject can be used for the mean; the first, {}: {}{}", folder_.path(),
                        stage.name(), matched.subjects.front().id, matched.subjects.front().outcome,
                        matched.subjects.front().message);
    const MeanAtlas<Dim> mean = mean_atlas(atlas, matched.points, cohort_.options.statistics.procrustes);
    make_atlas<Dim>(mean.shape, mean.landmarks, runs.path(), "mean");
    RoundRecord record;
    record.cohort = checksum_;
    record.results = results;
    record.round = {stage.round, matched.rows.size(), mean.change, mean.spread};
    record.converged = mean.change <= cohort_.options.atlas.tolerance * mean.spread /
                                          std::sqrt(static_cast<double>(matched.rows.size()));
    record.nearest = cohort_.subjects[matched.rows[mean.nearest]].id;
    write_round(record, runs.path() + "/round.json");
  }

  // Matches the first subjects, so that the poses of the others can be predicted. How the work ends with them; nothing
  // where it goes on.
  std::optional<CohortEnd> perform_first(Atlas<Dim>& atlas) {
    const Stage stage{Stage::first_part};
    const bool is_asked = part_.stage == stage;
    const std::optional<CohortEnd> end = is_asked ? std::optional(CohortEnd::in_part) : std::nullopt;
    const std::vector<std::size_t> first = Dim == 3 ? first_subjects(cohort_) : std::vector<std::size_t>{};
    if (first.empty()) return end;
    const auto is_open = [&] { return !is_matched(tasks_.of(stage, atlas.files, first), folder_); };
    if (is_part()) {
      if (is_open() && part_.stage && !is_asked)
        throw_input_error("{}: {} waits for {}: match these with --stage first", folder_.path(), part_.stage->name(),
                          stage.name());
      std::vector<std::size_t> own;
      for (const std::size_t k : first)
        if (std::ranges::find(part_.subjects, k) != part_.subjects.end()) own.push_back(k);
      if (!own.empty() && !match(stage, tasks_.of(stage, atlas.files, own), folder_)) return CohortEnd::stopped;
      if (!is_asked && is_open()) {
        observer_.note("the other subjects wait for the first ones of other parts; then the same command goes on");
        return CohortEnd::in_part;
      }
    } else if (!part_.collect && !match(stage, tasks_.of(stage, atlas.files, first), folder_)) {
      return CohortEnd::stopped;
    }
    if (!is_part() && is_asked && is_open())
      throw_input_error("{}: {}: some have no result yet", folder_.path(), stage.name());
    atlas.files.images = tasks_.images_of(first, folder_.path() + "/runs");
    return end;
  }

  CohortOutcome last_stage(Atlas<Dim> atlas) {
    const Stage stage{};
    if (part_.stage && !part_.stage->is_last())
      return {CohortEnd::in_part};  // the search for the atlas ended before that round
    if (const std::optional<CohortEnd> end = perform_first(atlas)) return {*end};
    if (is_part()) {
      return {match(stage, tasks_.of(stage, atlas.files, part_.subjects), folder_) ? CohortEnd::in_part
                                                                                   : CohortEnd::stopped};
    }
    const std::vector<RunTask> tasks = tasks_.of(stage, atlas.files, all_);
    if (!part_.collect && !match(stage, tasks, folder_)) return {CohortEnd::stopped};
    StageResult<Dim> result = read_stage<Dim>(cohort_, stage, folder_, tasks, atlas, landmark_files());
    return {CohortEnd::finished, FinishedCohort<Dim>{std::move(atlas), std::move(result), rounds_}};
  }

  const Cohort& cohort_;
  const RunsFolder& folder_;
  const TaskSettings& settings_;
  const CohortPart& part_;
  CohortObserver& observer_;
  StageTasks tasks_;
  std::string checksum_;
  std::vector<std::size_t> all_;
  std::vector<AtlasRound> rounds_;
};

CohortOutcome run(const Cohort& cohort, const RunsFolder& folder, const TaskSettings& settings, const CohortPart& part,
                  CohortObserver& observer) {
  const StageTasks sources(cohort, folder.path() + "/mirrored");
  const AtlasOptions& atlas = cohort.options.atlas;
  const InputOptions& input = cohort.experiment.input;
  const Subject* subject = find_subject(cohort, atlas.shape);
  const AnyShape shape =
      open_shape(subject != nullptr ? sources.source_of(*subject) : atlas.shape, input.close, volume_space(input));
  const std::string landmarks =
      atlas.landmarks.empty() && subject != nullptr ? sources.landmarks_of(*subject) : atlas.landmarks;
  return std::visit(
      [&]<int Dim>(const Shape<Dim>& s) {
        return CohortRun<Dim>(cohort, folder, settings, part, observer).go(s.original, landmarks);
      },
      shape);
}

}  // namespace

int n_rounds(const Cohort& cohort) {
  const AtlasOptions& atlas = cohort.options.atlas;
  if (cohort.subjects.size() == 1) return 0;  // it is its own mean
  return atlas.kind == AtlasKind::given ? 0 : atlas.kind == AtlasKind::medoid ? 1 : atlas.rounds;
}

const RunsFolderKind cohort_folder_kind{
    "cohort",
    {"cohort.yaml"},
    {"atlas", "atlas.ply", "atlas.csv", "atlas_landmarks.csv", "mirrored", "model", "subjects.csv", "times.csv",
     "landmarks.csv", "landmarks.tps", "landmarks.txt", "landmarks_on_atlas.csv", "summary.json", "report.html"},
    "model"};

CohortOutcome run_cohort(const Cohort& cohort, const RunsFolder& folder, const TaskSettings& settings,
                         const CohortPart& part, CohortObserver& observer) {
  return saying_what_is_kept(folder.path(), [&] { return run(cohort, folder, settings, part, observer); });
}

}  // namespace shellmatch
