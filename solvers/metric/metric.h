#pragma once
/// \file
/// The metric as a linear change of variables of the objective, so that every method can be used in every
/// metric.

#include "solvers/metric/metric_factor.h"
#include "solvers/minimizer.h"
#include "solvers/solver_options.h"

#include <memory>
#include <span>
#include <vector>

namespace shellmatch {

/// F = D^{1/2} for a diagonal matrix D such as the lumped mass matrix (metric l2).
class DiagonalFactor final : public MetricFactor {
 public:
  /// \throws InputError where an entry is not positive and finite; the message names it.
  explicit DiagonalFactor(std::span<const double> diagonal);
  std::size_t size() const override { return root_.size(); }
  void apply(std::span<const double> x, std::span<double> y) const override;
  void solve(std::span<const double> y, std::span<double> x) const override;
  void solve_transposed(std::span<const double> g, std::span<double> z) const override;

 private:
  std::vector<double> root_, inverse_root_;
};

/// The factor of a metric for an objective; null where the change of variables is the identity: for metric
/// euclidean and for objectives without mass or matrix. \throws InputError where the mass is not one positive
/// number for each unknown, or the matrix is not positive definite.
std::unique_ptr<MetricFactor> make_metric_factor(Metric metric, const Objective& objective);

/// The objective as a function of y = F x. Its lumped mass is empty, so its metric is Euclidean.
/// l2_gradient_norm() is that of the original objective.
class MetricObjective final : public Objective {
 public:
  /// Keeps references to both.
  MetricObjective(Objective& objective, const MetricFactor& factor);
  std::size_t size() const override { return objective_.size(); }
  bool evaluate(std::span<const double> y, double& value, std::span<double> gradient) override;
  std::vector<std::string> term_names() const override { return objective_.term_names(); }
  std::vector<double> term_values() const override { return objective_.term_values(); }
  double l2_gradient_norm(std::span<const double>) const override { return l2_gradient_norm_; }
  std::string what_is_not_finite(std::span<const double> y) override;

 private:
  Objective& objective_;
  const MetricFactor& factor_;
  std::vector<double> x_;
  double l2_gradient_norm_ = 0;
};

/// Minimises in the metric: transforms x to y, minimises over y, and transforms the result back. Gradient
/// norms and steps in the records are those of the metric. If the initial point is the best one, x is
/// returned unchanged.
MinimizerSummary minimize_in_metric(const Minimizer& minimizer, const MetricFactor& factor, Objective& objective,
                                    std::vector<double>& x, const StopOptions& stop,
                                    const IterationCallback& callback = {});
MinimizerSummary minimize_in_metric(const Minimizer& minimizer, Metric metric, Objective& objective,
                                    std::vector<double>& x, const StopOptions& stop,
                                    const IterationCallback& callback = {});

}  // namespace shellmatch
