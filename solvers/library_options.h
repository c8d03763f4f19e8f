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

/// Options of ceres::GradientProblemSolver, under the library's names and with its defaults; all others are Ceres' own.
struct CeresOptions {
  CeresLineSearch line_search_type = CeresLineSearch::wolfe;
  CeresConjugateGradient nonlinear_conjugate_gradient_type = CeresConjugateGradient::fletcher_reeves;
  int max_lbfgs_rank = 20;
  double function_tolerance = 1e-6, gradient_tolerance = 1e-10, parameter_tolerance = 1e-8;
  bool common_stop_rules = true;
  int max_bfgs_size = 1000;
  static void describe(auto& self, auto& visit) {
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

}  // namespace shellmatch
