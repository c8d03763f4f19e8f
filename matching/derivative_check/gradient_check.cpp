#include "matching/derivative_check/gradient_check.h"

#include "base/error.h"
#include "matching/derivative_check/direction_check.h"
#include "matching/derivative_check/element_check.h"

#include <cmath>

namespace shellmatch {

namespace {

template <int Dim>
TermCheck check_term(const CheckContext<Dim>& context, const CheckedEnergy<Dim>& energy, const TermValues& weights,
                     std::string_view name, bool has_newton_model) {
  TermCheck check;
  check.name = name;
  if (!(weights.sum() > 0)) return check;  // the term is switched off
  AssembledTerm term{weights, 0, std::vector<double>(context.level.unknowns.size()), {}};
  TermValues values;
  if (!energy.evaluate(context.phi, weights, values, term.gradient, term.element_gradients))
    throw_input_error("the {} term cannot be evaluated at this deformation; is there a fold?", name);
  term.value = check.value = values.sum();
  double square = 0;
  for (const double g : term.gradient) square += g * g;
  check.gradient_norm = std::sqrt(square);

  check.state = TermCheck::State::passed;
  check_elements(context, term, check);
  if (check.n_elements == 0 && term.value == 0 && square == 0) {
    check.state = TermCheck::State::inactive;
    return check;
  }
  if (has_newton_model) check_hessian(context, term, check);
  check_directions(context, energy, term, check);
  if (!check.faults.empty()) check.state = TermCheck::State::failed;
  return check;
}

}  // namespace

template <int Dim>
GradientReport check_gradient(LevelEnergy<Dim>& level, const CheckedEnergy<Dim>& energy,
                              const std::vector<Vec<Dim>>& phi, const TermValues& weights,
                              const GradientCheckSettings& settings,
                              const std::function<void(const std::string&)>& next) {
  SHELLMATCH_CHECK(phi.size() == static_cast<std::size_t>(level.grid.n_nodes()), "phi has a position for each node");
  GradientReport report;
  report.dimension = Dim;
  report.level = level.grid.finest_level();
  report.n_nodes = level.grid.n_nodes();
  report.n_free_nodes = static_cast<Index>(level.grid.free_nodes().size());
  const CeresEvaluator<Dim> costs(level.energy);
  const CheckContext<Dim> context{level, costs, phi, settings};
  const std::vector<std::string> names = level.energy.term_names();
  for (std::size_t t = 0; t <= weights.size(); ++t) {
    const std::string name = t < weights.size() ? names[t] : "sum";
    if (next) next(name);
    TermValues some = weights;
    if (t < weights.size()) {
      some = TermValues(weights.size());
      some[t] = weights[t];
    }
    report.terms.push_back(check_term(context, energy, some, name, settings.newton_model));
  }
  return report;
}

#define SHELLMATCH_INSTANTIATE(Dim)                                                                  \
  template GradientReport check_gradient<Dim>(                                                       \
      LevelEnergy<Dim>&, const CheckedEnergy<Dim>&, const std::vector<Vec<Dim>>&, const TermValues&, \
      const GradientCheckSettings&, const std::function<void(const std::string&)>&);
SHELLMATCH_INSTANTIATE(2)
SHELLMATCH_INSTANTIATE(3)
#undef SHELLMATCH_INSTANTIATE

}  // namespace shellmatch
