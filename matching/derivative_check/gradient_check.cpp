#include "matching/derivative_check/gradient_check.h"

#include "base/error.h"
#include "base/taylor.h"
#include "matching/derivative_check/checked_energy.h"
#include "matching/derivative_check/element_check.h"
#include "matching/derivative_check/gradient_report.h"
#include "matching/derivative_check/kink_free.h"
#include "matching/derivative_check/random_field.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace shellmatch {

namespace {

constexpr int n_decades = 3;

double dot(const std::vector<double>& a, const std::vector<double>& b) {
  return std::inner_product(a.begin(), a.end(), b.begin(), 0.0);
}

/// A random direction that moves every node by about the side of the smallest cell around it: half of it a smooth
/// field, half independent at each node.
template <int Dim>
std::vector<double> random_direction(const LevelEnergy<Dim>& level, unsigned seed) {
  const auto nodes = level.unknowns.nodes();
  std::vector<double> side(static_cast<std::size_t>(level.grid.n_nodes()), 1.0);
  for (const Element<Dim>& e : level.unknowns.elements())
    for (const Index node : e.nodes) side[node] = std::min(side[node], e.side);
  std::mt19937 random(seed);
  const SmoothRandomField<Dim> field(random);
  std::vector<double> v(level.unknowns.size());
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    const Vec<Dim> together = field(level.grid.node_position(nodes[i]));
    for (int k = 0; k < Dim; ++k) v[Dim * i + k] = 0.5 * side[nodes[i]] * (together[k] + random_unit(random));
  }
  return v;
}

/// The energy as a function of t along phi + t v.
template <int Dim>
class Along {
 public:
  Along(const CheckContext<Dim>& context, const CheckedEnergy<Dim>& energy, const TermValues& weights,
        const std::vector<double>& direction)
      : context_(context),
        energy_(energy),
        weights_(weights),
        direction_(direction),
        x_(direction.size()),
        y_(direction.size()),
        phi_(context.phi) {
    context.level.unknowns.restrict_to(context.phi, x_);
  }
  double operator()(double t) {
    for (std::size_t i = 0; i < x_.size(); ++i) y_[i] = x_[i] + t * direction_[i];
    context_.level.unknowns.expand(y_, phi_);
    TermValues values;
    if (!energy_.evaluate(phi_, weights_, values, {}, unused_)) return std::numeric_limits<double>::quiet_NaN();
    return values.sum();
  }

 private:
  const CheckContext<Dim>& context_;
  const CheckedEnergy<Dim>& energy_;
  TermValues weights_;
  const std::vector<double>& direction_;
  std::vector<double> x_, y_, unused_;
  std::vector<Vec<Dim>> phi_;
};

/// Where the second derivative nearly cancels, as it may under a robust loss, the third shows at the longest steps and
/// only there; a wrong slope shows at the shortest.
bool is_second_order(const DirectionCheck& d) {
  if (TaylorRemainder{d.steps, d.remainders, d.orders}.is_second_order()) return true;
  const std::vector<double> shorter(d.orders.begin() + 1, d.orders.end());
  return d.orders.front() > 2 && TaylorRemainder{{}, {}, shorter}.is_second_order();
}

/// Checks along one direction and returns the direction used in `v`. A shorter reach means that fewer nodes have to be
/// fixed because of kinks; rounding errors bound it from below, so longer ones are tried in turn.
template <int Dim>
DirectionCheck check_direction(const CheckContext<Dim>& context, const CheckedEnergy<Dim>& energy,
                               const AssembledTerm& term, unsigned seed, std::vector<double>& v) {
  DirectionCheck result;
  for (const double reach : {0.003, 0.02, 0.1}) {
    v = random_direction(context.level, seed);
    result = {};
    if (context.level.energy.terms().read_target(term.weights)) {
      const HeldPoints held = hold_at_kinks<Dim>(context.level.unknowns, context.costs, context.level.geometry.target,
                                                 context.level.grid, context.phi, reach, v);
      result.n_points_near_faces = held.n_points;
      result.held_share =
          static_cast<double>(held.n_nodes) / static_cast<double>(context.level.unknowns.nodes().size());
    }
    result.slope = dot(term.gradient, v);
    Along<Dim> line(context, energy, term.weights, v);
    const TaylorScale scale = taylor_scale(std::ref(line), reach, n_decades);
    result.curvature = scale.curvature;
    if (!scale.fits(reach, n_decades)) continue;
    result.resolved = true;
    TaylorRemainder remainder = taylor_remainder(std::ref(line), result.slope, scale.steps(n_decades));
    result.steps = std::move(remainder.steps);
    result.remainders = std::move(remainder.remainders);
    result.orders = std::move(remainder.orders);
    break;
  }
  return result;
}

// Checks random directions and adds the results to `check`.
template <int Dim>
void check_directions(const CheckContext<Dim>& context, const CheckedEnergy<Dim>& energy, const AssembledTerm& term,
                      TermCheck& check) {
  int n_resolved = 0;
  for (int d = 0; d < context.settings.n_directions; ++d) {
    std::vector<double> v;
    DirectionCheck direction =
        check_direction(context, energy, term, context.settings.seed + static_cast<unsigned>(d), v);
    n_resolved += direction.resolved;
    if (direction.resolved && !is_second_order(direction))
      check.faults.push_back(fmt::format("the Taylor remainder along direction {} is of order {:.2f}, not 2", d + 1,
                                         fmt::join(direction.orders, ", ")));
    if (check.hessian) {
      std::vector<double> hv(v.size());
      context.level.hessian.apply(v, hv);
      direction.model_curvature = dot(v, hv);
    }
    check.directions.push_back(std::move(direction));
  }
  if (n_resolved == 0 && !check.directions.empty())
    check.notes.push_back("no direction has three decades of steps between rounding and the next order");
}

// Checks symmetry and definiteness of the Newton model, and adds the result to `check`.
template <int Dim>
void check_hessian(const CheckContext<Dim>& context, const AssembledTerm& term, TermCheck& check) {
  context.level.hessian.assemble(context.phi, term.weights);
  HessianCheck result;
  result.least_quotient = std::numeric_limits<double>::infinity();
  const std::size_t n = context.level.unknowns.size();
  std::vector<double> hx(n), hy(n);
  for (unsigned trial = 0; trial < 3; ++trial) {
    const auto x = random_direction(context.level, context.settings.seed + 100 + trial);
    const auto y = random_direction(context.level, context.settings.seed + 200 + trial);
    context.level.hessian.apply(x, hx);
    context.level.hessian.apply(y, hy);
    const double xhx = dot(x, hx), yhy = dot(y, hy), size = std::sqrt(std::abs(xhx * yhy));
    if (!std::isfinite(dot(hx, hx)) || !std::isfinite(dot(hy, hy))) {
      check.faults.push_back("the Newton model is not finite");
      return;
    }
    if (dot(hx, hx) == 0) continue;
    result.asymmetry = std::max(result.asymmetry, std::abs(dot(x, hy) - dot(y, hx)) / size);
    result.least_quotient = std::min(result.least_quotient, xhx / std::sqrt(dot(x, x) * dot(hx, hx)));
  }
  if (!std::isfinite(result.least_quotient)) return;  // the model is 0
  check.hessian = result;
  // The model is stored in single precision.
  if (!(result.asymmetry <= 1e-5)) check.faults.push_back("the Newton model is not symmetric");
  if (!(result.least_quotient >= -1e-5))
    check.faults.push_back("the Newton model has a direction of negative curvature");
}

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

SHELLMATCH_2D_3D(check_gradient);

}  // namespace shellmatch
