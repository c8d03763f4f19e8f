#include "energies/assembly/not_finite.h"

#include "base/parallel.h"
#include "energies/assembly/ceres_evaluator.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace shellmatch {

namespace {

template <int Dim>
NotFinite<Dim> place_of(const Element<Dim>& element, std::size_t number, std::string what, std::string term) {
  return {std::move(what), std::move(term), number, element.side, element.corner, {}};
}

/// What is not finite of the term with number t on element e.
template <int Dim>
std::optional<NotFinite<Dim>> check_element(const MatchingEnergy<Dim>& energy, const CeresEvaluator<Dim>& costs,
                                            const Element<Dim>& element, std::size_t e, std::span<const Vec<Dim>> phi,
                                            std::size_t t, double weight) {
  TermValues alone(energy.n_terms());
  alone[t] = weight;
  typename CeresEvaluator<Dim>::Dofs dofs = costs.dofs_of(e, phi), derivative;
  const auto is_finite = [](const auto& numbers) {
    return std::ranges::all_of(numbers, [](double x) { return std::isfinite(x); });
  };
  const bool has_value = std::isfinite(costs.gradient(alone, e, dofs, derivative));
  if (has_value && is_finite(derivative)) return std::nullopt;
  auto found = place_of(element, e, has_value ? "gradient" : "value", energy.term_names()[t]);
  for (std::size_t q = 0; q < energy.shape().points.size() && !found.point; ++q) {
    const auto at_point = costs.gradient_at_point(t, weight, e, dofs, q, derivative);
    if (at_point && !(std::isfinite(*at_point) && is_finite(derivative)))
      found.point = element.corner + element.side * energy.shape().points[q].xi;
  }
  return found;
}

}  // namespace

template <int Dim>
std::optional<NotFinite<Dim>> find_not_finite(const MatchingEnergy<Dim>& energy, const Unknowns<Dim>& unknowns,
                                              std::span<const Vec<Dim>> phi, const TermValues& weights) {
  const auto elements = unknowns.elements();
  const CeresEvaluator<Dim> costs(energy);
  constexpr std::size_t at_a_time = 256;
  std::vector<std::optional<NotFinite<Dim>>> first(n_chunks(elements.size(), at_a_time));
  parallel_chunks(elements.size(), at_a_time, [&](const Chunk& chunk) {
    for (std::size_t e = chunk.begin; e < chunk.end && !first[chunk.index]; ++e)
      for (std::size_t t = 0; t < energy.n_terms() && !first[chunk.index]; ++t)
        if (weights[t] > 0) first[chunk.index] = check_element(energy, costs, elements[e], e, phi, t, weights[t]);
  });
  const auto found = std::ranges::find_if(first, [](const auto& one) { return one.has_value(); });
  return found == first.end() ? std::nullopt : *found;
}

template <int Dim>
std::string not_finite_text(const NotFinite<Dim>& found) {
  const auto text = [](const Vec<Dim>& x) { return fmt::format("({:.6g})", fmt::join(x.begin(), x.end(), ", ")); };
  return fmt::format("the {} of the term {} is not finite in the cell of side {:g} at {}{}", found.what, found.term,
                     found.side, text(found.corner),
                     found.point ? fmt::format(", at the point {}", text(*found.point)) : "");
}

SHELLMATCH_2D_3D(find_not_finite);
SHELLMATCH_2D_3D(not_finite_text);

}  // namespace shellmatch
