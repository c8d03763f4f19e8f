#pragma once
/// \file
/// Each energy term as a cost functor of Ceres on element-local degrees of freedom: the positions of the element's
/// corners, corner after corner, Dim components each (24 numbers in space). Ceres' automatic differentiation and gradient
/// checker take it as it is; the compiled assembly is tested against it.

#include "energies/cost/cost_function.h"
#include "energies/cost/element_fields.h"
#include "energies/autodiff/jet.h"
#include "energies/terms/term_functors.h"

#include <ceres/autodiff_cost_function.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace shellmatch {

/// phi and Dphi at a quadrature point from the element's degrees of freedom.
template <int Dim, class T>
void deformation_at(const T* dofs, const typename ShapeTable<Dim>::Point& q, double side, SmallVec<T, Dim>& y,
                    SmallMat<T, Dim>& dphi) {
  for (int k = 0; k < Dim; ++k) {
    y[k] = T(0.0);
    for (int j = 0; j < Dim; ++j) dphi(k, j) = T(0.0);
    for (int c = 0; c < n_corners<Dim>; ++c) {
      y[k] += q.n[c] * dofs[c * Dim + k];
      for (int j = 0; j < Dim; ++j) dphi(k, j) += (q.dn[c][j] / side) * dofs[c * Dim + k];
    }
  }
}

/// The energy of one term on one element, over any scalar.
template <class Term, class T>
T element_energy(const ElementFields<Term::dim>& element, const T* dofs, double weight, const Material<double>& material) {
  constexpr int dim = Term::dim;
  T energy(0.0);
  SmallVec<T, dim> y;
  SmallMat<T, dim> dphi;
  if constexpr (IsBandTerm<Term>) {
    for (std::size_t q = 0; q < element.band.size(); ++q) {
      const double w = element.band[q].weight * weight;
      if (!(w > 0)) continue;
      deformation_at<dim>(dofs, element.shape->points[q], element.side, y, dphi);
      energy += w * band_density<Term, T, double>(element.target->template at<T>(y), dphi, element.band[q].reference, material);
    }
  } else if constexpr (IsCellTerm<Term>) {
    const double volume = weight * element.volume();
    for (const auto& q : element.shape->points) {
      deformation_at<dim>(dofs, q, element.side, y, dphi);
      energy += volume * q.weight * Term::Density::template value<T, double>(dphi, material);
    }
  } else {
    std::array<double, 3 + Term::own.size()> passive{Term::scale(1 / element.side, material), material.lambda, material.mu};
    std::copy_n(material.own, Term::own.size(), passive.begin() + 3);
    energy = weight * element.volume() * CornerFunctor<Term>::template evaluate<T, double>(dofs, passive.data());
  }
  return energy;
}

/// The same as a functor of Ceres; `Term` is one of energies/terms, for instance Membrane<3>.
template <class Term>
class ElementCost {
 public:
  static constexpr int n_dofs = n_corners<Term::dim> * Term::dim;

  /// \param own  values of the term's own options, in its order
  ElementCost(ElementFields<Term::dim> element, double weight, double lambda, double mu,
              std::array<double, Term::own.size()> own = {})
      : element_(std::move(element)), weight_(weight), lambda_(lambda), mu_(mu), own_(own) {}

  /// False where the term cannot be evaluated.
  template <class T>
  bool operator()(const T* dofs, T* energy) const {
    *energy = element_energy<Term>(element_, dofs, weight_, Material<double>{lambda_, mu_, own_.data()});
    return std::isfinite(autodiff::scalar_part(*energy));
  }

 private:
  ElementFields<Term::dim> element_;
  double weight_, lambda_, mu_;
  std::array<double, Term::own.size()> own_;
};

/// It has a copy of its arguments, except for the shape table and the target's field, which must outlive it.
template <class Term>
ElementCostFunction element_cost_function(const ElementFields<Term::dim>& element, double weight, const Material<double>& material) {
  using Cost = ElementCost<Term>;
  std::array<double, Term::own.size()> own{};
  std::copy_n(material.own, own.size(), own.begin());
  return std::make_unique<ceres::AutoDiffCostFunction<Cost, 1, Cost::n_dofs>>(
      new Cost(element, weight, material.lambda, material.mu, own));
}

}  // namespace shellmatch
