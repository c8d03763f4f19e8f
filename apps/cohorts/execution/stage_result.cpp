#include "apps/cohorts/execution/stage_result.h"

#include "base/error.h"
#include "geometry/io/picture_height.h"
#include "geometry/io/read_shape.h"
#include "matching/map_file/deformation_file.h"
#include "matching/output/summary.h"
#include "matching/pairs/point_frame.h"
#include "matching/report/report.h"

#include <filesystem>
#include <map>
#include <optional>
#include <utility>

namespace shellmatch {

namespace {

bool is_included(const SubjectResult& subject, Included included) {
  if (subject.status != "finished") return false;
  if (subject.outcome == "matched" || included == Included::all) return true;
  return included == Included::look_here && subject.outcome == "look-here";
}

constexpr double largest_unreached = 0.3;

template <int Dim>
OriginalShape<Dim> read_shape_as_it_is(const std::string& folder, const std::string& name) {
  if constexpr (Dim == 3) return read_points_or_mesh_3d(folder + "/" + name + ".ply");
  else return read_points_or_outline_2d(folder + "/" + name + ".csv");
}

// The results of one stage, subject by subject.
template <int Dim>
class Reader {
 public:
  Reader(const Cohort& cohort, const Stage& stage, const RunsFolder& folder, const Atlas<Dim>& atlas)
      : cohort_(cohort), stage_(stage), folder_(folder), atlas_(atlas) {}

  void add(std::size_t k, const RunTask& task, const std::string& landmarks) {
    const Subject& subject = cohort_.subjects[k];
    const RunResult run = folder_.result_of(task);
    SubjectResult row;
    row.id = subject.id;
    row.group = subject.group;
    row.status = status_name(run.status);
    row.message = run.message;
    row.seconds = run.seconds;
    if (run.status == RunStatus::finished) {
      std::optional<Finished> finished;
      try {
        finished = read_finished(task, !landmarks.empty());
      } catch (const InputError& error) {
        throw_input_error("{}; remove {} so that it is matched again", error.what(), folder_.run_folder(task));
      }
      use(std::move(*finished), k, task, landmarks, row);
    }
    result_.subjects.push_back(std::move(row));
  }

  StageResult<Dim> take() {
    result_.points.dimension = Dim;
    result_.points.coordinates.resize(atlas_.points.size(), static_cast<Eigen::Index>(columns_.size()));
    for (std::size_t c = 0; c < columns_.size(); ++c)
      result_.points.coordinates.col(static_cast<Eigen::Index>(c)) = columns_[c];
    return std::move(result_);
  }

 private:
  // What a matching has written, as far as it is used.
  struct Finished {
    std::string output;
    MatchSummary summary;
    OriginalShape<Dim> deformed;
    std::optional<Deformation<Dim>> map;        // where there are landmarks
    std::optional<OriginalShape<Dim>> subject;  // where it has landmarks of its own
  };

  Finished read_finished(const RunTask& task, bool has_landmarks) const {
    const std::string output = folder_.run_folder(task) + "/output";
    Finished f{output, read_summary(output + "/summary.json"), read_shape_as_it_is<Dim>(output, "deformed"), {}, {}};
    if (f.deformed.vertices.size() != atlas_.shape.vertices.size())
      throw_input_error("{}: has {} vertices where the atlas has {}", output, f.deformed.vertices.size(),
                        atlas_.shape.vertices.size());
    if (has_landmarks || !atlas_.landmarks.empty()) f.map = read_deformation<Dim>(output);
    if (has_landmarks) f.subject = read_shape_as_it_is<Dim>(output, "template");
    return f;
  }

  void use(Finished f, std::size_t k, const RunTask& task, const std::string& landmarks, SubjectResult& row) {
    row.folder = "runs/" + task.name + "/output";
    row.has_page = std::filesystem::exists(f.output + "/" + report_file_name);
    row.bent = f.summary.bent;
    row.distance = f.summary.distance;
    row.diagonal = f.summary.template_diagonal.value_or(0);
    if (f.summary.verdict) {
      row.outcome = f.summary.verdict->outcome;
      row.reasons = f.summary.verdict->reasons;
    }
    if (result_.unit.empty()) result_.unit = f.summary.unit.value_or("");
    result_.space = !has_space_ || result_.space == f.deformed.space ? f.deformed.space : Space::unsaid;
    has_space_ = true;
    std::vector<Vec<Dim>> carried;
    if (f.map) carried = carry(f, k, landmarks);
    row.in_model = stage_.is_last() ? is_included(row, cohort_.options.statistics.include) : is_near(f.summary);
    if (!row.in_model) return;
    Eigen::VectorXd column(atlas_.points.size());
    Eigen::Index at = 0;
    for (const std::vector<Vec<Dim>>* list : {&std::as_const(f.deformed.vertices), &std::as_const(carried)})
      for (const Vec<Dim>& x : *list) column.segment<Dim>(Dim * at++) = x;
    columns_.push_back(std::move(column));
    result_.rows.push_back(k);
  }

  // The atlas' landmarks on the subject, and the subject's own on the atlas. Matching again would not mend what is
  // wrong with these.
  std::vector<Vec<Dim>> carry(const Finished& f, std::size_t k, const std::string& landmarks) {
    const PointMap<Dim> forward(*f.map, Toward::template_shape);
    std::map<std::string, Vec<Dim>> known;
    if (f.subject) {
      std::vector<std::string> notes;
      const PointMap<Dim> back(*f.map, Toward::reference);
      const Space space = space_beside(*f.subject, landmarks, wanted_space(cohort_.experiment.input));
      // The subject is read as the run wrote it, its landmarks are as the user has them.
      const Subject& subject = cohort_.subjects[k];
      const PlaneFrame frame = Dim == 2 && !subject.reflect ? frame_of_drawing(subject.source) : PlaneFrame();
      for (const NamedPoint<Dim>& point :
           read_named_points<Dim>(landmarks, f.subject->vertices, space, space, notes, nullptr, frame)) {
        known[point.name] = point.point;
        result_.returned.push_back({k, point.name, back(point.point)});
      }
    }
    std::vector<Vec<Dim>> carried;
    for (std::size_t l = 0; l < atlas_.landmarks.size(); ++l) {
      const std::optional<Vec<Dim>> image = forward(atlas_.landmarks[l].point);
      if (!image)
        throw_input_error("{}: landmark '{}' of the atlas has no image; leave it out of atlas.landmarks", f.output,
                          atlas_.landmarks[l].name);
      carried.push_back(*image);
      const auto own = known.find(atlas_.landmarks[l].name);
      result_.carried.push_back(
          {k, l, *image, own == known.end() ? std::nullopt : std::optional<Vec<Dim>>(own->second)});
    }
    return carried;
  }

  const Cohort& cohort_;
  const Stage& stage_;
  const RunsFolder& folder_;
  const Atlas<Dim>& atlas_;
  StageResult<Dim> result_;
  std::vector<Eigen::VectorXd> columns_;
  bool has_space_ = false;
};

}  // namespace

bool is_near(const MatchSummary& summary) {
  return !summary.levels.empty() && summary.distance && summary.distance->uncovered.value_or(0) <= largest_unreached;
}

template <int Dim>
StageResult<Dim> read_stage(const Cohort& cohort, const Stage& stage, const RunsFolder& folder,
                            const std::vector<RunTask>& tasks, const Atlas<Dim>& atlas,
                            const std::vector<std::string>& landmarks) {
  Reader<Dim> reader(cohort, stage, folder, atlas);
  for (std::size_t k = 0; k < tasks.size(); ++k) reader.add(k, tasks[k], landmarks[k]);
  return reader.take();
}

SHELLMATCH_2D_3D(read_stage);

}  // namespace shellmatch
