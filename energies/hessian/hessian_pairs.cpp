// The Gauss-Newton model of the terms of points, and the pairs that a step brings into it.

#include "energies/hessian/energy_hessian.h"

#include <utility>
#include <variant>

namespace shellmatch {

template <int Dim>
void EnergyHessian<Dim>::add_point_terms(const Chunk& cells, std::span<const Vec<Dim>> phi, const TermValues& weights,
                                         ElementMatrices<Dim>& matrices) const {
  const EnergyTerms<Dim>& terms = energy_->terms();
  for (std::size_t t = 0; t < terms.size(); ++t) {
    const auto* points = std::get_if<PointCode<Dim>>(&terms[t].term.code);
    if (!points || !(weights[t] > 0)) continue;
    points->pairs.for_each_model(cells.begin, cells.end, unknowns_->elements(), phi, weights[t],
                                 [&](const LocatedPair<Dim>& pair, const Mat<Dim>& k) {
                                   for (int i = 0; i < n_dofs; ++i)
                                     for (int j = i; j < n_dofs; ++j)
                                       matrices.add(
                                           pair.element - cells.begin, i, j,
                                           static_cast<float>(pair.n[i / Dim] * pair.n[j / Dim] * k(i % Dim, j % Dim)));
                                 });
  }
}

template <int Dim>
std::size_t EnergyHessian<Dim>::extend(std::span<const Vec<Dim>> phi, std::span<const double> d,
                                       const TermValues& weights, std::span<double> gradient) {
  const EnergyTerms<Dim>& terms = energy_->terms();
  const auto elements = unknowns_->elements();
  is_active_.resize(terms.size());
  std::vector<Vec<Dim>> nodal(phi.size(), Vec<Dim>::Zero());  // where nodes are fixed it stays 0
  unknowns_->expand(d, nodal);
  std::size_t n = 0;
  for (std::size_t t = 0; t < terms.size(); ++t) {
    const auto* points = std::get_if<PointCode<Dim>>(&terms[t].term.code);
    if (!points || !(weights[t] > 0)) continue;
    const auto pairs = points->pairs.pairs_of(0, elements.size());
    is_active_[t].resize(pairs.size(), 0);
    for (const ActivatedPair<Dim>& one : points->pairs.activated(elements, phi, nodal, weights[t])) {
      if (std::exchange(is_active_[t][one.pair], 1) != 0) continue;
      ++n;
      const LocatedPair<Dim>& pair = pairs[one.pair];
      sum_->add_to_element(
          pair.element, [&](int b, int c) { return pair.n[b] * pair.n[c]; }, one.stiffness);
      for (int c = 0; c < n_corners<Dim>; ++c)
        for (const ConstraintEntry& entry : unknowns_->constraint_entries(elements[pair.element].nodes[c]))
          for (int k = 0; k < Dim; ++k)
            gradient[static_cast<std::size_t>(entry.unknown) * Dim + k] +=
                static_cast<double>(entry.weight) * pair.n[c] * one.pull[k];
      invert_blocks_of(pair.element);
    }
  }
  return n;
}

#define SHELLMATCH_INSTANTIATE(Dim)                                                                             \
  template void EnergyHessian<Dim>::add_point_terms(const Chunk&, std::span<const Vec<Dim>>, const TermValues&, \
                                                    ElementMatrices<Dim>&) const;                               \
  template std::size_t EnergyHessian<Dim>::extend(std::span<const Vec<Dim>>, std::span<const double>,           \
                                                  const TermValues&, std::span<double>);
SHELLMATCH_INSTANTIATE(2)
SHELLMATCH_INSTANTIATE(3)
#undef SHELLMATCH_INSTANTIATE

}  // namespace shellmatch
