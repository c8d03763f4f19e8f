// The terms that every element has, summed over a block.

#include "energies/assembly/cell_terms.h"

#include "energies/assembly/matching_energy.h"

#include <cmath>

namespace shellmatch {

template <int Dim>
template <bool WithGradient>
bool MatchingEnergy<Dim>::set_cell_terms(const Chunk& cells, std::span<const Vec<Dim>> phi, const TermValues& weights,
                                         TermValues& values, double* gradients) const {
  using autodiff::Pack;
  const auto elements = elements_.subspan(cells.begin, cells.end - cells.begin);
  const double volume_weight = weights[Term::volume], barrier_weight = weights[Term::barrier];
  if (!(volume_weight > 0 || barrier_weight > 0)) {
    if (WithGradient) std::fill_n(gradients, elements.size() * ElementBatch<Dim>::n_dofs, 0.0);
    return true;
  }
  const CellKernel<Dim> volume_term = volume_kernel<Dim, WithGradient>(options_.volume);
  CellBatch<Dim> batch(shape_);
  Pack volume{}, barrier{};
  for (std::size_t first = 0; first < elements.size(); first += autodiff::pack_size) {
    const std::size_t n = batch.elements.load_run(elements, phi, first);
    if constexpr (WithGradient) batch.elements.clear_gradient();
    Pack measure{};
    for (std::size_t lane = 0; lane < n; ++lane) measure[lane] = 1;
    for (int k = 0; k < Dim; ++k) measure *= batch.elements.side;
    if (barrier_weight > 0) {
      barrier += fold_barrier<Dim, WithGradient>(batch, options_.fold_threshold, measure * barrier_weight);
      values[Term::barrier] = autodiff::sum_lanes(barrier);
      if (!std::isfinite(values[Term::barrier])) return false;
    }
    if (volume_weight > 0) volume += volume_term(batch, shape_, options_, measure * volume_weight);
    if constexpr (WithGradient) batch.elements.store_gradients(n, gradients + first * ElementBatch<Dim>::n_dofs);
  }
  values[Term::volume] = autodiff::sum_lanes(volume);
  return true;
}

template bool MatchingEnergy<2>::set_cell_terms<true>(const Chunk&, std::span<const Vec<2>>, const TermValues&,
                                                    TermValues&, double*) const;
template bool MatchingEnergy<2>::set_cell_terms<false>(const Chunk&, std::span<const Vec<2>>, const TermValues&,
                                                     TermValues&, double*) const;
template bool MatchingEnergy<3>::set_cell_terms<true>(const Chunk&, std::span<const Vec<3>>, const TermValues&,
                                                    TermValues&, double*) const;
template bool MatchingEnergy<3>::set_cell_terms<false>(const Chunk&, std::span<const Vec<3>>, const TermValues&,
                                                     TermValues&, double*) const;

}  // namespace shellmatch
