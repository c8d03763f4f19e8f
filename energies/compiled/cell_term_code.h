#pragma once
/// \file
/// The compiled code of the terms that every cell has, on eight cells at a time.

#include "energies/compiled/compiled_term.h"
#include "energies/autodiff/compiled.h"
#include "energies/autodiff/jet.h"
#include "energies/autodiff/second_order.h"
#include "energies/cost/element_cost.h"
#include "energies/densities/positive_hessian.h"
#include "energies/terms/term_functors.h"

#include <algorithm>
#include <array>

namespace shellmatch::detail {

using autodiff::Pack;

/// lambda, mu and the term's own options, `before` other passive inputs.
template <class Functor, class Term>
std::array<Pack, Functor::n_passive> material_inputs(const Material<double>& c, std::size_t before = 0) {
  std::array<Pack, Functor::n_passive> passive{};
  passive[before] = Pack{} + c.lambda;
  passive[before + 1] = Pack{} + c.mu;
  for (std::size_t i = 0; i < Term::own.size(); ++i) passive[before + 2 + i] = Pack{} + c.own[i];
  return passive;
}

template <class Term, bool WithGradient>
Pack apply_cell_term(CellBatch<Term::dim>& batch, const ShapeTable<Term::dim>& shape, const Material<double>& material,
                     const Pack& measure) {
  using Functor = PointFunctor<Term>;
  using Code = autodiff::Compiled<Functor>;
  constexpr int dim = Term::dim, n_dphi = dim * dim;
  auto passive = material_inputs<Functor, Term>(material);
  std::array<Pack, Functor::n_active> active, adjoint;
  Pack sum{};
  batch.evaluator.evaluate(batch.elements);
  if constexpr (WithGradient) batch.evaluator.clear_adjoint();
  for (std::size_t q = 0; q < shape.points.size(); ++q) {
    batch.evaluator.jacobian(q, active.data());
    if constexpr (Functor::reads_phi)
      for (int k = 0; k < dim; ++k) {
        active[n_dphi + k] = Pack{};
        for (int c = 0; c < n_corners<dim>; ++c)
          active[n_dphi + k] += shape.points[q].n[c] * batch.elements.u[c * dim + k];
      }
    if constexpr (Functor::n_own_fields > 0)
      batch.own_fields->read(
          batch.all, [&](int lane) { return batch.number[lane]; }, shape, q, passive.data() + 2 + Functor::n_own);
    const Pack seed = measure * shape.points[q].weight;
    if constexpr (WithGradient) {
      sum += seed * Code::gradient(active.data(), passive.data(), seed, adjoint.data());
      batch.evaluator.add_by_jacobian(q, adjoint.data());
      if constexpr (Functor::reads_phi)
        for (int c = 0; c < n_corners<dim>; ++c)
          for (int k = 0; k < dim; ++k)
            batch.elements.gradient[c * dim + k] += shape.points[q].n[c] * adjoint[n_dphi + k];
    } else {
      sum += seed * Code::value(active.data(), passive.data());
    }
  }
  if constexpr (WithGradient) batch.evaluator.add_to_gradient(batch.elements);
  return sum;
}

template <class Term>
void add_cell_hessian(const ElementFields<Term::dim>& element, const double* dofs, double weight,
                      const Material<double>& material, ElementHessian<Term::dim>& h) {
  using Density = typename Term::Density;
  constexpr int n_dofs = n_corners<Term::dim> * Term::dim, n = n_arguments_of<Density>;
  using Jet = ceres::Jet<double, n_dofs>;
  std::array<Jet, n_dofs> jets;
  for (int i = 0; i < n_dofs; ++i) jets[i] = Jet(dofs[i], i);
  std::array<double, Term::own.size()> own{};
  std::copy_n(material.own, own.size(), own.begin());
  const ElementPoints<Term> points(element, weight, material.lambda, material.mu, own);
  points.for_each(jets.data(), [&](std::size_t, double of_point, const auto& at) {
    const auto argument = argument_at<Term>(at);
    typename Density::template Argument<Pack> a;
    for (int i = 0; i < n; ++i) a.v[i] = Pack{} + argument.v[i].a;
    const auto w = positive_hessian<Density>(a, material);
    for (int i = 0; i < n; ++i)
      for (int j = 0; j < n; ++j)
        if (w[i][j][0] != 0) h.noalias() += (of_point * w[i][j][0] * argument.v[i].v) * argument.v[j].v.transpose();
  });
}

template <class Term>
CellCode<Term::dim> cell_code() {
  constexpr bool is_dphi = autodiff::Compiled<PointArgument<Term>>::copies_inputs();
  CellCode<Term::dim> code{.value = apply_cell_term<Term, false>,
                           .gradient = apply_cell_term<Term, true>,
                           .reads_dphi = Term::Reads::template has<Dphi>,
                           .hessian = nullptr,
                           .add_hessian = nullptr};
  if constexpr (is_dphi) code.hessian = positive_hessian<typename Term::Density>;
  else code.add_hessian = add_cell_hessian<Term>;
  return code;
}

template <class Term, bool WithGradient>
Pack apply_corner_term(CellBatch<Term::dim>& batch, const ShapeTable<Term::dim>&, const Material<double>& material,
                       const Pack& measure) {
  using Code = autodiff::Compiled<CornerFunctor<Term>>;
  ElementBatch<Term::dim>& elements = batch.elements;
  if (autodiff::sum_lanes(Term::may_act(elements, material)) == 0) return Pack{};
  auto passive = material_inputs<CornerFunctor<Term>, Term>(material, 1);
  passive[0] = Term::scale(elements.inverse_side, material);
  if constexpr (WithGradient) {
    std::array<Pack, ElementBatch<Term::dim>::n_dofs> adjoint;
    const Pack value = Code::gradient(elements.u.data(), passive.data(), measure, adjoint.data());
    for (std::size_t i = 0; i < adjoint.size(); ++i) elements.gradient[i] += adjoint[i];
    return value * measure;
  } else {
    return Code::value(elements.u.data(), passive.data()) * measure;
  }
}

/// The argument of a corner term with its derivative by the corners' positions.
template <class Term>
[[gnu::noinline]] auto corner_argument(const double* dofs, double scale) {
  using Jet = ceres::Jet<double, n_corners<Term::dim> * Term::dim>;
  std::array<Jet, n_corners<Term::dim> * Term::dim> jets;
  for (std::size_t i = 0; i < jets.size(); ++i) jets[i] = Jet(dofs[i], static_cast<int>(i));
  return Term{}(jets.data(), scale);
}

template <class Term>
void add_corner_hessian(const double* dofs, double side, double weight, const Material<double>& material,
                        ElementHessian<Term::dim>& h) {
  using Scalar = autodiff::SecondOrder<1, double>;
  double volume = 1;
  for (int k = 0; k < Term::dim; ++k) volume *= side;
  for (const auto& x : corner_argument<Term>(dofs, Term::scale(1 / side, material))) {
    const double curvature = Term::Density::template value<Scalar, double>(Scalar::variable(x.a, 0), material).h(0, 0);
    if (curvature > 0) h.noalias() += (weight * volume / Term::n_arguments * curvature * x.v) * x.v.transpose();
  }
}

template <class Term>
CornerCode<Term::dim> corner_code() {
  return {.value = apply_corner_term<Term, false>,
          .gradient = apply_corner_term<Term, true>,
          .may_act = Term::may_act,
          .add_hessian = add_corner_hessian<Term>};
}

}  // namespace shellmatch::detail
