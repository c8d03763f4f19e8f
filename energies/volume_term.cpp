// The volume term, over all elements.

#include "energies/autodiff/compiled.h"
#include "energies/element_batch.h"
#include "energies/matching_energy.h"

#include "base/parallel.h"

#include <algorithm>

namespace shellmatch {

namespace {

using autodiff::Pack;
using autodiff::pack_size;

/// Sum over all elements of weight * density(Dphi); writes the element gradients.
template <class Functor, int Dim, bool WithGradient>
double sum_volume(std::span<const Element<Dim>> elements, std::span<const Vec<Dim>> phi, const ShapeTable<Dim>& shape,
                  const EnergyOptions& options, double weight, std::vector<double>& element_gradients) {
  using Code = autodiff::Compiled<Functor>;
  const std::size_t n_batches = (elements.size() + pack_size - 1) / pack_size;
  return parallel_sum(n_batches, 64, 0.0, [&](const Chunk& chunk) {
    ElementBatch<Dim> batch;
    const std::array<Pack, 2> passive = {Pack{} + options.lambda, Pack{} + options.mu};
    std::array<Pack, Dim * Dim> dphi, adjoint;
    Pack sum{};
    for (std::size_t b = chunk.begin; b < chunk.end; ++b) {
      const int n = static_cast<int>(std::min<std::size_t>(pack_size, elements.size() - b * pack_size));
      batch.load(elements, phi, [&](int lane) { return b * pack_size + static_cast<std::size_t>(std::min(lane, n - 1)); });
      batch.clear_gradient();
      Pack volume{};
      for (int lane = 0; lane < n; ++lane) {
        volume[lane] = weight;
        for (int k = 0; k < Dim; ++k) volume[lane] *= elements[b * pack_size + static_cast<std::size_t>(lane)].side;
      }
      for (const auto& q : shape.points) {
        batch.jacobian(q, dphi.data());
        const Pack seed = volume * q.weight;
        if constexpr (WithGradient) {
          sum += seed * Code::gradient(dphi.data(), passive.data(), seed, adjoint.data());
          batch.add_jacobian_adjoint(q, adjoint.data());
        } else {
          sum += seed * Code::value(dphi.data(), passive.data());
        }
      }
      if constexpr (WithGradient)
        for (int lane = 0; lane < n; ++lane) {
          double* out = element_gradients.data() + (b * pack_size + static_cast<std::size_t>(lane)) * batch.n_dofs;
          for (int i = 0; i < batch.n_dofs; ++i) out[i] = batch.gradient[i][lane];
        }
    }
    return autodiff::sum_lanes(sum);
  });
}

}  // namespace

template <int Dim>
template <bool WithGradient>
double MatchingEnergy<Dim>::volume_term(std::span<const Vec<Dim>> phi, double weight) const {
  if (!(weight > 0)) {
    std::fill(element_gradients_.begin(), element_gradients_.end(), 0.0);
    return 0;
  }
  const auto run = [&]<class Density>() {
    return sum_volume<VolumeFunctor<Density, Dim>, Dim, WithGradient>(elements_, phi, shape_, options_,
                                                                      weight, element_gradients_);
  };
  switch (options_.volume) {
    case VolumeDensity::full: return run.template operator()<FullVolume<Dim>>();
    case VolumeDensity::symmetric_dirichlet: return run.template operator()<SymmetricDirichletVolume<Dim>>();
    case VolumeDensity::simplified: break;
  }
  return run.template operator()<SimplifiedVolume<Dim>>();
}

template double MatchingEnergy<2>::volume_term<true>(std::span<const Vec<2>>, double) const;
template double MatchingEnergy<2>::volume_term<false>(std::span<const Vec<2>>, double) const;
template double MatchingEnergy<3>::volume_term<true>(std::span<const Vec<3>>, double) const;
template double MatchingEnergy<3>::volume_term<false>(std::span<const Vec<3>>, double) const;

}  // namespace shellmatch
