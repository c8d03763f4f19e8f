#include "matching/derivative_check/element_differences.h"

#include "matching/derivative_check/kink_free.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace shellmatch {

template <int Dim>
ElementDifferences<Dim>::ElementDifferences(const CheckContext<Dim>& context, const TermValues& weights)
    : context_(context), costs_(context.costs), elements_(context.level.unknowns.elements()), weights_(weights) {}

template <int Dim>
double ElementDifferences<Dim>::value_at(std::size_t e, Dofs dofs, int i, double step) const {
  dofs[i] += step;
  return costs_.value(weights_, e, dofs);
}

template <int Dim>
double ElementDifferences<Dim>::central(std::size_t e, const Dofs& dofs, int i, double step) const {
  const auto plain = [&](double h) { return (value_at(e, dofs, i, h) - value_at(e, dofs, i, -h)) / (2 * h); };
  return (4 * plain(step / 2) - plain(step)) / 3;
}

template <int Dim>
DifferenceError ElementDifferences<Dim>::compare(std::size_t e, const ElementGradient& gradient) const {
  const Dofs dofs = costs_.dofs_of(e, context_.phi);
  const double side = elements_[e].side;
  const double distance = least_distance_to_kinks(costs_, context_.level.geometry.target, e, dofs);
  if (distance < 1.1e-6 * side) return {.error = 0, .near_face = true, .kink = false};
  DifferenceError result;
  for (int i = 0; i < CeresEvaluator<Dim>::n_dofs; ++i) {
    double least = std::numeric_limits<double>::infinity();
    for (const double share : {1e-4, 1e-5, 1e-6}) {
      if (distance < 1.1 * share * side) continue;
      const double rounding = 1e-14 / share * (gradient.natural_size + std::abs(gradient.value) / side);
      const double tolerance = 1e-6 * gradient.largest_by_jets + rounding;
      const double error = std::abs(central(e, dofs, i, share * side) - gradient.assembled[i]) / tolerance;
      least = std::min(least, error);  // std::min keeps `least` where the error is NaN
      if (least <= 1) break;
    }
    if (!(least <= 1) && is_kink(e, dofs, i, gradient)) result.kink = true;
    else result.error = std::max(result.error, least);
  }
  return result;
}

template <int Dim>
bool ElementDifferences<Dim>::is_kink(std::size_t e, const Dofs& dofs, int i, const ElementGradient& gradient) const {
  const double h = 1e-7 * elements_[e].side, middle = value_at(e, dofs, i, 0);
  const double right = (value_at(e, dofs, i, h) - middle) / h, left = (middle - value_at(e, dofs, i, -h)) / h;
  const double tolerance = 1e-5 * gradient.largest_by_jets + 1e-6 * gradient.natural_size;
  const double assembled = gradient.assembled[i];
  return std::abs(right - left) > 10 * tolerance &&
         std::min(std::abs(right - assembled), std::abs(left - assembled)) < tolerance;
}

template class ElementDifferences<2>;
template class ElementDifferences<3>;

}  // namespace shellmatch
