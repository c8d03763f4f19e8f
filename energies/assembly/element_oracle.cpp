#include "energies/assembly/element_oracle.h"

#include "energies/compiled/element_fields.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <variant>

namespace shellmatch {

template <int Dim>
ElementOracle<Dim>::ElementOracle(const MatchingEnergy<Dim>& energy, const Unknowns<Dim>& unknowns)
    : energy_(&energy), elements_(unknowns.elements()), lane_of_(elements_.size(), no_index) {
  const auto batches = energy.band().batches();
  for (std::size_t b = 0; b < batches.size(); ++b)
    for (int lane = 0; lane < batches[b].n_elements; ++lane)
      lane_of_[batches[b].element[lane]] = static_cast<Index>(b) * Band<Dim>::n_lanes + lane;
}

// Scratch of this thread, valid until its next call.
template <int Dim>
ElementFields<Dim>& ElementOracle<Dim>::fields_of(std::size_t e) const {
  static thread_local ElementFields<Dim> fields;
  fields.assign(elements_[e], energy_->band(), lane_of_[e], energy_->target(), energy_->shape());
  return fields;
}

template <int Dim>
double ElementOracle<Dim>::value(const TermValues& weights, std::size_t e, const Dofs& dofs) const {
  const ElementFields<Dim>& fields = fields_of(e);
  double sum = 0;
  for (std::size_t t = 0; t < energy_->terms().size(); ++t)
    if (const auto& [term, own, material] = energy_->terms()[t]; weights[t] > 0)
      sum += term.element_value(fields, dofs.data(), weights[t], material);
  for_each_pair_term(weights, [&](const PairTerm<Dim>& pairs, double weight) {
    sum += pairs.element_value(e, dofs.data(), weight);
  });
  return std::isfinite(sum) ? sum : std::numeric_limits<double>::quiet_NaN();
}

namespace {

/// The degrees of freedom as variables.
template <int Dim>
auto variables_of(const typename ElementOracle<Dim>::Dofs& dofs) {
  std::array<typename CompiledTerm<Dim>::Jet, ElementOracle<Dim>::n_dofs> jets;
  for (int i = 0; i < ElementOracle<Dim>::n_dofs; ++i) jets[i] = typename CompiledTerm<Dim>::Jet(dofs[i], i);
  return jets;
}

}  // namespace

template <int Dim>
double ElementOracle<Dim>::gradient(const TermValues& weights, std::size_t e, const Dofs& dofs, Dofs& gradient) const {
  using Jet = typename CompiledTerm<Dim>::Jet;
  const ElementFields<Dim>& fields = fields_of(e);
  const auto jets = variables_of<Dim>(dofs);
  Jet sum(0.0);
  for (std::size_t t = 0; t < energy_->terms().size(); ++t)
    if (const auto& [term, own, material] = energy_->terms()[t]; weights[t] > 0)
      sum += term.element_derivative(fields, jets.data(), weights[t], material);
  for_each_pair_term(weights, [&](const PairTerm<Dim>& pairs, double weight) {
    sum += pairs.element_value(e, jets.data(), weight);
  });
  for (int i = 0; i < n_dofs; ++i) gradient[i] = sum.v[i];
  return std::isfinite(sum.a) ? sum.a : std::numeric_limits<double>::quiet_NaN();
}

template <int Dim>
std::optional<double> ElementOracle<Dim>::gradient_at_point(std::size_t t, double weight, std::size_t e, const Dofs& dofs,
                                                            std::size_t q, Dofs& gradient) const {
  if (t >= energy_->terms().size()) return std::nullopt;
  const auto& [term, own, material] = energy_->terms()[t];
  if (std::holds_alternative<CornerCode<Dim>>(term.code)) return std::nullopt;
  // The element with this point alone.
  ElementFields<Dim> fields = fields_of(e);
  const bool is_of_band = std::holds_alternative<BandCode<Dim>>(term.code);
  if (is_of_band && (fields.band.empty() || !(fields.band[q].weight > 0))) return std::nullopt;
  ShapeTable<Dim> one = *fields.shape;
  one.points = {fields.shape->points[q]};
  fields.shape = &one;
  if (!fields.band.empty()) fields.band = {fields.band[q]};
  const auto sum = term.element_derivative(fields, variables_of<Dim>(dofs).data(), weight, material);
  for (int i = 0; i < n_dofs; ++i) gradient[i] = sum.v[i];
  return sum.a;
}

template <int Dim>
std::vector<int> ElementOracle<Dim>::band_points(std::size_t e) const {
  std::vector<int> points;
  const auto& band = fields_of(e).band;
  for (std::size_t q = 0; q < band.size(); ++q)
    if (band[q].weight > 0) points.push_back(static_cast<int>(q));
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
  const ElementFields<Dim>& fields = fields_of(e);
  const double side = elements_[e].side, volume = fields.volume();
  double in_band = 0, size = 0;
  for (const auto& point : fields.band) in_band += point.weight;
  for (std::size_t t = 0; t < energy_->terms().size(); ++t) {
    const auto& [term, own, material] = energy_->terms()[t];
    if (!(weights[t] > 0)) continue;
    const auto* band = std::get_if<BandCode<Dim>>(&term.code);
    const double stress = weights[t] * term.modulus(material) * (band ? in_band : volume);
    size += band && !band->reads_dphi ? stress : stress / side;
  }
  for_each_pair_term(weights, [&](const PairTerm<Dim>& pairs, double weight) {
    for (const LocatedPair<Dim>& pair : pairs.pairs_of(e, e + 1)) size += 2 * weight * pair.weight;
  });
  return size;
}

template class ElementOracle<2>;
template class ElementOracle<3>;

}  // namespace shellmatch
