// The barrier against folds, over all elements. Most of them are far from folding and cost a value only.

#include "energies/fold_barrier.h"

#include "energies/autodiff/compiled.h"
#include "energies/autodiff/jet.h"
#include "energies/element_batch.h"
#include "energies/matching_energy.h"

namespace shellmatch {

using autodiff::Pack;
using autodiff::pack_size;

namespace {

/// Least Bernstein coefficient. Passive: 1 / side^Dim.
template <int Dim>
struct LeastDeterminant {
  static constexpr int n_active = n_corners<Dim> * Dim, n_passive = 1;
  template <class T, class P>
  static constexpr T evaluate(const T* active, const P* passive) {
    using autodiff::max_of;
    const auto b = bernstein_determinant<Dim>(active);
    T negative = -b[0];
    for (const T& coefficient : b) negative = max_of(negative, -coefficient);
    return -negative * passive[0];
  }
};

/// By how much coefficients lie below 1: 0 where the barrier vanishes, which is known so without roots and divisions.
/// NaN where one of them is. Passive as FoldBarrierFunctor.
template <int Dim>
struct BarrierGap {
  static constexpr int n_active = n_corners<Dim> * Dim, n_passive = 1;
  template <class T, class P>
  static constexpr T evaluate(const T* active, const P* passive) {
    using autodiff::max_of;
    T gaps(0.0), sum(0.0);
    for (const T& coefficient : bernstein_determinant<Dim>(active)) {
      const T x = coefficient * passive[0];
      gaps = gaps + max_of(1.0 - x, T(0.0));  // 0 for NaN
      sum = sum + x;
    }
    return gaps + (sum - sum);
  }
};

}  // namespace

template <int Dim>
Pack least_determinant(const ElementBatch<Dim>& batch) {
  Pack scale = batch.inverse_side;
  for (int k = 1; k < Dim; ++k) scale *= batch.inverse_side;
  return autodiff::Compiled<LeastDeterminant<Dim>>::value(batch.u.data(), &scale);
}

template <int Dim>
template <bool WithGradient>
double MatchingEnergy<Dim>::barrier_term(const Chunk& patch, std::span<const Vec<Dim>> phi, double weight,
                                         double* gradients) const {
  using Code = autodiff::Compiled<FoldBarrierFunctor<Dim>>;
  if (!(weight > 0)) return 0;
  const auto elements = elements_.subspan(patch.begin, patch.end - patch.begin);
  ElementBatch<Dim> batch;
  Pack sum{};
  for (std::size_t first = 0; first < elements.size(); first += pack_size) {
    const std::size_t n = batch.load_run(elements, phi, first);
    Pack seed{}, scale;
    for (std::size_t lane = 0; lane < pack_size; ++lane) {
      double volume = 1;
      for (int k = 0; k < Dim; ++k) volume /= batch.inverse_side[lane];
      scale[lane] = 1.0 / (options_.fold_threshold * volume);
      if (lane < n) seed[lane] = weight * volume;
    }
    const Pack gap = autodiff::Compiled<BarrierGap<Dim>>::value(batch.u.data(), &scale);
    if (autodiff::sum_lanes(gap) == 0) continue;  // most cells
    const Pack value = Code::value(batch.u.data(), &scale) * seed;
    sum += value;
    if constexpr (WithGradient) {
      // Not `> 0`: NaN must not pass for nothing to do, though the sum above has told already.
      if (autodiff::sum_lanes(value) == 0) continue;
      Code::gradient(batch.u.data(), &scale, seed, batch.gradient.data());
      batch.add_gradients(n, gradients + first * batch.n_dofs);
    }
  }
  return autodiff::sum_lanes(sum);
}

template Pack least_determinant(const ElementBatch<2>&);
template Pack least_determinant(const ElementBatch<3>&);
template double MatchingEnergy<2>::barrier_term<true>(const Chunk&, std::span<const Vec<2>>, double, double*) const;
template double MatchingEnergy<2>::barrier_term<false>(const Chunk&, std::span<const Vec<2>>, double, double*) const;
template double MatchingEnergy<3>::barrier_term<true>(const Chunk&, std::span<const Vec<3>>, double, double*) const;
template double MatchingEnergy<3>::barrier_term<false>(const Chunk&, std::span<const Vec<3>>, double, double*) const;

}  // namespace shellmatch
