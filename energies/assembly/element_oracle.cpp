#include "energies/assembly/element_oracle.h"

#include "energies/assembly/element_cost.h"

#include <algorithm>
#include <limits>

namespace shellmatch {

template <int Dim>
ElementOracle<Dim>::ElementOracle(const MatchingEnergy<Dim>& energy, const Unknowns<Dim>& unknowns,
                                  const GeometryField<Dim>& target, const EnergyOptions& options)
    : energy_(&energy), elements_(unknowns.elements()), target_(&target), options_(options),
      place_(elements_.size(), no_index) {
  const auto batches = energy.band().batches();
  for (std::size_t b = 0; b < batches.size(); ++b)
    for (int lane = 0; lane < batches[b].n_elements; ++lane)
      place_[batches[b].element[lane]] = static_cast<Index>(b) * Band<Dim>::n_lanes + lane;
}

template <int Dim>
template <class T>
T ElementOracle<Dim>::sum(const TermValues& weights, std::size_t e, const std::array<T, n_dofs>& dofs) const {
  const Lame<double> lame{options_.lambda, options_.mu};
  T total(0.0);
  const auto add = [&](const auto& cost) {
    T energy(0.0);
    if (!cost(dofs.data(), &energy)) energy = T(std::numeric_limits<double>::quiet_NaN());
    total += energy;
  };
  const auto& shape = energy_->shape();
  if (place_[e] != no_index) {
    const std::size_t batch = static_cast<std::size_t>(place_[e] / Band<Dim>::n_lanes);
    const int lane = place_[e] % Band<Dim>::n_lanes;
    const auto add_band = [&]<template <int> class BandTerm>(double weight) {
      if (weight > 0)
        add(BandElementCost<BandTerm, Dim>(energy_->band(), batch, lane, elements_, shape, *target_, weight, lame));
    };
    add_band.template operator()<Match>(weights[Term::match]);
    switch (const double weight = weights[Term::membrane]; options_.membrane) {
      case MembraneModel::thin_shell: add_band.template operator()<Membrane>(weight); break;
      case MembraneModel::no_p2: add_band.template operator()<MembraneWithoutP2>(weight); break;
      case MembraneModel::cauchy_green: add_band.template operator()<CauchyGreenMembrane>(weight); break;
    }
    switch (const double weight = weights[Term::bending]; options_.bending) {
      case BendingModel::thin_shell: add_band.template operator()<Bending>(weight); break;
      case BendingModel::no_p2: add_band.template operator()<BendingWithoutP2>(weight); break;
      case BendingModel::quadratic: add_band.template operator()<QuadraticBending>(weight); break;
    }
  }
  const double side = elements_[e].side;
  if (const double weight = weights[Term::volume]; weight > 0) switch (options_.volume) {
      case VolumeDensity::simplified: add(VolumeElementCost<SimplifiedVolume, Dim>(side, shape, weight, lame)); break;
      case VolumeDensity::full: add(VolumeElementCost<FullVolume, Dim>(side, shape, weight, lame)); break;
      case VolumeDensity::symmetric_dirichlet:
        add(VolumeElementCost<SymmetricDirichletVolume, Dim>(side, shape, weight, lame));
        break;
    }
  if (const double weight = weights[Term::barrier]; weight > 0)
    add(BarrierElementCost<Dim>(side, weight, options_.fold_threshold));
  return total;
}

template <int Dim>
double ElementOracle<Dim>::value(const TermValues& weights, std::size_t e, const Dofs& dofs) const {
  return sum<double>(weights, e, dofs);
}

template <int Dim>
double ElementOracle<Dim>::gradient(const TermValues& weights, std::size_t e, const Dofs& dofs, Dofs& gradient) const {
  using Jet = ceres::Jet<double, n_dofs>;
  std::array<Jet, n_dofs> jets;
  for (int i = 0; i < n_dofs; ++i) jets[i] = Jet(dofs[i], i);
  const Jet energy = sum<Jet>(weights, e, jets);
  for (int i = 0; i < n_dofs; ++i) gradient[i] = energy.v[i];
  return energy.a;
}

template <int Dim>
std::vector<int> ElementOracle<Dim>::band_points(std::size_t e) const {
  std::vector<int> points;
  if (place_[e] == no_index) return points;
  for (std::size_t q = 0; q < energy_->shape().points.size(); ++q) {
    const auto& point = energy_->band().point(static_cast<std::size_t>(place_[e] / Band<Dim>::n_lanes), q);
    if (point.weight[place_[e] % Band<Dim>::n_lanes] > 0) points.push_back(static_cast<int>(q));
  }
  return points;
}

template <int Dim>
typename ElementOracle<Dim>::Dofs ElementOracle<Dim>::dofs_of(std::size_t e, std::span<const Vec<Dim>> phi) const {
  Dofs dofs;
  for (int i = 0; i < n_dofs; ++i) dofs[i] = phi[elements_[e].nodes[i / Dim]][i % Dim];
  return dofs;
}

template <int Dim>
Vec<Dim> ElementOracle<Dim>::position(const Dofs& dofs, int point) const {
  const auto& q = energy_->shape().points[point];
  Vec<Dim> y = Vec<Dim>::Zero();
  for (int i = 0; i < n_dofs; ++i) y[i % Dim] += q.n[i / Dim] * dofs[i];
  return y;
}

template <int Dim>
double ElementOracle<Dim>::natural_size(const TermValues& weights, std::size_t e) const {
  double volume = 1, band = 0;
  for (int k = 0; k < Dim; ++k) volume *= elements_[e].side;
  for (const int q : band_points(e))
    band += energy_->band().point(static_cast<std::size_t>(place_[e] / Band<Dim>::n_lanes), q)
                .weight[place_[e] % Band<Dim>::n_lanes];
  const double modulus = std::max(options_.lambda, options_.mu);
  const double stress = modulus * (band * (weights[Term::membrane] + weights[Term::bending]) + volume * weights[Term::volume]) +
                        volume * weights[Term::barrier] / options_.fold_threshold;
  return stress / elements_[e].side + band * weights[Term::match];
}

template class ElementOracle<2>;
template class ElementOracle<3>;

}  // namespace shellmatch
