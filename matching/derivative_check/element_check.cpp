#include "matching/derivative_check/element_check.h"

#include "base/parallel.h"
#include "grid/octree/constraints.h"
#include "matching/derivative_check/ceres_checker.h"
#include "matching/derivative_check/element_differences.h"
#include "matching/derivative_check/kink_free.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace shellmatch {

namespace {

/// The magnitude, infinite for NaN, which comparisons do not see.
double magnitude(double x) { return std::isnan(x) ? std::numeric_limits<double>::infinity() : std::abs(x); }

double largest(std::span<const double> v) {
  double m = 0;
  for (const double x : v) m = std::max(m, magnitude(x));
  return m;
}

/// Checks one term on all elements: the assembly's gradients against those of the functors.
template <int Dim>
class ElementComparison {
 public:
  using Costs = CeresEvaluator<Dim>;
  using Dofs = typename Costs::Dofs;
  static constexpr int n = Costs::n_dofs;

  ElementComparison(const CheckContext<Dim>& context, const AssembledTerm& term, TermCheck& check)
      : context_(context),
        costs_(context.costs),
        elements_(context.level.unknowns.elements()),
        differences_(context, term.weights),
        term_(term),
        check_(check) {}

  void run() {
    differentiate();
    compare_sums();
    if (acting_.empty()) return;
    compare_with_differences();
    find_worst();
    probe_with_ceres();
  }

 private:
  std::span<const double> assembled(std::size_t e) const {
    return std::span(term_.element_gradients).subspan(e * n, n);
  }

  void differentiate() {
    by_jets_.resize(elements_.size());
    values_.resize(elements_.size());
    natural_.resize(elements_.size());
    error_.resize(elements_.size());
    parallel_for(
        elements_.size(),
        [&](std::size_t e) {
          values_[e] = costs_.gradient(term_.weights, e, costs_.dofs_of(e, context_.phi), by_jets_[e]);
          natural_[e] = costs_.natural_size(term_.weights, e);
          // Where the entries are the result of a cancellation, they agree up to rounding errors of the natural size
          // only.
          const double tolerance = 1e-9 * largest(by_jets_[e]) + 1e-12 * natural_[e];
          double difference = 0;
          for (int i = 0; i < n; ++i) difference = std::max(difference, magnitude(by_jets_[e][i] - assembled(e)[i]));
          error_[e] = difference == 0 ? 0 : magnitude(difference / tolerance);
        },
        16);
    for (std::size_t e = 0; e < elements_.size(); ++e) {
      if (largest(by_jets_[e]) > 0 || largest(assembled(e)) > 0) acting_.push_back(e);
      check_.element_error = std::max(check_.element_error, error_[e]);
    }
    check_.n_elements = acting_.size();
    if (!(check_.element_error <= 1))
      check_.faults.push_back("element gradients differ from the functor's by dual numbers");
  }

  // Compares value and gradient with the sums over the element functors, whose hanging nodes are eliminated by
  // grid/octree/constraints.h and not by the assembly.
  void compare_sums() {
    const Octree<Dim>& grid = context_.level.grid;
    double value = 0, size = 0;
    std::vector<Vec<Dim>> nodal(context_.phi.size(), Vec<Dim>::Zero());
    for (std::size_t e = 0; e < elements_.size(); ++e) {
      value += values_[e];
      size += natural_[e] * elements_[e].side;
      for (int i = 0; i < n; ++i) nodal[elements_[e].nodes[i / Dim]][i % Dim] += by_jets_[e][i];
    }
    std::vector<double> free(grid.free_nodes().size() * Dim);
    Constraints<Dim>(grid).condense(components_of(nodal), free, Dim);
    const auto nodes = context_.level.unknowns.nodes();
    double difference = 0;
    for (std::size_t i = 0; i < term_.gradient.size(); ++i) {
      const std::size_t at = static_cast<std::size_t>(grid.free_index(nodes[i / Dim])) * Dim + i % Dim;
      difference = std::max(difference, magnitude(free[at] - term_.gradient[i]));
    }
    const double natural = *std::max_element(natural_.begin(), natural_.end());
    check_.value_error = std::abs(value - term_.value) / std::max(std::abs(value), 1e-6 * size);
    check_.gradient_error = difference / std::max(largest(free), 1e-3 * natural);
    if (difference == 0) check_.gradient_error = 0;
    if (value == term_.value) check_.value_error = 0;
    if (!(check_.value_error <= 1e-9))
      check_.faults.push_back("the value differs from the sum of the element functors");
    if (!(check_.gradient_error <= 1e-9))
      check_.faults.push_back("the gradient differs from the sum of the element functors'");
    if (largest(term_.gradient) < 1e-10 * natural && !acting_.empty()) check_.state = TermCheck::State::vanishing;
  }

  ElementGradient gradient_of(std::size_t e) const {
    return {assembled(e), largest(by_jets_[e]), values_[e], natural_[e]};
  }

  // A sample of the elements, spread over the grid, together with those of largest error so far.
  std::vector<std::size_t> sample(std::size_t most) const {
    if (acting_.size() <= most) return acting_;
    std::vector<std::size_t> chosen;
    for (std::size_t k = 0; k < most; ++k) chosen.push_back(acting_[k * acting_.size() / most]);
    std::vector<std::size_t> worst = acting_;
    const auto middle = worst.begin() + static_cast<std::ptrdiff_t>(std::min<std::size_t>(32, most));
    std::partial_sort(worst.begin(), middle, worst.end(),
                      [&](std::size_t a, std::size_t b) { return error_[a] > error_[b]; });
    chosen.insert(chosen.end(), worst.begin(), middle);
    std::sort(chosen.begin(), chosen.end());
    chosen.erase(std::unique(chosen.begin(), chosen.end()), chosen.end());
    return chosen;
  }

  void compare_with_differences() {
    const std::vector<std::size_t> chosen = sample(context_.settings.most_differenced);
    std::vector<DifferenceError> found(chosen.size());
    parallel_for(
        chosen.size(), [&](std::size_t k) { found[k] = differences_.compare(chosen[k], gradient_of(chosen[k])); }, 4);
    for (std::size_t k = 0; k < chosen.size(); ++k) {
      check_.n_elements_near_faces += found[k].near_face;
      check_.n_elements_with_kinks += found[k].kink;
      check_.n_differenced += !found[k].near_face;
      if (const double error = magnitude(found[k].error); error > check_.difference_error) {
        check_.difference_error = error;
        worst_by_differences_ = chosen[k];
      }
    }
    if (!(check_.difference_error <= 1))
      check_.faults.push_back("element gradients differ from differences of the functor");
  }

  void find_worst() {
    std::size_t e = worst_by_differences_;
    if (!(check_.element_error <= 1))
      e = static_cast<std::size_t>(std::max_element(error_.begin(), error_.end()) - error_.begin());
    const Dofs dofs = costs_.dofs_of(e, context_.phi);
    const double side = elements_[e].side,
                 distance = least_distance_to_kinks(costs_, context_.level.geometry.target, e, dofs);
    const double step = distance > 1.1e-4 * side ? 1e-4 * side : 1e-6 * side;
    WorstElement worst;
    worst.element = static_cast<Index>(e);
    const Index leaf = context_.level.grid.leaves()[e];
    worst.level = context_.level.grid.cell(leaf).level;
    const Vec<Dim> centre = context_.level.grid.cell_centre(leaf);
    worst.centre.assign(centre.begin(), centre.end());
    double greatest = -1;
    for (int i = 0; i < n; ++i) {
      const double numeric = differences_.central(e, dofs, i, step);
      const double difference =
          check_.element_error <= 1 ? std::abs(assembled(e)[i] - numeric) : std::abs(assembled(e)[i] - by_jets_[e][i]);
      if (!(difference > greatest)) continue;
      greatest = difference;
      worst.corner = i / Dim;
      worst.axis = i % Dim;
      worst.analytic = assembled(e)[i];
      worst.by_jets = by_jets_[e][i];
      worst.by_differences = numeric;
    }
    check_.worst = worst;
  }

  CeresVerdict probe(std::size_t e, double step) const {
    const auto function = [&](std::span<const double> dofs, double& value, std::span<double> gradient) {
      Dofs at;
      std::ranges::copy(dofs, at.begin());
      value = costs_.value(term_.weights, e, at);
      // Ceres requests the gradient at `dofs` only, where the assembly has computed it.
      if (!gradient.empty()) std::ranges::copy(assembled(e), gradient.begin());
      return std::isfinite(value);
    };
    // Ceres compares every component with itself. Rounding errors of its differences are 1e-12 of the natural size, and
    // a component may be a hundredth of the largest.
    const double precision = std::max(1e-5, 1e-10 * natural_[e] / largest(by_jets_[e]));
    return check_with_ceres(function, costs_.dofs_of(e, context_.phi), step * elements_[e].side, precision);
  }

  void probe_with_ceres() {
    double greatest = 0;
    for (const std::size_t e : acting_) greatest = std::max(greatest, largest(by_jets_[e]));
    std::vector<std::size_t> fit;
    for (const std::size_t e : acting_)
      if (largest(by_jets_[e]) >= 1e-3 * greatest && largest(by_jets_[e]) >= 1e-6 * natural_[e] &&
          least_distance_to_kinks(costs_, context_.level.geometry.target, e, costs_.dofs_of(e, context_.phi)) >
              2e-4 * elements_[e].side)
        fit.push_back(e);
    std::vector<std::size_t> chosen;
    const std::size_t n_wanted = std::min<std::size_t>(fit.size(), context_.settings.n_ceres_elements);
    for (std::size_t k = 0; k < n_wanted; ++k) chosen.push_back(fit[k * fit.size() / n_wanted]);
    if (!check_.faults.empty() && check_.worst) chosen.push_back(static_cast<std::size_t>(check_.worst->element));
    for (const std::size_t e : chosen) {
      // The barrier's third derivative jumps, which disturbs Ceres' extrapolation; shorter steps avoid the jump.
      CeresVerdict verdict = probe(e, 1e-4);
      for (const double step : {1e-5, 1e-6})
        if (!verdict.passed) verdict = probe(e, step);
      ++check_.ceres.n_elements;
      check_.ceres.n_failed += !verdict.passed;
      check_.ceres.worst_relative_error = std::max(check_.ceres.worst_relative_error, verdict.worst_relative_error);
    }
    if (check_.ceres.n_failed > 0)
      check_.faults.push_back(fmt::format("Ceres' GradientChecker rejects {} of {} elements", check_.ceres.n_failed,
                                          check_.ceres.n_elements));
  }

  const CheckContext<Dim>& context_;
  const Costs& costs_;
  std::span<const Element<Dim>> elements_;
  ElementDifferences<Dim> differences_;
  const AssembledTerm& term_;
  TermCheck& check_;
  std::vector<Dofs> by_jets_;
  std::vector<double> values_, natural_, error_;  // by element
  std::vector<std::size_t> acting_;
  std::size_t worst_by_differences_ = 0;
};

}  // namespace

template <int Dim>
void check_elements(const CheckContext<Dim>& context, const AssembledTerm& term, TermCheck& check) {
  ElementComparison<Dim>(context, term, check).run();
}

SHELLMATCH_2D_3D(check_elements);

}  // namespace shellmatch
