// The Gauss-Newton model of the terms of point pairs.

#include "energies/hessian/energy_hessian.h"

namespace shellmatch {

template <int Dim>
void EnergyHessian<Dim>::add_pair_terms(const Chunk& cells, std::span<const Vec<Dim>> phi, const TermValues& weights,
                                        ElementMatrices<Dim>& matrices) const {
  const auto terms = energy_->pair_terms();
  for (std::size_t t = 0; t < terms.size(); ++t) {
    const double weight = weights[energy_->terms().size() + t];
    if (!(weight > 0)) continue;
    terms[t].pairs.for_each_model(
        cells.begin, cells.end, unknowns_->elements(), phi, weight, [&](const LocatedPair<Dim>& pair, const Mat<Dim>& k) {
          for (int i = 0; i < n_dofs; ++i)
            for (int j = i; j < n_dofs; ++j)
              matrices.add(pair.element - cells.begin, i, j,
                           static_cast<float>(pair.n[i / Dim] * pair.n[j / Dim] * k(i % Dim, j % Dim)));
        });
  }
}

#define SHELLMATCH_INSTANTIATE(Dim)                                                                            \
  template void EnergyHessian<Dim>::add_pair_terms(const Chunk&, std::span<const Vec<Dim>>, const TermValues&, \
                                                   ElementMatrices<Dim>&) const;
SHELLMATCH_INSTANTIATE(2)
SHELLMATCH_INSTANTIATE(3)
#undef SHELLMATCH_INSTANTIATE

}  // namespace shellmatch
