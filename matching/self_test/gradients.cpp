#include "matching/experiment/yaml_options.h"
#include "matching/run_gradient_check.h"
#include "matching/self_test/known_cases.h"

#include <algorithm>
#include <cmath>

namespace shellmatch {

std::vector<SelfCheck> checks_of(const GradientReport& report) {
  double order_error = 0, functor_error = 0, n_failed = 0;
  for (const TermCheck& term : report.terms) {
    n_failed += term.state == TermCheck::State::failed;
    functor_error = std::max(functor_error, term.gradient_error);
    for (const DirectionCheck& direction : term.directions)
      for (const double order : direction.orders) order_error = std::max(order_error, std::abs(order - 2));
  }
  return {{"", "terms whose derivatives are wrong", n_failed, 0},
          {"", "Taylor remainders: largest deviation from order 2", order_error, 0.05},
          {"", "gradients against dual numbers", functor_error, 1e-11}};
}

template <int Dim>
std::vector<SelfCheck> check_gradients() {
  const bool plane = Dim == 2;
  const ExperimentOptions options =
      make_experiment({{"input.reference", plane ? "generate:circle" : "generate:sphere", "self-test"},
                       {"input.template", plane ? "generate:ellipse" : "generate:ellipsoid", "self-test"},
                       {"cascade.min_level", "3", "self-test"},
                       {"cascade.max_level", plane ? "5" : "3", "self-test"}});
  Observer nobody;
  GradientCheckRequest request;
  request.settings.n_directions = 1;
  request.settings.most_differenced = 100;
  return checks_of(run_gradient_check(options, request, nobody));
}

template std::vector<SelfCheck> check_gradients<2>();
template std::vector<SelfCheck> check_gradients<3>();

}  // namespace shellmatch
