// Finds the term, the element and the point that make Newton's model infinite or NaN.

#include "base/parallel.h"
#include "energies/hessian/band_variables.h"
#include "energies/hessian/energy_hessian.h"
#include "energies/elements/sum_factorised_evaluator.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <variant>
#include <vector>

namespace shellmatch {

namespace {

/// Of the matrix of element e; its padding holds anything.
template <int Dim>
bool is_finite(const ElementMatrices<Dim>& matrices, std::size_t e) {
  using Matrices = ElementMatrices<Dim>;
  for (int i = 0; i < Matrices::n_dofs; ++i)
    for (int j = i; j < Matrices::n_dofs; ++j)
      if (!std::isfinite(matrices[e][Matrices::entry(i, j)])) return false;
  return true;
}

}  // namespace

template <int Dim>
std::optional<NotFinite<Dim>> EnergyHessian<Dim>::find_not_finite(std::span<const Vec<Dim>> phi,
                                                                  const TermValues& weights) const {
  const auto elements = unknowns_->elements();
  constexpr std::size_t none = std::numeric_limits<std::size_t>::max();
  for (std::size_t t = 0; t < weights.size(); ++t) {
    if (!(weights[t] > 0)) continue;
    TermValues alone(weights.size());
    alone[t] = weights[t];
    const std::size_t of_block = cells_per_block(elements.size());
    std::vector<std::size_t> first(n_chunks(elements.size(), of_block), none);
    energy_->cell_blocks().for_each([&](const Chunk& cells) {
      ElementMatrices<Dim> matrices;
      matrices.resize(cells.end - cells.begin);
      set_cell_terms(cells, phi, alone, matrices);
      add_corner_terms(cells, phi, alone, matrices);
      if (energy_->terms().fit_tangent(weights)) add_band_terms<TangentVariables<Dim>>(cells, phi, alone, matrices);
      else add_band_terms<AllVariables<Dim>>(cells, phi, alone, matrices);
      add_point_terms(cells, phi, alone, matrices);
      for (std::size_t e = cells.begin; e < cells.end && first[cells.index] == none; ++e)
        if (!is_finite(matrices, e - cells.begin)) first[cells.index] = e;
    });
    if (const std::size_t e = *std::ranges::min_element(first); e != none)
      return NotFinite<Dim>{"Newton model",   energy_->term_names()[t], e,
                            elements[e].side, elements[e].corner,       model_point(t, e, phi)};
  }
  return std::nullopt;
}

// The quadrature point of element e where the model of a term on the band is largest, or not finite; the centre for a
// term on cells.
template <int Dim>
std::optional<Vec<Dim>> EnergyHessian<Dim>::model_point(std::size_t t, std::size_t e,
                                                        std::span<const Vec<Dim>> phi) const {
  using Arrays = PointArrays<Dim>;
  const EnergyTerms<Dim>& terms = energy_->terms();
  const Element<Dim>& element = unknowns_->elements()[e];
  if (std::holds_alternative<CornerCode<Dim>>(terms[t].term.code) ||
      std::holds_alternative<PointCode<Dim>>(terms[t].term.code))
    return std::nullopt;
  const auto* code = std::get_if<BandCode<Dim>>(&terms[t].term.code);
  if (code == nullptr) return Vec<Dim>(element.corner + Vec<Dim>::Constant(element.side / 2));
  const Band<Dim>& band = energy_->band();
  const auto batches = band.batches();
  std::optional<Vec<Dim>> place;
  for (std::size_t b = 0; b < batches.size(); ++b) {
    const auto& members = batches[b].element;
    const auto lane = std::ranges::find(members, static_cast<Index>(e)) - members.begin();
    if (lane >= batches[b].n_elements) continue;
    ElementBatch<Dim> batch;
    batch.load(unknowns_->elements(), phi, [&](int l) { return static_cast<std::size_t>(members[l]); });
    SumFactorisedEvaluator<Dim> evaluator(energy_->shape());
    evaluator.evaluate(batch);
    double largest = -1;
    for (std::size_t q = 0; q < energy_->shape().points.size(); ++q) {
      const auto& point = band.point(b, q);
      if (!(point.weight[lane] > 0)) continue;
      Arrays p;
      std::vector<autodiff::Pack> own_fields(static_cast<std::size_t>(terms[t].own_fields.n_components()));
      terms[t].own_fields.read(
          unknowns_->elements(), [&](int l) { return members[l]; }, energy_->shape(), q, own_fields.data());
      p.own_fields = own_fields.data();
      p.passive[Arrays::n_reference] = autodiff::Pack{} + terms[0].material.lambda;
      p.passive[Arrays::n_reference + 1] = autodiff::Pack{} + terms[0].material.mu;
      const auto position = evaluator.position(q);
      energy_->target().look_up(point.weight, energy_->target().find(position), p.active.data(), p.derivative);
      std::ranges::copy(position, p.active.begin() + Arrays::n_without_phi);
      evaluator.jacobian(q, p.active.data() + Arrays::n_target);
      for (int i = 0; i < Arrays::n_reference; ++i) p.passive[i] = point.reference(i);
      const TangentBasis<Dim> unused{};
      SquarePack<BandModelPoint<Dim>::n_all> h{};
      const BandModelPoint<Dim> at{p, point.weight, unused, unused};
      code->add_in_all(at, 1.0, terms[t].own.data(), h);
      double size = 0;
      for (std::size_t i = 0; i < h.size(); ++i)
        for (std::size_t j = 0; j <= i; ++j)
          size = std::isfinite(h[i][j][lane]) ? std::max(size, std::abs(h[i][j][lane]))
                                              : std::numeric_limits<double>::infinity();
      if (size > largest) {
        largest = size;
        place = element.corner + element.side * energy_->shape().points[q].xi;
      }
    }
  }
  return place;
}

template std::optional<NotFinite<2>> EnergyHessian<2>::find_not_finite(std::span<const Vec<2>>,
                                                                       const TermValues&) const;
template std::optional<NotFinite<3>> EnergyHessian<3>::find_not_finite(std::span<const Vec<3>>,
                                                                       const TermValues&) const;
template std::optional<Vec<2>> EnergyHessian<2>::model_point(std::size_t, std::size_t, std::span<const Vec<2>>) const;
template std::optional<Vec<3>> EnergyHessian<3>::model_point(std::size_t, std::size_t, std::span<const Vec<3>>) const;

}  // namespace shellmatch
