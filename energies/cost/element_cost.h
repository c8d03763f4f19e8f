#pragma once
/// \file
/// Each energy term as a cost functor of Ceres on element-local degrees of freedom: the positions of the element's
/// corners, corner after corner, Dim components each (24 numbers in space). Ceres' automatic differentiation and
/// gradient checker take it as it is; with `energy.evaluator: ceres` the whole energy is evaluated by it.

#include "energies/autodiff/jet.h"
#include "energies/cost/cost_function.h"
#include "energies/cost/element_fields.h"
#include "energies/densities/material.h"
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

/// One element with what a term reads there, and the term's weight. It refers to the shape table and the target's
/// field.
template <class Term>
class ElementPoints {
 public:
  static constexpr int dim = Term::dim, n_dofs = n_corners<dim> * dim;

  /// \param own  values of the term's own options, in its order
  ElementPoints(ElementFields<dim> element, double weight, double lambda, double mu,
                std::array<double, Term::own.size()> own = {})
      : element_(std::move(element)), weight_(weight), lambda_(lambda), mu_(mu), own_(own) {}

  const ElementFields<dim>& element() const { return element_; }
  double weight() const { return weight_; }
  Material<double> material() const { return {lambda_, mu_, own_.data()}; }

  /// Calls body(q, weight, point) for the quadrature points where the term acts; `weight` is that of the point in the
  /// energy.
  template <class T, class Body>
  void for_each(const T* dofs, Body&& body) const {
    PointValues<dim, T, double> at;
    at.material = material();
    const bool is_band = IsBandTerm<Term>;
    const std::size_t n = is_band ? element_.band.size() : element_.shape->points.size();
    for (std::size_t q = 0; q < n; ++q) {
      const auto& point = element_.shape->points[q];
      const double weight = weight_ * (is_band ? element_.band[q].weight : element_.volume() * point.weight);
      if (!(weight > 0)) continue;
      deformation_at<dim>(dofs, point, element_.side, at.phi, at.dphi);
      if constexpr (is_band) {
        at.y = element_.target->template at<T>(at.phi);
        at.x = element_.band[q].reference;
      }
      at.own_fields = element_.own.data() + q * static_cast<std::size_t>(Term::Reads::n_own);
      body(q, weight, at);
    }
  }

 private:
  ElementFields<dim> element_;
  double weight_, lambda_, mu_;
  std::array<double, Term::own.size()> own_;
};

/// The weighted energy of a term on one element; `Term` is one of energies/terms, for instance Membrane<3>.
template <class Term>
struct ElementCost : ElementPoints<Term> {
  using ElementPoints<Term>::ElementPoints;

  /// False where the term cannot be evaluated.
  template <class T>
  bool operator()(const T* dofs, T* energy) const {
    *energy = T(0.0);
    if constexpr (IsCornerTerm<Term>) {
      const auto c = this->material();
      std::array<double, 3 + Term::own.size()> passive{Term::scale(1 / this->element().side, c), c.lambda, c.mu};
      std::copy_n(c.own, Term::own.size(), passive.begin() + 3);
      *energy = this->weight() * this->element().volume() *
                CornerFunctor<Term>::template evaluate<T, double>(dofs, passive.data());
    } else {
      this->for_each(dofs, [&](std::size_t, double weight, const auto& at) {
        *energy += weight * Term::Density::template value<T, double>(argument_at<Term>(at), at.material);
      });
    }
    return std::isfinite(autodiff::scalar_part(*energy));
  }
};

/// Is W the square of A?
template <class Term>
inline constexpr bool is_square = false;
template <class Term>
requires requires { typename Term::Density::template Argument<double>; }
inline constexpr bool is_square<Term> =
    std::is_same_v<typename Term::Density, SquareDensity<n_arguments_of<typename Term::Density>>>;

/// The residuals of a term that is a square, as many as A has entries for each quadrature point of the element: half of
/// the sum of their squares, as Ceres has it, is ElementCost.
template <class Term>
struct ElementResiduals : ElementPoints<Term> {
  static_assert(is_square<Term>);
  using ElementPoints<Term>::ElementPoints;
  static constexpr int n_of_point = n_arguments_of<typename Term::Density>;

  int size() const { return n_of_point * static_cast<int>(this->element().shape->points.size()); }

  template <class T>
  bool operator()(const T* dofs, T* residuals) const {
    std::fill_n(residuals, size(), T(0.0));
    bool is_possible = true;
    this->for_each(dofs, [&](std::size_t q, double weight, const auto& at) {
      const auto a = argument_at<Term>(at);
      for (int i = 0; i < n_of_point; ++i) {
        T& residual = residuals[static_cast<int>(q) * n_of_point + i];
        residual = std::sqrt(2 * weight) * a[i];
        is_possible = is_possible && std::isfinite(autodiff::scalar_part(residual));
      }
    });
    return is_possible;
  }
};

namespace detail {

template <class Functor, class Term>
Functor* new_functor(const ElementFields<Term::dim>& element, double weight, const Material<double>& material) {
  std::array<double, Term::own.size()> own{};
  std::copy_n(material.own, own.size(), own.begin());
  return new Functor(element, weight, material.lambda, material.mu, own);
}

}  // namespace detail

/// A cost function of the one value that ElementCost has, or of ElementResiduals. It has a copy of its arguments,
/// except for the shape table and the target's field, which must outlive it.
template <class Term>
ElementCostFunction element_cost_function(const ElementFields<Term::dim>& element, double weight,
                                          const Material<double>& material) {
  using Cost = ElementCost<Term>;
  return std::make_unique<ceres::AutoDiffCostFunction<Cost, 1, Cost::n_dofs>>(
      detail::new_functor<Cost, Term>(element, weight, material));
}
template <class Term>
ElementCostFunction element_residual_function(const ElementFields<Term::dim>& element, double weight,
                                              const Material<double>& material) {
  using Residuals = ElementResiduals<Term>;
  auto* functor = detail::new_functor<Residuals, Term>(element, weight, material);
  return std::make_unique<ceres::AutoDiffCostFunction<Residuals, ceres::DYNAMIC, Residuals::n_dofs>>(functor,
                                                                                                     functor->size());
}

}  // namespace shellmatch
