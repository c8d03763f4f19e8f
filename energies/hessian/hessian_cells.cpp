// Second derivatives of the terms that every cell has.

#include "energies/assembly/ceres_evaluator.h"
#include "energies/hessian/energy_hessian.h"

#include <algorithm>
#include <cmath>
#include <variant>

namespace shellmatch {

using autodiff::Pack;
using autodiff::pack_size;

namespace {

/// Integral over the unit cell of dN_c/dxi_a dN_d/dxi_b, entry [c * Dim + a][d * Dim + b].
template <int Dim>
std::array<std::array<double, n_corners<Dim> * Dim>, n_corners<Dim> * Dim> gradient_products() {
  std::array<std::array<double, n_corners<Dim> * Dim>, n_corners<Dim> * Dim> g{};
  for (const auto& q : ShapeTable<Dim>(2).points)  // exact: the integrand is of degree 2 in each variable
    for (int c = 0; c < n_corners<Dim>; ++c)
      for (int a = 0; a < Dim; ++a)
        for (int d = 0; d < n_corners<Dim>; ++d)
          for (int b = 0; b < Dim; ++b) g[c * Dim + a][d * Dim + b] += q.weight * q.dn[c][a] * q.dn[d][b];
  return g;
}

/// Dphi at the centres of elements.
template <int Dim>
SmallMat<Pack, Dim> centre_jacobian(const ElementBatch<Dim>& batch) {
  SmallMat<Pack, Dim> j;
  const Pack factor = batch.inverse_side / (1 << (Dim - 1));
  for (int c = 0; c < n_corners<Dim>; ++c)
    for (int k = 0; k < Dim; ++k)
      for (int i = 0; i < Dim; ++i) j(i, k) += (((c >> k) & 1) ? factor : -factor) * batch.u[c * Dim + i];
  return j;
}

}  // namespace

template <int Dim>
void EnergyHessian<Dim>::set_cell_terms(const Chunk& cells, std::span<const Vec<Dim>> phi, const TermValues& weights,
                                        ElementMatrices<Dim>& matrices) const {
  static const auto products = gradient_products<Dim>();
  const auto elements = unknowns_->elements().first(cells.end);
  const EnergyTerms<Dim>& terms = energy_->terms();
  ElementBatch<Dim> batch;
  std::array<Pack, ElementMatrices<Dim>::n_block_entries> k;
  for (std::size_t first = cells.begin; first < cells.end; first += pack_size) {
    const std::size_t n = batch.load_run(elements, phi, first);
    const SmallMat<Pack, Dim> dphi = centre_jacobian<Dim>(batch);
    Pack scale = Pack{} + 1.0;  // the gradients of the shape functions bring side^-2, the volume side^Dim
    for (int i = 2; i < Dim; ++i) scale *= batch.side;
    SquarePack<Dim * Dim> h{};
    for (std::size_t t = 0; t < terms.size(); ++t)
      if (const auto* code = std::get_if<CellCode<Dim>>(&terms[t].term.code); code && code->hessian && weights[t] > 0) {
        const auto of_term = code->hessian(dphi, terms[t].material);
        const Pack factor = weights[t] * scale;
        for (int i = 0; i < Dim * Dim; ++i)
          for (int j = 0; j < Dim * Dim; ++j) h[i][j] += factor * of_term[i][j];
      }
    auto* entry = k.data();
    for (int c = 0; c < n_corners<Dim>; ++c)
      for (int d = c; d < n_corners<Dim>; ++d)
        for (int column = 0; column < Dim; ++column)
          for (int row = 0; row < Dim; ++row) {
            Pack sum{};
            for (int p = 0; p < Dim; ++p)
              for (int q = 0; q < Dim; ++q)
                sum += products[c * Dim + p][d * Dim + q] * h[row * Dim + p][column * Dim + q];
            *entry++ = sum;
          }
    for (std::size_t lane = 0; lane < n; ++lane) {
      std::array<float, ElementMatrices<Dim>::n_block_entries> of_element;
      for (std::size_t i = 0; i < k.size(); ++i) of_element[i] = static_cast<float>(k[i][lane]);
      matrices.set(first - cells.begin + lane, of_element);
    }
  }
}

template <int Dim>
void EnergyHessian<Dim>::add_points_of(const CellCode<Dim>& code, std::size_t t, const Chunk& cells,
                                       std::span<const Vec<Dim>> phi, double weight,
                                       ElementMatrices<Dim>& matrices) const {
  const CeresEvaluator<Dim> costs(*energy_);
  for (std::size_t e = cells.begin; e < cells.end; ++e) {
    ElementHessian<Dim> h = ElementHessian<Dim>::Zero();
    code.add_hessian(costs.fields_of(t, e), costs.dofs_of(e, phi).data(), weight, energy_->terms()[t].material, h);
    for (int i = 0; i < n_dofs; ++i)
      for (int j = i; j < n_dofs; ++j) matrices.add(e - cells.begin, i, j, static_cast<float>(h(i, j)));
  }
}

template <int Dim>
void EnergyHessian<Dim>::add_corner_terms(const Chunk& cells, std::span<const Vec<Dim>> phi, const TermValues& weights,
                                          ElementMatrices<Dim>& matrices) const {
  const auto elements = unknowns_->elements().first(cells.end);
  const EnergyTerms<Dim>& terms = energy_->terms();
  for (std::size_t t = 0; t < terms.size(); ++t) {
    if (!(weights[t] > 0)) continue;
    if (const auto* of_cells = std::get_if<CellCode<Dim>>(&terms[t].term.code); of_cells && of_cells->add_hessian)
      add_points_of(*of_cells, t, cells, phi, weights[t], matrices);
    const auto* code = std::get_if<CornerCode<Dim>>(&terms[t].term.code);
    if (!code) continue;
    ElementBatch<Dim> batch;
    for (std::size_t first = cells.begin; first < cells.end; first += pack_size) {
      const int n = static_cast<int>(batch.load_run(elements, phi, first));
      const Pack acts = code->may_act(batch, terms[t].material);
      for (int lane = 0; lane < n; ++lane) {
        if (acts[lane] == 0) continue;
        const std::size_t e = first + static_cast<std::size_t>(lane);
        std::array<double, n_dofs> dofs;
        for (int i = 0; i < n_dofs; ++i) dofs[i] = batch.u[i][lane];
        ElementHessian<Dim> h = ElementHessian<Dim>::Zero();
        code->add_hessian(dofs.data(), elements[e].side, weights[t], terms[t].material, h);
        for (int i = 0; i < n_dofs; ++i)
          for (int j = i; j < n_dofs; ++j) matrices.add(e - cells.begin, i, j, static_cast<float>(h(i, j)));
      }
    }
  }
}

#define SHELLMATCH_INSTANTIATE(Dim)                                                                              \
  template void EnergyHessian<Dim>::set_cell_terms(const Chunk&, std::span<const Vec<Dim>>, const TermValues&,   \
                                                   ElementMatrices<Dim>&) const;                                 \
  template void EnergyHessian<Dim>::add_corner_terms(const Chunk&, std::span<const Vec<Dim>>, const TermValues&, \
                                                     ElementMatrices<Dim>&) const;
SHELLMATCH_INSTANTIATE(2)
SHELLMATCH_INSTANTIATE(3)
#undef SHELLMATCH_INSTANTIATE

}  // namespace shellmatch
