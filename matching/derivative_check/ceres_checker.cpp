#include "matching/derivative_check/ceres_checker.h"

#include <ceres/dynamic_numeric_diff_cost_function.h>
#include <ceres/gradient_checker.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <vector>

namespace shellmatch {

namespace {

/// The function of z with degrees of freedom start + scale R z, where R is the reflection at a plane oblique to all
/// axes.
class Cost final : public ceres::CostFunction {
 public:
  Cost(const SmallFunction& function, std::span<const double> start, double scale)
      : function_(function), start_(start), scale_(scale), normal_(start.size()) {
    set_num_residuals(1);
    mutable_parameter_block_sizes()->push_back(static_cast<int>(start.size()));
    double square = 0;
    for (std::size_t i = 0; i < normal_.size(); ++i) {
      normal_[i] = 1 + 0.5 * std::sin(1 + 2.4 * static_cast<double>(i));
      square += normal_[i] * normal_[i];
    }
    for (double& component : normal_) component /= std::sqrt(square);
  }

  bool Evaluate(double const* const* z, double* value, double** jacobians) const override {
    std::vector<double> dofs = reflected({z[0], start_.size()});
    for (std::size_t i = 0; i < dofs.size(); ++i) dofs[i] += start_[i];
    if (jacobians == nullptr || jacobians[0] == nullptr) return function_(dofs, *value, {});
    std::vector<double> gradient(dofs.size());
    if (!function_(dofs, *value, gradient)) return false;
    std::ranges::copy(reflected(gradient), jacobians[0]);
    return true;
  }

 private:
  // scale R z. R is symmetric, so that the same map transforms gradients.
  std::vector<double> reflected(std::span<const double> z) const {
    const double along = 2 * std::inner_product(z.begin(), z.end(), normal_.begin(), 0.0);
    std::vector<double> image(z.size());
    for (std::size_t i = 0; i < z.size(); ++i) image[i] = scale_ * (z[i] - along * normal_[i]);
    return image;
  }

  const SmallFunction& function_;
  std::span<const double> start_;
  double scale_;
  std::vector<double> normal_;
};

/// Ceres' numeric differentiation, as its checker uses it: the largest relative error of the cost's derivative at z.
double worst_relative_error(const Cost& cost, const double* z, int n, const ceres::NumericDiffOptions& steps) {
  const auto value_of = [&cost](double const* const* at, double* value) { return cost.Evaluate(at, value, nullptr); };
  using Value = decltype(value_of);
  ceres::DynamicNumericDiffCostFunction<Value, ceres::RIDDERS> numeric(&value_of, ceres::DO_NOT_TAKE_OWNERSHIP, steps);
  numeric.AddParameterBlock(n);
  numeric.SetNumResiduals(1);
  double value;
  std::vector<double> given(static_cast<std::size_t>(n)), found(given);
  double *of_given = given.data(), *of_found = found.data();
  if (!cost.Evaluate(&z, &value, &of_given) || !numeric.Evaluate(&z, &value, &of_found))
    return std::numeric_limits<double>::infinity();
  double worst = 0;
  for (std::size_t i = 0; i < given.size(); ++i)
    if (const double size = std::max(std::abs(given[i]), std::abs(found[i])); size > 0)
      worst = std::max(worst, std::abs(given[i] - found[i]) / size);
  return worst;
}

}  // namespace

CeresVerdict check_with_ceres(const SmallFunction& function, std::span<const double> dofs, double first_step,
                              double relative_precision) {
  ceres::NumericDiffOptions steps;
  const Cost cost(function, dofs, first_step / steps.ridders_relative_initial_step_size);
  const std::vector<const ceres::Manifold*> none{nullptr};
  const ceres::GradientChecker checker(&cost, &none, steps);
  const std::vector<double> origin(dofs.size(), 0.0);
  const double* block = origin.data();
  // Without its results, which are Eigen matrices: Debian's Ceres, built without AVX, and this file allocate them in
  // different ways.
  return {.passed = checker.Probe(&block, relative_precision, nullptr),
          .worst_relative_error = worst_relative_error(cost, block, static_cast<int>(dofs.size()), steps)};
}

}  // namespace shellmatch
