#include "apps/cohorts/output/write_cohort.h"

#include "base/replace_file.h"
#include "apps/cohorts/execution/kept_results.h"
#include "apps/cohorts/output/cohort_statistics.h"
#include "apps/cohorts/output/cohort_summary.h"
#include "apps/cohorts/output/cohort_tables.h"
#include "apps/cohorts/output/model_files.h"
#include "apps/cohorts/output/own_files.h"
#include "apps/cohorts/report/cohort_report.h"
#include "apps/cohorts/subjects/point_file.h"

#include <tuple>

namespace shellmatch {

namespace {

template <int Dim>
WrittenCohort write_files(const Cohort& cohort, FinishedCohort<Dim> finished, const std::string& folder,
                          std::vector<std::string>& notes) {
  const Eigen::MatrixXd points =
      finished.stage.points.coordinates.topRows(Dim * static_cast<Eigen::Index>(finished.atlas.shape.vertices.size()));
  const std::vector<NamedPoint<Dim>> landmarks = finished.atlas.landmarks;
  const Space space = finished.stage.space;
  const std::vector<CarriedLandmark<Dim>> carried = std::move(finished.stage.carried);
  const std::vector<ReturnedLandmark<Dim>> returned = std::move(finished.stage.returned);
  const CohortResult<Dim> result = cohort_statistics(cohort, std::move(finished), notes);

  replace_file(folder + "/subjects.csv", subjects_csv(cohort, result.subjects, result.rows));
  replace_file(folder + "/times.csv", times_csv(result.subjects));
  const auto write_or_remove = [&](const std::string& name, const std::string& text, bool is_there,
                                   const std::vector<std::string>& empty_tables) {
    if (is_there) replace_file(folder + "/" + name, text);
    else
      for (const std::string& empty : empty_tables)
        remove_own_table(folder + "/" + name,
                         empty.substr(0, empty.find('\n')));  // of an earlier run, in which there were some
  };
  write_or_remove("landmarks.csv", landmarks_csv<Dim>(result.subjects, landmarks, carried), !carried.empty(),
                  {landmarks_csv<2>({}, {}, {}), landmarks_csv<3>({}, {}, {})});
  for (const auto& [name, format, beginnings] :
       {std::tuple{"landmarks.tps", PointFormat::tps, std::vector{"LM=", "LM3="}},
        {"landmarks.txt", PointFormat::morphologika, {"[individuals]"}}}) {
    const std::string path = folder + "/" + name;
    if (!carried.empty())
      replace_file(path, point_sets_text<Dim>(format, landmark_sets<Dim>(result.subjects, landmarks, carried), space));
    else
      for (const char* beginning : beginnings) remove_own_landmarks(path, beginning);
  }
  write_or_remove("landmarks_on_atlas.csv", returned_landmarks_csv<Dim>(result.subjects, returned), !returned.empty(),
                  {returned_landmarks_csv<2>({}, {}), returned_landmarks_csv<3>({}, {})});
  if (landmarks.empty())
    for (const char* header : {named_points_header<2>, named_points_header<3>})
      remove_own_table(folder + "/atlas_landmarks.csv", header);
  if (result.rows.empty()) {
    remove_model_files(folder + "/model", StaleFiles::all, Dim);
  } else {
    remove_model_files(folder + "/model", result.model ? StaleFiles::mode_shapes : StaleFiles::statistics, Dim);
    write_model(result, points, cohort.options.statistics.mode_meshes, folder + "/model");
    if (result.model) {
      replace_file(folder + "/model/scores.csv", scores_csv(*result.model, result.subjects, result.rows));
      replace_file(folder + "/model/modes.csv", modes_csv(*result.model, result.curves));
      write_mode_animations(result, cohort.options.statistics.mode_meshes, folder + "/model");
    }
  }
  const CohortSummary summary = cohort_summary(result, carried);
  replace_file(folder + "/summary.json", cohort_summary_json(summary));
  replace_file(folder + "/report.html", cohort_report_html(result));
  return {cohort_summary_lines(summary), without_result(summary, result.subjects)};
}

}  // namespace

template <int Dim>
WrittenCohort write_cohort(const Cohort& cohort, FinishedCohort<Dim> finished, const std::string& folder,
                           std::vector<std::string>& notes) {
  return saying_what_is_kept(folder, [&] { return write_files<Dim>(cohort, std::move(finished), folder, notes); });
}

SHELLMATCH_2D_3D(write_cohort);

}  // namespace shellmatch
