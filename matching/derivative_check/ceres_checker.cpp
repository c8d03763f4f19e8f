// Ceres' GradientChecker exchanges Eigen matrices with its caller. Debian's Ceres is compiled without AVX and allocates
// them by plain malloc, whereas Eigen under -march=native allocates aligned memory in its own way: memory allocated by
// one side cannot be freed by the other. This file therefore configures Eigen as Ceres' build did. Its Eigen types
// differ from those of the other files; the renamed namespace keeps the linker from mixing both sets of functions.
#define EIGEN_DONT_VECTORIZE
#define EIGEN_MAX_ALIGN_BYTES 16
#define EIGEN_MALLOC_ALREADY_ALIGNED 1
#define Eigen EigenAsInCeres

#include "matching/derivative_check/ceres_checker.h"

#include <ceres/gradient_checker.h>

#include <algorithm>
#include <cmath>
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

}  // namespace

CeresVerdict check_with_ceres(const SmallFunction& function, std::span<const double> dofs, double first_step,
                              double relative_precision) {
  ceres::NumericDiffOptions steps;
  const Cost cost(function, dofs, first_step / steps.ridders_relative_initial_step_size);
  const std::vector<const ceres::Manifold*> none{nullptr};
  const ceres::GradientChecker checker(&cost, &none, steps);
  ceres::GradientChecker::ProbeResults results;
  const std::vector<double> origin(dofs.size(), 0.0);
  const double* block = origin.data();
  CeresVerdict verdict;
  verdict.passed = checker.Probe(&block, relative_precision, &results);
  verdict.worst_relative_error = results.maximum_relative_error;
  verdict.log = results.error_log;
  return verdict;
}

}  // namespace shellmatch
