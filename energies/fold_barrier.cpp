// The barrier against folds, over all elements. Most of them are far from folding and cost a value only.

#include "energies/fold_barrier.h"

#include "base/parallel.h"
#include "energies/autodiff/compiled.h"
#include "energies/autodiff/jet.h"
#include "energies/element_batch.h"
#include "energies/matching_energy.h"

#include <algorithm>

namespace shellmatch {

using autodiff::Pack;
using autodiff::pack_size;

template <int Dim>
Pack least_determinant(const ElementBatch<Dim>& batch) {
  const auto b = bernstein_determinant<Dim>(batch.u.data());
  Pack least = b[0];
  for (const Pack& x : b) least = least < x ? least : x;
  for (int k = 0; k < Dim; ++k) least *= batch.inverse_side;
  return least;
}

template <int Dim>
template <bool WithGradient>
double MatchingEnergy<Dim>::barrier_term(std::span<const Vec<Dim>> phi, double weight) const {
  using Code = autodiff::Compiled<FoldBarrierFunctor<Dim>>;
  if (!(weight > 0)) return 0;
  const auto elements = elements_;
  const std::size_t n_batches = (elements.size() + pack_size - 1) / pack_size;
  return parallel_sum(n_batches, 64, 0.0, [&](const Chunk& chunk) {
    ElementBatch<Dim> batch;
    Pack sum{};
    for (std::size_t b = chunk.begin; b < chunk.end; ++b) {
      const int n = static_cast<int>(std::min<std::size_t>(pack_size, elements.size() - b * pack_size));
      batch.load(elements, phi,
                 [&](int lane) { return b * pack_size + static_cast<std::size_t>(std::min(lane, n - 1)); });
      Pack seed{}, scale;
      for (int lane = 0; lane < pack_size; ++lane) {
        double volume = 1;
        for (int k = 0; k < Dim; ++k) volume /= batch.inverse_side[lane];
        scale[lane] = 1.0 / (options_.fold_threshold * volume);
        if (lane < n) seed[lane] = weight * volume;
      }
      const Pack value = Code::value(batch.u.data(), &scale) * seed;
      sum += value;
      if constexpr (WithGradient) {
        // Not `> 0`: NaN must not pass for nothing to do, though the sum above has told already.
        if (autodiff::sum_lanes(value) == 0) continue;
        Code::gradient(batch.u.data(), &scale, seed, batch.gradient.data());
        for (int lane = 0; lane < n; ++lane) {
          double* out =
              element_gradients_.data() + (b * pack_size + static_cast<std::size_t>(lane)) * batch.n_dofs;
          for (int i = 0; i < batch.n_dofs; ++i) out[i] += batch.gradient[i][lane];
        }
      }
    }
    return autodiff::sum_lanes(sum);
  });
}

template Pack least_determinant(const ElementBatch<2>&);
template Pack least_determinant(const ElementBatch<3>&);
template double MatchingEnergy<2>::barrier_term<true>(std::span<const Vec<2>>, double) const;
template double MatchingEnergy<2>::barrier_term<false>(std::span<const Vec<2>>, double) const;
template double MatchingEnergy<3>::barrier_term<true>(std::span<const Vec<3>>, double) const;
template double MatchingEnergy<3>::barrier_term<false>(std::span<const Vec<3>>, double) const;

}  // namespace shellmatch
