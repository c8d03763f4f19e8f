#include "solvers/metric/metric.h"

#include "base/error.h"
#include "base/parallel.h"
#include "solvers/metric/cholmod_factor.h"

#include <cmath>

namespace shellmatch {

namespace {

void multiply(std::span<const double> a, std::span<const double> b, std::span<double> out) {
  parallel_for(
      a.size(), [&](std::size_t i) { out[i] = a[i] * b[i]; }, 8192);
}

}  // namespace

DiagonalFactor::DiagonalFactor(std::span<const double> diagonal)
    : root_(diagonal.size()), inverse_root_(diagonal.size()) {
  for (std::size_t i = 0; i < diagonal.size(); ++i) {
    if (!(diagonal[i] > 0 && std::isfinite(diagonal[i])))
      throw_input_error(
          "the lumped mass of unknown {} of {} is {:g}; the l2 metric needs positive numbers: leave "
          "out unknowns that no cell sees, or use metric euclidean",
          i, diagonal.size(), diagonal[i]);
    root_[i] = std::sqrt(diagonal[i]);
    inverse_root_[i] = 1 / root_[i];
  }
}

void DiagonalFactor::apply(std::span<const double> x, std::span<double> y) const { multiply(root_, x, y); }
void DiagonalFactor::solve(std::span<const double> y, std::span<double> x) const { multiply(inverse_root_, y, x); }
void DiagonalFactor::solve_transposed(std::span<const double> g, std::span<double> z) const {
  multiply(inverse_root_, g, z);
}

std::unique_ptr<MetricFactor> make_metric_factor(Metric metric, const Objective& objective) {
  if (metric == Metric::euclidean) return nullptr;
  if (metric != Metric::l2) {
    Eigen::SparseMatrix<double> matrix = objective.metric_matrix(metric);
    if (matrix.rows() == 0) return nullptr;
    const std::size_t rows = static_cast<std::size_t>(matrix.rows()), n = objective.size();
    SHELLMATCH_CHECK(n % rows == 0, "the metric's matrix must have one row for each node");
    return std::make_unique<SparseFactor>(std::move(matrix), static_cast<int>(n / rows));
  }
  const std::span<const double> mass = objective.lumped_mass();
  if (mass.empty()) return nullptr;
  if (mass.size() != objective.size())
    throw_input_error("the lumped mass has {} entries for {} unknowns; it must have one for each", mass.size(),
                      objective.size());
  return std::make_unique<DiagonalFactor>(mass);
}

MetricObjective::MetricObjective(Objective& objective, const MetricFactor& factor)
    : objective_(objective), factor_(factor), x_(objective.size()) {
  SHELLMATCH_CHECK(factor.size() == objective.size(), "metric and objective must have the same number of unknowns");
}

bool MetricObjective::evaluate(std::span<const double> y, double& value, std::span<double> gradient) {
  factor_.solve(y, x_);
  if (!objective_.evaluate(x_, value, gradient)) return false;
  if (!gradient.empty()) {
    l2_gradient_norm_ = objective_.l2_gradient_norm(gradient);
    factor_.solve_transposed(gradient, gradient);
  }
  return true;
}

std::string MetricObjective::what_is_not_finite(std::span<const double> y) {
  factor_.solve(y, x_);
  return objective_.what_is_not_finite(x_);
}

MinimizerSummary minimize_in_metric(const Minimizer& minimizer, const MetricFactor& factor, Objective& objective,
                                    std::vector<double>& x, const StopOptions& stop,
                                    const IterationCallback& callback) {
  SHELLMATCH_CHECK(x.size() == objective.size(), "the start must have as many entries as there are unknowns");
  MetricObjective in_metric(objective, factor);
  std::vector<double> y(x.size());
  factor.apply(x, y);
  const std::vector<double> start = y;
  MinimizerSummary summary = minimizer.minimize(in_metric, y, stop, callback);
  if (y != start) factor.solve(y, x);  // F^-1 F is not the identity in floating point
  return summary;
}

MinimizerSummary minimize_in_metric(const Minimizer& minimizer, Metric metric, Objective& objective,
                                    std::vector<double>& x, const StopOptions& stop,
                                    const IterationCallback& callback) {
  const std::unique_ptr<MetricFactor> factor = make_metric_factor(metric, objective);
  if (!factor) return minimizer.minimize(objective, x, stop, callback);
  return minimize_in_metric(minimizer, *factor, objective, x, stop, callback);
}

}  // namespace shellmatch
