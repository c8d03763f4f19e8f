#include "energies/matching_energy.h"

#include "base/error.h"
#include "base/parallel.h"

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
  unknowns_ = &unknowns;
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
bool MatchingEnergy<Dim>::evaluate(std::span<const Vec<Dim>> phi, const TermValues& weights,
                                   TermValues& values, std::span<double> gradient) const {
  for (const Vec<Dim>& y : phi)
    if (!y.allFinite()) return false;
  if (gradient.empty()) {
    // The cheapest way to find out that there is a fold comes first.
    const double barrier = barrier_term<false>(phi, weights[Term::barrier]);
    if (!std::isfinite(barrier)) return false;
    values = band_terms<false>(phi, weights);
    values[Term::volume] = volume_term<false>(phi, weights[Term::volume]);
    values[Term::barrier] = barrier;
    return std::isfinite(values.sum());
  }
  SHELLMATCH_CHECK(unknowns_ != nullptr, "a part of the energy has values only");
  element_gradients_.resize(elements_.size() * (n_corners<Dim> * Dim));
  // The volume term writes every element's gradient, the band terms add to those of the band.
  const double volume = volume_term<true>(phi, weights[Term::volume]);
  const double barrier = barrier_term<true>(phi, weights[Term::barrier]);
  if (!std::isfinite(barrier)) return false;
  values = band_terms<true>(phi, weights);
  values[Term::volume] = volume;
  values[Term::barrier] = barrier;
  if (!std::isfinite(values.sum())) return false;
  unknowns_->sum_elements(element_gradients_, gradient);
  return true;
}

template class MatchingEnergy<2>;
template class MatchingEnergy<3>;

}  // namespace shellmatch
