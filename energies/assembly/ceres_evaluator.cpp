#include "energies/assembly/ceres_evaluator.h"

#include "energies/cost/pair_cost.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <variant>

namespace shellmatch {

// Scratch of this thread, valid until its next call.
template <int Dim>
ElementFields<Dim>& CeresEvaluator<Dim>::fields_of(std::size_t e) const {
  static thread_local ElementFields<Dim> fields;
  fields.assign(energy_->elements()[e], energy_->band(), energy_->band().lane_of(e), energy_->target(),
                energy_->shape());
  return fields;
}

template <int Dim>
ElementFields<Dim>& CeresEvaluator<Dim>::fields_of(std::size_t t, std::size_t e) const {
  ElementFields<Dim>& fields = fields_of(e);
  fields.read_own(energy_->terms()[t].own_fields, energy_->elements()[e], e);
  return fields;
}

template <int Dim>
bool CeresEvaluator<Dim>::add(const TermValues& weights, std::size_t e, const Dofs& dofs, double* values,
                              double* gradient) const {
  ElementFields<Dim>& fields = fields_of(e);
  bool is_possible = true;
  const auto add_cost = [&](std::size_t t, const ceres::CostFunction& cost) {
    const double* const parameters[] = {dofs.data()};
    double value;
    Dofs derivative;
    double* jacobians[] = {derivative.data()};
    if (cost.Evaluate(parameters, &value, gradient ? jacobians : nullptr)) {
      values[t] += value;
      for (int i = 0; gradient && i < n_dofs; ++i) gradient[i] += derivative[i];
    } else {
      is_possible = false;
    }
  };
  const auto& terms = energy_->terms();
  for (std::size_t t = 0; t < terms.size(); ++t) {
    if (!(weights[t] > 0)) continue;
    const auto& entry = terms[t];
    if (const auto* points = std::get_if<PointCode<Dim>>(&entry.term.code)) {
      if (!points->pairs.pairs_of(e, e + 1).empty()) add_cost(t, *pair_cost(points->pairs, e, weights[t]));
    } else {
      fields.read_own(entry.own_fields, energy_->elements()[e], e);
      add_cost(t, *entry.term.cost(fields, weights[t], entry.material));
    }
  }
  return is_possible;
}

template <int Dim>
double CeresEvaluator<Dim>::value(const TermValues& weights, std::size_t e, const Dofs& dofs) const {
  TermValues values(weights.size());
  return add(weights, e, dofs, &values[0], nullptr) ? values.sum() : std::numeric_limits<double>::quiet_NaN();
}

template <int Dim>
double CeresEvaluator<Dim>::gradient(const TermValues& weights, std::size_t e, const Dofs& dofs, Dofs& gradient) const {
  TermValues values(weights.size());
  gradient.fill(0.0);
  return add(weights, e, dofs, &values[0], gradient.data()) ? values.sum() : std::numeric_limits<double>::quiet_NaN();
}

template <int Dim>
std::optional<double> CeresEvaluator<Dim>::gradient_at_point(std::size_t t, double weight, std::size_t e,
                                                             const Dofs& dofs, std::size_t q, Dofs& gradient) const {
  const auto& entry = energy_->terms()[t];
  const CompiledTerm<Dim>& term = entry.term;
  if (std::holds_alternative<CornerCode<Dim>>(term.code) || std::holds_alternative<PointCode<Dim>>(term.code))
    return std::nullopt;
  // The element with this point alone.
  ElementFields<Dim> fields = fields_of(t, e);
  const bool is_of_band = std::holds_alternative<BandCode<Dim>>(term.code);
  if (is_of_band && (fields.band.empty() || !(fields.band[q].weight > 0))) return std::nullopt;
  ShapeTable<Dim> one = *fields.shape;
  one.points = {fields.shape->points[q]};
  fields.shape = &one;
  if (!fields.band.empty()) fields.band = {fields.band[q]};
  const auto n = static_cast<std::size_t>(entry.own_fields.n_components());
  fields.own = {fields.own.begin() + static_cast<std::ptrdiff_t>(q * n),
                fields.own.begin() + static_cast<std::ptrdiff_t>((q + 1) * n)};
  const double* const parameters[] = {dofs.data()};
  double* jacobians[] = {gradient.data()};
  double value;
  return term.cost(fields, weight, entry.material)->Evaluate(parameters, &value, jacobians)
             ? value
             : std::numeric_limits<double>::quiet_NaN();
}

template <int Dim>
std::vector<int> CeresEvaluator<Dim>::band_points(std::size_t e) const {
  std::vector<int> points;
  const auto& band = fields_of(e).band;
  for (std::size_t q = 0; q < band.size(); ++q)
    if (band[q].weight > 0) points.push_back(static_cast<int>(q));
  return points;
}

template <int Dim>
typename CeresEvaluator<Dim>::Dofs CeresEvaluator<Dim>::dofs_of(std::size_t e, std::span<const Vec<Dim>> phi) const {
  Dofs dofs;
  for (int i = 0; i < n_dofs; ++i) dofs[i] = phi[energy_->elements()[e].nodes[i / Dim]][i % Dim];
  return dofs;
}

template <int Dim>
Vec<Dim> CeresEvaluator<Dim>::position(const Dofs& dofs, int point) const {
  const auto& q = energy_->shape().points[point];
  Vec<Dim> y = Vec<Dim>::Zero();
  for (int i = 0; i < n_dofs; ++i) y[i % Dim] += q.n[i / Dim] * dofs[i];
  return y;
}

template <int Dim>
double CeresEvaluator<Dim>::natural_size(const TermValues& weights, std::size_t e) const {
  const ElementFields<Dim>& fields = fields_of(e);
  const double side = energy_->elements()[e].side, volume = fields.volume();
  double in_band = 0, size = 0;
  for (const auto& point : fields.band) in_band += point.weight;
  for (std::size_t t = 0; t < energy_->terms().size(); ++t) {
    const CompiledTerm<Dim>& term = energy_->terms()[t].term;
    if (!(weights[t] > 0)) continue;
    if (const auto* points = std::get_if<PointCode<Dim>>(&term.code)) {
      for (const LocatedPair<Dim>& pair : points->pairs.pairs_of(e, e + 1)) size += 2 * weights[t] * pair.weight;
      continue;
    }
    const auto* band = std::get_if<BandCode<Dim>>(&term.code);
    const double stress = weights[t] * term.modulus(energy_->terms()[t].material) * (band ? in_band : volume);
    const auto* cells = std::get_if<CellCode<Dim>>(&term.code);
    const bool reads_dphi = band ? band->reads_dphi : !cells || cells->reads_dphi;
    size += reads_dphi ? stress / side : stress;
  }
  return size;
}

template <int Dim>
template <bool WithGradient>
void MatchingEnergy<Dim>::add_costs(const Chunk& cells, std::span<const Vec<Dim>> phi, const TermValues& weights,
                                    double* values, double* gradients) const {
  const CeresEvaluator<Dim> costs(*this);
  constexpr int n = CeresEvaluator<Dim>::n_dofs;
  if constexpr (WithGradient) std::fill_n(gradients, (cells.end - cells.begin) * n, 0.0);
  for (std::size_t e = cells.begin; e < cells.end; ++e) {
    if (costs.add(weights, e, costs.dofs_of(e, phi), values,
                  WithGradient ? gradients + (e - cells.begin) * n : nullptr))
      continue;
    values[0] = std::numeric_limits<double>::quiet_NaN();
    return;
  }
}

template class CeresEvaluator<2>;
template class CeresEvaluator<3>;
#define SHELLMATCH_INSTANTIATE(Dim, WithGradient)                                                     \
  template void MatchingEnergy<Dim>::add_costs<WithGradient>(const Chunk&, std::span<const Vec<Dim>>, \
                                                             const TermValues&, double*, double*) const;
SHELLMATCH_INSTANTIATE(2, false)
SHELLMATCH_INSTANTIATE(2, true)
SHELLMATCH_INSTANTIATE(3, false)
SHELLMATCH_INSTANTIATE(3, true)
#undef SHELLMATCH_INSTANTIATE

}  // namespace shellmatch
