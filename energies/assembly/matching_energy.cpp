#include "energies/assembly/matching_energy.h"

#include "base/error.h"
#include "base/parallel.h"

#include <algorithm>
#include <atomic>
#include <cmath>

namespace shellmatch {

TermValues term_weights(const EnergyOptions& o, double nu, double volume_weight) {
  TermValues w;
  w[Term::match] = o.match_weight / nu;
  w[Term::membrane] = o.membrane_weight * o.delta;
  w[Term::bending] = o.bending_weight * o.delta * o.delta * o.delta;
  w[Term::volume] = o.volume_weight * volume_weight;
  w[Term::barrier] = o.fold_barrier;
  return w;
}

template <int Dim>
MatchingEnergy<Dim>::MatchingEnergy(const Unknowns<Dim>& unknowns, const GeometryPair<Dim>& geometry,
                                    const EnergyOptions& options, double sigma, int points_per_direction)
    : MatchingEnergy(unknowns.elements(), geometry, options, sigma, points_per_direction) {
  cell_blocks_.emplace(unknowns);
}

template <int Dim>
MatchingEnergy<Dim>::MatchingEnergy(std::span<const Element<Dim>> elements, const GeometryPair<Dim>& geometry,
                                    const EnergyOptions& options, double sigma, int points_per_direction)
    : elements_(elements),
      target_(&geometry.target),
      options_(options),
      shape_(points_per_direction),
      band_(elements, shape_, geometry.reference, geometry.root_is_inverse, sigma) {}

template <int Dim>
template <bool WithGradient>
TermValues MatchingEnergy<Dim>::all_terms(const Chunk& cells, std::span<const Vec<Dim>> phi, const TermValues& weights,
                                          double* gradients, BandSums* band_sums) const {
  TermValues values;
  const bool is_possible = set_cell_terms<WithGradient>(cells, phi, weights, values, gradients);
  if (is_possible || band_sums) add_band_terms<WithGradient>(cells, phi, weights, values, gradients, band_sums);
  return values;
}

template <int Dim>
bool MatchingEnergy<Dim>::evaluate(std::span<const Vec<Dim>> phi, const TermValues& weights, TermValues& values,
                                   std::span<double> gradient, std::vector<double>* element_gradients) const {
  constexpr std::size_t n_dofs = n_corners<Dim> * Dim;
  std::atomic<bool> possible = true;  // what is left need not be worked out where it is not
  parallel_chunks(phi.size(), 16384, [&](const Chunk& chunk) {
    for (std::size_t i = chunk.begin; i < chunk.end; ++i)
      if (!phi[i].allFinite()) possible = false;
  });
  if (!possible) return false;
  const std::size_t of_block = cells_per_block(elements_.size());
  std::vector<TermValues> parts(n_chunks(elements_.size(), of_block));
  if (gradient.empty()) {
    parallel_chunks(elements_.size(), of_block, [&](const Chunk& cells) {
      if (!possible) return;
      parts[cells.index] = all_terms<false>(cells, phi, weights, nullptr, nullptr);
      if (!std::isfinite(parts[cells.index].sum())) possible = false;
    });
  } else {
    SHELLMATCH_CHECK(cell_blocks_.has_value(), "a part of the energy has values only");
    if (element_gradients) element_gradients->resize(elements_.size() * n_dofs);
    cell_blocks_->for_each([&](const Chunk& cells) {
      if (!possible) return;
      static thread_local std::vector<autodiff::Pack> packs;  // as they are aligned
      const std::size_t n = (cells.end - cells.begin) * n_dofs;
      packs.resize(n / autodiff::pack_size);
      double* gradients = reinterpret_cast<double*>(packs.data());
      parts[cells.index] = all_terms<true>(cells, phi, weights, gradients, nullptr);
      if (!std::isfinite(parts[cells.index].sum())) possible = false;
      cell_blocks_->add(cells, gradients, gradient);
      if (element_gradients) std::copy_n(gradients, n, element_gradients->data() + cells.begin * n_dofs);
    });
  }
  values = {};
  for (const TermValues& part : parts) values += part;
  return std::isfinite(values.sum());  // or else a block was not
}

template <int Dim>
bool MatchingEnergy<Dim>::report(std::span<const Vec<Dim>> phi, const TermValues& weights, TermValues& values,
                                 BandSums& band) const {
  struct Part {
    TermValues values;
    BandSums band;
    Part& operator+=(const Part& o) {
      values += o.values;
      band += o.band;
      return *this;
    }
  };
  const Part sum = parallel_sum(elements_.size(), cells_per_block(elements_.size()), Part{}, [&](const Chunk& cells) {
    Part part;
    part.values = all_terms<false>(cells, phi, weights, nullptr, &part.band);
    return part;
  });
  values = sum.values;
  band = sum.band;
  return std::isfinite(values.sum());
}

template class MatchingEnergy<2>;
template class MatchingEnergy<3>;

}  // namespace shellmatch
