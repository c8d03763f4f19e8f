// Assembly of the terms on the band, eight quadrature points at a time: the innermost loop of the program.

#include "energies/assembly/matching_energy.h"
#include "energies/elements/sum_factorised_evaluator.h"

#include <algorithm>
#include <variant>
#include <vector>

namespace shellmatch {

namespace {

using autodiff::Pack;
using autodiff::pack_size;

/// Sets the functors' active arguments, the template's coefficients and Dphi, at eight points. Lanes of weight 0 get
/// harmless values instead of a possible NaN.
template <int Dim, bool WithGradient>
void look_up(const GeometryField<Dim>& target, const Pack& weight,
             const typename GeometryField<Dim>::LocatedPoints& located, const SumFactorisedEvaluator<Dim>& evaluator,
             std::size_t q, PointArrays<Dim>& p) {
  if constexpr (WithGradient) target.look_up(weight, located, p.active.data(), p.derivative);
  else target.look_up(weight, located, p.active.data());
  Pack* dphi = p.active.data() + PointArrays<Dim>::n_target;
  evaluator.jacobian(q, dphi);
  for (int i = 0; i < Dim; ++i)
    for (int j = 0; j < Dim; ++j) {
      Pack& entry = dphi[i * Dim + j];
      entry = autodiff::where_greater(weight, Pack{}, entry, Pack{} + (i == j ? 1.0 : 0.0));
    }
}

}  // namespace

template <int Dim>
template <bool WithGradient>
void MatchingEnergy<Dim>::add_band_terms(const Chunk& cells, std::span<const Vec<Dim>> phi, const TermValues& weights,
                                         double* values, double* gradients, BandSums* band_sums) const {
  constexpr int n_target = PointArrays<Dim>::n_target, n_reference = PointArrays<Dim>::n_reference;
  constexpr int n_without_phi = PointArrays<Dim>::n_without_phi;
  struct Acting {
    Pack (*apply)(PointArrays<Dim>& p, const Pack& seed, const double* own);
    const double* own;
    const UserFields<Dim>* own_fields;  ///< null where it has none
    double weight, *value;
    Pack sum{};
  };
  std::vector<Acting> acting;
  bool reads_phi = false;
  int n_own_fields = 0;
  for (std::size_t t = 0; t < terms_->size(); ++t)
    if (const auto* code = std::get_if<BandCode<Dim>>(&(*terms_)[t].term.code); code && weights[t] > 0) {
      const auto& fields = (*terms_)[t].own_fields;
      acting.push_back({WithGradient ? code->gradient : code->value, (*terms_)[t].own.data(),
                        fields.empty() ? nullptr : &fields, weights[t], values + t});
      reads_phi = reads_phi || code->reads_phi;
      n_own_fields = std::max(n_own_fields, fields.n_components());
    }
  if (!band_sums && acting.empty()) return;
  const auto elements = elements_;
  const auto batches = band_.batches();
  const Material<double>& material = (*terms_)[0].material;

  ElementBatch<Dim> batch;
  SumFactorisedEvaluator<Dim> evaluator(shape_);
  PointArrays<Dim> p;
  std::vector<Pack> own_fields(static_cast<std::size_t>(n_own_fields));
  p.own_fields = own_fields.data();
  p.passive[n_reference] = Pack{} + material.lambda;
  p.passive[n_reference + 1] = Pack{} + material.mu;
  const auto [first, last] = band_.batches_of(cells.index);
  for (std::size_t b = first; b < last; ++b) {
    batch.load(elements, phi, [&](int lane) { return batches[b].element[lane]; });
    evaluator.evaluate(batch);
    if constexpr (WithGradient) evaluator.clear_adjoint();
    if (b + 1 < last) batch.prefetch(elements, phi, [&](int lane) { return batches[b + 1].element[lane]; });
    auto next = target_->find(evaluator.position(0));
    for (std::size_t q = 0; q < shape_.points.size(); ++q) {
      const auto& point = band_.point(b, q);
      band_.prefetch_after(b, q);
      const auto located = next;  // located one point ahead, so that prefetched data arrive in time
      if (q + 1 < shape_.points.size()) next = target_->find(evaluator.position(q + 1));
      if (autodiff::sum_lanes(point.weight) == 0) continue;
      look_up<Dim, WithGradient>(*target_, point.weight, located, evaluator, q, p);
      for (int i = 0; i < n_reference; ++i) p.passive[i] = point.reference(i);
      if (band_sums)
        band_sums->add<Dim>(point.weight, p.passive.data() + 1, p.active.data() + 1, p.active.data() + n_target);
      if (reads_phi) std::ranges::copy(evaluator.position(q), p.active.begin() + n_without_phi);
      if constexpr (WithGradient) {
        std::fill_n(p.adjoint.begin(), n_without_phi, Pack{});
        if (reads_phi) std::fill_n(p.adjoint.begin() + n_without_phi, Dim, Pack{});
      }
      for (Acting& term : acting) {
        if (term.own_fields)
          term.own_fields->read(
              elements, [&](int lane) { return batches[b].element[lane]; }, shape_, q, own_fields.data());
        term.sum += term.apply(p, point.weight * term.weight, term.own);
      }
      if constexpr (WithGradient) {
        std::array<Pack, Dim> by_position;
        for (int k = 0; k < Dim; ++k) {
          by_position[k] = p.adjoint[0] * p.derivative[k][0];
          for (int i = 1; i < n_target; ++i) by_position[k] += p.adjoint[i] * p.derivative[k][i];
          if (reads_phi) by_position[k] += p.adjoint[n_without_phi + k];
        }
        evaluator.add_by_position(q, by_position);
        evaluator.add_by_jacobian(q, p.adjoint.data() + n_target);
      }
    }
    if constexpr (WithGradient) {
      batch.clear_gradient();
      evaluator.add_to_gradient(batch);
      batch.add_gradients(batches[b].n_elements, [&](int lane) {
        return gradients + (static_cast<std::size_t>(batches[b].element[lane]) - cells.begin) * batch.n_dofs;
      });
    }
  }
  for (const Acting& term : acting) *term.value += autodiff::sum_lanes(term.sum);
}

template void MatchingEnergy<2>::add_band_terms<true>(const Chunk&, std::span<const Vec<2>>, const TermValues&, double*,
                                                      double*, BandSums*) const;
template void MatchingEnergy<2>::add_band_terms<false>(const Chunk&, std::span<const Vec<2>>, const TermValues&,
                                                       double*, double*, BandSums*) const;
template void MatchingEnergy<3>::add_band_terms<true>(const Chunk&, std::span<const Vec<3>>, const TermValues&, double*,
                                                      double*, BandSums*) const;
template void MatchingEnergy<3>::add_band_terms<false>(const Chunk&, std::span<const Vec<3>>, const TermValues&,
                                                       double*, double*, BandSums*) const;

}  // namespace shellmatch
