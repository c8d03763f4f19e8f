// The volume term, over all elements.

#include "energies/autodiff/compiled.h"
#include "energies/element_batch.h"
#include "energies/matching_energy.h"

namespace shellmatch {

namespace {

using autodiff::Pack;
using autodiff::pack_size;

/// Sum over the elements of weight * density(Dphi); adds to the element gradients.
template <class Functor, int Dim, bool WithGradient>
double sum_volume(std::span<const Element<Dim>> elements, std::span<const Vec<Dim>> phi, const ShapeTable<Dim>& shape,
                  const EnergyOptions& options, double weight, double* gradients) {
  using Code = autodiff::Compiled<Functor>;
  ElementBatch<Dim> batch;
  const std::array<Pack, 2> passive = {Pack{} + options.lambda, Pack{} + options.mu};
  std::array<Pack, Dim * Dim> dphi, adjoint;
  Pack sum{};
  for (std::size_t first = 0; first < elements.size(); first += pack_size) {
    const std::size_t n = batch.load_run(elements, phi, first);
    batch.clear_gradient();
    Pack volume{};
    for (std::size_t lane = 0; lane < n; ++lane) {
      volume[lane] = weight;
      for (int k = 0; k < Dim; ++k) volume[lane] *= elements[first + lane].side;
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
    if constexpr (WithGradient) batch.add_gradients(n, gradients + first * batch.n_dofs);
  }
  return autodiff::sum_lanes(sum);
}

}  // namespace

template <int Dim>
template <bool WithGradient>
double MatchingEnergy<Dim>::volume_term(const Chunk& patch, std::span<const Vec<Dim>> phi, double weight,
                                        double* gradients) const {
  if (!(weight > 0)) return 0;
  const auto run = [&]<class Density>() {
    return sum_volume<VolumeFunctor<Density, Dim>, Dim, WithGradient>(
        elements_.subspan(patch.begin, patch.end - patch.begin), phi, shape_, options_, weight, gradients);
  };
  switch (options_.volume) {
    case VolumeDensity::full: return run.template operator()<FullVolume<Dim>>();
    case VolumeDensity::symmetric_dirichlet: return run.template operator()<SymmetricDirichletVolume<Dim>>();
    case VolumeDensity::simplified: break;
  }
  return run.template operator()<SimplifiedVolume<Dim>>();
}

template double MatchingEnergy<2>::volume_term<true>(const Chunk&, std::span<const Vec<2>>, double, double*) const;
template double MatchingEnergy<2>::volume_term<false>(const Chunk&, std::span<const Vec<2>>, double, double*) const;
template double MatchingEnergy<3>::volume_term<true>(const Chunk&, std::span<const Vec<3>>, double, double*) const;
template double MatchingEnergy<3>::volume_term<false>(const Chunk&, std::span<const Vec<3>>, double, double*) const;

}  // namespace shellmatch
