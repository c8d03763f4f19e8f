// Assembly of the terms that act on all cells, over one block of cells.

#include "energies/assembly/matching_energy.h"

#include <algorithm>
#include <cmath>
#include <type_traits>
#include <variant>
#include <vector>

namespace shellmatch {

namespace {

using autodiff::Pack;

template <int Dim>
struct Acting {
  CellKernel<Dim> apply;
  const Material<double>* material;
  const UserFields<Dim>* own_fields;
  double weight, *value;
  bool may_fail;  ///< corner terms find folds: checked after every batch, the first fold ends the block
  Pack sum{};
};

// Corner terms come first: away from folds they are cheap, and they detect folds.
template <int Dim, bool WithGradient>
std::vector<Acting<Dim>> acting_terms(const EnergyTerms<Dim>& terms, const TermValues& weights, double* values) {
  std::vector<Acting<Dim>> acting;
  const auto add = [&]<class Code>(std::type_identity<Code>) {
    for (std::size_t t = 0; t < terms.size(); ++t)
      if (const auto* code = std::get_if<Code>(&terms[t].term.code); code && weights[t] > 0)
        acting.push_back({WithGradient ? code->gradient : code->value, &terms[t].material, &terms[t].own_fields,
                          weights[t], values + t, std::is_same_v<Code, CornerCode<Dim>>});
  };
  add(std::type_identity<CornerCode<Dim>>{});
  add(std::type_identity<CellCode<Dim>>{});
  return acting;
}

}  // namespace

template <int Dim>
template <bool WithGradient>
bool MatchingEnergy<Dim>::set_cell_terms(const Chunk& cells, std::span<const Vec<Dim>> phi, const TermValues& weights,
                                         double* values, double* gradients) const {
  const auto elements = elements_.subspan(cells.begin, cells.end - cells.begin);
  auto acting = acting_terms<Dim, WithGradient>(*terms_, weights, values);
  if (acting.empty()) {
    if (WithGradient) std::fill_n(gradients, elements.size() * ElementBatch<Dim>::n_dofs, 0.0);
    return true;
  }
  CellBatch<Dim> batch(shape_);
  batch.all = elements_;
  for (std::size_t first = 0; first < elements.size(); first += autodiff::pack_size) {
    const std::size_t n = batch.elements.load_run(elements, phi, first);
    if constexpr (WithGradient) batch.elements.clear_gradient();
    Pack measure{};
    for (std::size_t lane = 0; lane < n; ++lane) measure[lane] = 1;
    for (int k = 0; k < Dim; ++k) measure *= batch.elements.side;
    for (std::size_t lane = 0; lane < batch.number.size(); ++lane)
      batch.number[lane] = cells.begin + first + std::min(lane, n - 1);
    for (Acting<Dim>& term : acting) {
      batch.own_fields = term.own_fields;
      term.sum += term.apply(batch, shape_, *term.material, measure * term.weight);
      if (!term.may_fail) continue;
      if (const double so_far = autodiff::sum_lanes(term.sum); !std::isfinite(so_far)) {
        *term.value = so_far;
        return false;
      }
    }
    if constexpr (WithGradient) batch.elements.store_gradients(n, gradients + first * ElementBatch<Dim>::n_dofs);
  }
  for (const Acting<Dim>& term : acting) *term.value += autodiff::sum_lanes(term.sum);
  return true;
}

template bool MatchingEnergy<2>::set_cell_terms<true>(const Chunk&, std::span<const Vec<2>>, const TermValues&, double*,
                                                      double*) const;
template bool MatchingEnergy<2>::set_cell_terms<false>(const Chunk&, std::span<const Vec<2>>, const TermValues&,
                                                       double*, double*) const;
template bool MatchingEnergy<3>::set_cell_terms<true>(const Chunk&, std::span<const Vec<3>>, const TermValues&, double*,
                                                      double*) const;
template bool MatchingEnergy<3>::set_cell_terms<false>(const Chunk&, std::span<const Vec<3>>, const TermValues&,
                                                       double*, double*) const;

}  // namespace shellmatch
