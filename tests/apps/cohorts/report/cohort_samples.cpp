#include "tests/apps/cohorts/report/cohort_samples.h"

#include "base/decompositions.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace shellmatch::test {

namespace {

constexpr double pi = std::numbers::pi;

Surface<2> unit_shape(int n_points, std::integral_constant<int, 2>) {
  Surface<2> circle;
  for (int i = 0; i < n_points; ++i) {
    circle.vertices.emplace_back(std::cos(2 * pi * i / n_points), std::sin(2 * pi * i / n_points));
    circle.facets.push_back({i, (i + 1) % n_points});
  }
  return circle;
}

// Rings around the x axis between two poles.
Surface<3> unit_shape(int n_points, std::integral_constant<int, 3>) {
  const int n_rings = std::max(3, static_cast<int>(std::lround(std::sqrt(n_points / 2.0)))), n = 2 * n_rings;
  Surface<3> sphere;
  sphere.vertices.emplace_back(1, 0, 0);
  for (int r = 1; r <= n_rings; ++r)
    for (int i = 0; i < n; ++i) {
      const double polar = pi * r / (n_rings + 1), around = 2 * pi * i / n;
      sphere.vertices.emplace_back(std::cos(polar), std::sin(polar) * std::cos(around),
                                   std::sin(polar) * std::sin(around));
    }
  sphere.vertices.emplace_back(-1, 0, 0);
  const auto at = [&](int r, int i) { return r == 0 ? 0 : r > n_rings ? 1 + n_rings * n : 1 + (r - 1) * n + i % n; };
  for (int r = 0; r <= n_rings; ++r)
    for (int i = 0; i < n; ++i) {
      if (r > 0) sphere.facets.push_back({at(r, i), at(r + 1, i), at(r, i + 1)});
      if (r < n_rings) sphere.facets.push_back({at(r, i + 1), at(r + 1, i), at(r + 1, i + 1)});
    }
  return sphere;
}

// Subject i of n, in millimetres.
template <int Dim>
Eigen::VectorXd subject_shape(const Surface<Dim>& unit, int i, int n) {
  const double angle = 2 * pi * i / n;
  Eigen::VectorXd shape(Dim * static_cast<Eigen::Index>(unit.vertices.size()));
  Vec<Dim> axes = Vec<Dim>::Constant(20);
  axes[0] = 40;
  axes[1] = 26;
  for (std::size_t v = 0; v < unit.vertices.size(); ++v) {
    const Vec<Dim>& d = unit.vertices[v];
    Vec<Dim> x = axes.cwiseProduct(d);
    x[0] += 6 * std::cos(angle) * d[0];
    x[Dim - 1] += 8 * std::sin(angle) * (d[0] * d[0] - 1.0 / 3);
    for (int k = 2; k < 20; ++k) x += 2.5 / k / k * std::cos(1.7 * k * k * i + k) * std::cos(k * d[0] + 2 * d[1]) * d;
    shape.segment<Dim>(static_cast<Eigen::Index>(Dim * v)) = x;
  }
  return shape;
}

ShapeModel model_of(const PointSets& sets) {
  ShapeModel model;
  model.dimension = sets.dimension;
  const auto n_points = sets.n_points(), n = sets.n_sets();
  model.weights = Eigen::VectorXd::Constant(n_points, 1.0 / static_cast<double>(n_points));
  model.mean = sets.coordinates.rowwise().mean();
  // All points weigh the same: modes are the left singular vectors, of root mean square 1.
  const Eigen::MatrixXd centred = sets.coordinates.colwise() - model.mean;
  const Svd<Eigen::MatrixXd> of_sets = jacobi_svd(Eigen::MatrixXd(centred.transpose() * centred));
  const double root = std::sqrt(static_cast<double>(n_points));
  const Eigen::Index n_modes = (of_sets.values.array() > 1e-12 * of_sets.values[0]).count();
  const Eigen::VectorXd singular = of_sets.values.head(n_modes).cwiseSqrt();
  model.modes = root * centred * of_sets.v.leftCols(n_modes) * singular.cwiseInverse().asDiagonal();
  model.scores = of_sets.v.leftCols(n_modes) * singular.asDiagonal() / root;
  model.variances = model.scores.colwise().squaredNorm().transpose() / static_cast<double>(n - 1);
  model.total_variance = model.variances.sum();
  return model;
}

ModelCurves curves_of(const ShapeModel& model) {
  ModelCurves curves;
  double sum = 0;
  for (Eigen::Index m = 0; m < model.variances.size(); ++m) {
    curves.compactness.push_back((sum += model.variances[m]) / model.total_variance);
    const double rest = std::sqrt(std::max(model.total_variance - sum, 0.0)), kept = std::sqrt(sum);
    if (m + 1 < model.variances.size()) {
      curves.generalisation.push_back(0.3 + rest);
      curves.generalisation_error.push_back(0.1 + 0.1 * rest);
    }
    curves.specificity.push_back(0.4 * kept);
    curves.specificity_error.push_back(0.02 * kept);
  }
  return curves;
}

template <int Dim>
GroupDifference difference_of(const CohortResult<Dim>& result) {
  GroupDifference d;
  Eigen::VectorXd a = Eigen::VectorXd::Zero(result.aligned.coordinates.rows()), b = a;
  for (std::size_t c = 0; c < result.rows.size(); ++c) {
    const bool is_b = result.subjects[result.rows[c]].group == result.group_b;
    (is_b ? b : a) += result.aligned.coordinates.col(static_cast<Eigen::Index>(c));
    ++(is_b ? d.n_b : d.n_a);
  }
  d.n_permutations = 1000;
  d.all_permutations = true;
  d.difference = b / d.n_b - a / d.n_a;
  const Eigen::VectorXd lengths = d.difference.reshaped(Dim, d.difference.size() / Dim).colwise().norm();
  d.statistic = lengths.cwiseAbs2();
  d.p_corrected =
      (lengths.array() > lengths.maxCoeff() / 2).select(Eigen::ArrayXd::Constant(lengths.size(), 0.01), 0.6);
  d.p = d.q = d.p_corrected / 2;
  d.distance = std::sqrt(lengths.squaredNorm() / static_cast<double>(lengths.size()));
  d.global_p = 0.002;
  return d;
}

SubjectResult finished_subject(int i) {
  SubjectResult s;
  s.id = fmt::format("subject-{:02}", i + 1);
  s.status = "finished";
  s.outcome = "matched";
  const double worst = 0.004 + 0.0005 * ((7 * i) % 12);
  s.distance = TwoSidedDistance{{0.1 * worst, 0.5 * worst, worst}, {0.1 * worst, 0.4 * worst, 0.8 * worst}, 0.001};
  s.diagonal = 100 + i;
  s.seconds = 20 + i;
  s.folder = fmt::format("runs/{}/output", s.id);
  s.has_page = true;
  s.in_model = true;
  return s;
}

void spoil(std::vector<SubjectResult>& subjects) {
  SubjectResult &failed = subjects.at(2), &unusual = subjects.at(4), &wrong = subjects.at(6);
  const std::string group = failed.group;
  failed = unfinished_subject(failed.id, "timed_out", "stopped after 600 s, the limit of the cohort");
  failed.group = group;
  unusual.outcome = "look-here";
  unusual.bent = true;
  unusual.reasons = {{"1.4 % of the template is not reached",
                      "look whether it has parts that the reference lacks",
                      "template",
                      {1, 2, 3}}};
  wrong.outcome = "not-matched";
  wrong.in_model = false;
  wrong.distance = TwoSidedDistance{{0.02, 0.08, 0.21}, {0.03, 0.1, 0.26}, 0.31};
  wrong.reasons = {
      {"31 % of the template is not reached", "check that the shapes are of the same kind", "template", {1, 2, 3}},
      {"the map folds in 14 cells", "give landmarks", "deformed", {1, 2, 3}}};
}

}  // namespace

SubjectResult unfinished_subject(const std::string& id, const std::string& status, const std::string& message) {
  SubjectResult s;
  s.id = id;
  s.status = status;
  s.message = message;
  return s;
}

template <int Dim>
CohortResult<Dim> sample_cohort(const SampleOptions& options) {
  CohortResult<Dim> result;
  result.title = "Ellipsoids of two modes";
  result.unit = "mm";
  const Surface<Dim> unit = unit_shape(options.n_points, std::integral_constant<int, Dim>());
  result.surface.facets = unit.facets;
  for (const auto& d : unit.vertices) result.surface.vertices.push_back(20 * d);
  result.atlas.vertices = result.surface.vertices;
  for (int i = 0; i < options.n_subjects; ++i) {
    result.subjects.push_back(finished_subject(i));
    result.subjects.back().group = std::cos(2 * pi * i / options.n_subjects) > 0 ? "b" : "a";
  }
  if (options.has_failures) spoil(result.subjects);
  result.aligned.dimension = Dim;
  result.aligned.coordinates.resize(static_cast<Eigen::Index>(Dim * unit.vertices.size()), 0);
  for (std::size_t s = 0; s < result.subjects.size(); ++s) {
    if (!result.subjects[s].in_model) continue;
    result.rows.push_back(s);
    result.aligned.coordinates.conservativeResize(Eigen::NoChange, result.aligned.coordinates.cols() + 1);
    result.aligned.coordinates.rightCols(1) = subject_shape(unit, static_cast<int>(s), options.n_subjects);
  }
  if (result.rows.size() >= 2) result.model = model_of(result.aligned);
  if (result.rows.size() >= 3) result.curves = curves_of(*result.model);
  if (result.rows.size() >= 6) {
    result.group_a = "a";
    result.group_b = "b";
    result.difference = difference_of(result);
  }
  result.rounds = {{1, result.rows.size(), 0.031, 0.05},
                   {2, result.rows.size(), 0.004, 0.048},
                   {3, result.rows.size(), 0.0008, 0.048}};
  return result;
}

template CohortResult<2> sample_cohort<2>(const SampleOptions&);
template CohortResult<3> sample_cohort<3>(const SampleOptions&);

}  // namespace shellmatch::test
