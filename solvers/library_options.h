#pragma once
/// \file
/// Options of the minimisers of external libraries.

#include "base/options.h"

#include <string_view>
#include <utility>

namespace shellmatch {

enum class CeresLineSearch { armijo, wolfe };
template <>
struct EnumNames<CeresLineSearch> {
  static constexpr std::pair<CeresLineSearch, std::string_view> names[] = {{CeresLineSearch::armijo, "armijo"},
                                                                           {CeresLineSearch::wolfe, "wolfe"}};
};

enum class CeresConjugateGradient { fletcher_reeves, polak_ribiere, hestenes_stiefel };
template <>
struct EnumNames<CeresConjugateGradient> {
  static constexpr std::pair<CeresConjugateGradient, std::string_view> names[] = {
      {CeresConjugateGradient::fletcher_reeves, "fletcher_reeves"},
      {CeresConjugateGradient::polak_ribiere, "polak_ribiere"},
      {CeresConjugateGradient::hestenes_stiefel, "hestenes_stiefel"}};
};

enum class CeresInterpolation { bisection, quadratic, cubic };
template <>
struct EnumNames<CeresInterpolation> {
  static constexpr std::pair<CeresInterpolation, std::string_view> names[] = {
      {CeresInterpolation::bisection, "bisection"},
      {CeresInterpolation::quadratic, "quadratic"},
      {CeresInterpolation::cubic, "cubic"}};
};

/// Options of ceres::GradientProblemSolver, under the library's names and with its defaults.
struct CeresOptions {
  CeresLineSearch line_search_type = CeresLineSearch::wolfe;
  CeresConjugateGradient nonlinear_conjugate_gradient_type = CeresConjugateGradient::fletcher_reeves;
  int max_lbfgs_rank = 20;
  bool use_approximate_eigenvalue_bfgs_scaling = false;
  CeresInterpolation line_search_interpolation_type = CeresInterpolation::cubic;
  double min_line_search_step_size = 1e-9;
  double line_search_sufficient_function_decrease = 1e-4;
  double max_line_search_step_contraction = 1e-3;
  double min_line_search_step_contraction = 0.6;
  int max_num_line_search_step_size_iterations = 20;
  int max_num_line_search_direction_restarts = 5;
  double line_search_sufficient_curvature_decrease = 0.9;
  double max_line_search_step_expansion = 10;
  double function_tolerance = 1e-6, gradient_tolerance = 1e-10, parameter_tolerance = 1e-8;
  bool common_stop_rules = true;
  int max_bfgs_size = 1000;
  template <class Self, class Visitor>
  static void describe(Self& self, Visitor& visit) {
    visit("line_search_type", self.line_search_type,
          {.meaning = "conditions on a step: armijo or (strong) wolfe; ceres_bfgs and ceres_lbfgs need wolfe"});
    visit("nonlinear_conjugate_gradient_type", self.nonlinear_conjugate_gradient_type,
          {.meaning = "beta of ceres_ncg"});
    visit("max_lbfgs_rank", self.max_lbfgs_rank,
          {.unit = "pairs of vectors", .min = 1, .max = 1000, .meaning = "memory of ceres_lbfgs"});
    visit("function_tolerance", self.function_tolerance,
          {.min = 0,
           .meaning = "a method ends where a step changes the value by at most this share of it; 0 in a study that "
                      "compares methods"});
    visit("gradient_tolerance", self.gradient_tolerance,
          {.min = 0, .meaning = "a method ends where no entry of the gradient is larger; 0 in such a study"});
    visit("parameter_tolerance", self.parameter_tolerance,
          {.min = 0,
           .meaning = "a method ends where a step is at most this share of the unknowns' norm; 0 in such a study"});
    visit("common_stop_rules", self.common_stop_rules,
          {.meaning = "the rules of solver.stop end a method, too, as a ceres::IterationCallback; false: only its "
                      "limits stop.max_iterations and stop.max_seconds, as Ceres' own"});
    visit("max_bfgs_size", self.max_bfgs_size,
          {.unit = "unknowns",
           .min = 1,
           .max = 20000,
           .meaning = "most unknowns for ceres_bfgs, whose dense matrix grows with their square"});
  }
};

/// Options of the NLopt methods.
struct NloptOptions {
  int vector_storage = 0;
  int max_slsqp_size = 500;
  int max_stalled_evaluations = 200;
  int max_restarts = 20;
  template <class Self, class Visitor>
  static void describe(Self& self, Visitor& visit) {
    visit("max_slsqp_size", self.max_slsqp_size,
          {.unit = "unknowns",
           .min = 1,
           .max = 5000,
           .meaning = "most unknowns for nlopt_slsqp, whose memory grows with their square and time with their cube"});
  }
};

}  // namespace shellmatch
