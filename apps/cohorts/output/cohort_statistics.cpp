#include "apps/cohorts/output/cohort_statistics.h"

#include "base/error.h"

#include <algorithm>
#include <map>

namespace shellmatch {

namespace {

// The two groups that are compared; empty where there are none.
std::vector<std::string> compared_groups(const Cohort& cohort, const std::vector<SubjectResult>& subjects,
                                         const std::vector<std::size_t>& rows, int dimension,
                                         std::vector<std::string>& notes) {
  std::map<std::string, int> sizes;
  for (const std::size_t k : rows) ++sizes[subjects[k].group];
  std::vector<std::string> groups = cohort.options.statistics.groups;
  if (groups.empty())
    for (const SubjectResult& subject : subjects)
      if (!subject.group.empty() && std::ranges::find(groups, subject.group) == groups.end())
        groups.push_back(subject.group);
  if (groups.size() < 2) return {};
  if (groups.size() > 2) {
    notes.push_back(fmt::format("{} groups are not compared; name two of them (statistics.groups)", groups.size()));
    return {};
  }
  for (const std::string& group : groups)
    if (sizes[group] < 2) {
      notes.push_back(fmt::format("groups are not compared: {} has {} subject{} in the statistics, and two are needed",
                                  group, sizes[group], sizes[group] == 1 ? "" : "s"));
      return {};
    }
  // Hotelling's T^2 takes that many (geometry/statistics/group_difference.h).
  if (const int n = sizes[groups[0]] + sizes[groups[1]]; n < dimension + 2) {
    notes.push_back(
        fmt::format("groups are not compared: both together have {} subjects in the statistics, and {} are needed", n,
                    dimension + 2));
    return {};
  }
  return groups;
}

// Modes, curves and everybody's scores.
template <int Dim>
void add_model(CohortResult<Dim>& result, const Eigen::VectorXd& weights, const StatisticsOptions& options,
               std::vector<std::string>& notes) {
  const auto n = static_cast<std::size_t>(result.aligned.n_sets()),
             most = static_cast<std::size_t>(options.model_subjects);
  const auto seed = static_cast<std::uint64_t>(options.seed);
  if (n <= most) {
    result.model = fit_shape_model(result.aligned, weights, options.modes);
    if (n >= 3) result.curves = model_curves(result.aligned, weights, options.samples, seed);
    return;
  }
  PointSets chosen{Dim, Eigen::MatrixXd(result.aligned.coordinates.rows(), static_cast<Eigen::Index>(most))};
  for (std::size_t k = 0; k < most; ++k)
    chosen.coordinates.col(static_cast<Eigen::Index>(k)) =
        result.aligned.coordinates.col(static_cast<Eigen::Index>(k * n / most));
  result.model = fit_shape_model(chosen, weights, options.modes);
  if (most >= 3) result.curves = model_curves(chosen, weights, options.samples, seed);
  result.model->scores = result.model->transform(result.aligned.coordinates);
  notes.push_back(
      fmt::format("modes and curves are those of {} of the {} subjects (statistics.model_subjects)", most, n));
}

}  // namespace

template <int Dim>
CohortResult<Dim> cohort_statistics(const Cohort& cohort, FinishedCohort<Dim> finished,
                                    std::vector<std::string>& notes) {
  const StatisticsOptions& options = cohort.options.statistics;
  const auto seed = static_cast<std::uint64_t>(options.seed);
  CohortResult<Dim> result;
  result.title = cohort.options.title;
  result.unit = finished.stage.unit;
  result.subjects = std::move(finished.stage.subjects);
  result.rows = std::move(finished.stage.rows);
  result.procrustes = options.procrustes;
  result.rounds = std::move(finished.rounds);
  const Eigen::Index n_coordinates = Dim * static_cast<Eigen::Index>(finished.atlas.shape.vertices.size());
  const Eigen::VectorXd weights = finished.atlas.weights.head(
      finished.atlas.weights.size() - static_cast<Eigen::Index>(finished.atlas.landmarks.size()));
  const Eigen::VectorXd start = finished.atlas.points.head(n_coordinates);
  result.atlas = std::move(finished.atlas.shape);
  result.surface = std::move(finished.atlas.surface);
  result.aligned.dimension = Dim;
  if (result.rows.empty()) {
    notes.push_back("no subject can be used for statistics (statistics.include)");
    return result;
  }
  PointSets points{Dim, finished.stage.points.coordinates.topRows(n_coordinates)};
  result.aligned = procrustes(std::move(points), weights, start, options.procrustes).sets;
  const std::size_t n = result.rows.size();
  if (n < 2) {
    notes.push_back("one subject has no modes");
    return result;
  }
  add_model(result, weights, options, notes);
  const std::vector<std::string> groups = compared_groups(cohort, result.subjects, result.rows, Dim, notes);
  if (groups.empty()) return result;
  result.group_a = groups[0];
  result.group_b = groups[1];
  PointSets compared{Dim, Eigen::MatrixXd(n_coordinates, static_cast<Eigen::Index>(n))};
  std::vector<char> is_b;
  for (std::size_t c = 0; c < n; ++c) {
    const std::string& group = result.subjects[result.rows[c]].group;
    if (group != groups[0] && group != groups[1]) continue;
    compared.coordinates.col(static_cast<Eigen::Index>(is_b.size())) =
        result.aligned.coordinates.col(static_cast<Eigen::Index>(c));
    is_b.push_back(group == groups[1] ? 1 : 0);
  }
  compared.coordinates.conservativeResize(Eigen::NoChange, static_cast<Eigen::Index>(is_b.size()));
  result.difference = group_difference(compared, weights, is_b, options.permutations, seed);
  return result;
}

SHELLMATCH_2D_3D(cohort_statistics);

}  // namespace shellmatch
