#pragma once
/// \file
/// The term of point pairs on one element as cost functions of Ceres.

#include "energies/cost/cost_function.h"
#include "energies/pairs/pair_term.h"

#include <ceres/autodiff_cost_function.h>
#include <ceres/loss_function.h>

#include <cmath>

namespace shellmatch {

/// In the convention of ElementCost (energies/cost/element_cost.h).
template <int Dim>
struct PairCost {
  const PairTerm<Dim>* pairs;
  std::size_t element;
  double weight;
  template <class T>
  bool operator()(const T* dofs, T* energy) const {
    *energy = pairs->element_value(element, dofs, weight);
    return true;
  }
};

/// `pairs` must outlive it.
template <int Dim>
ElementCostFunction pair_cost(const PairTerm<Dim>& pairs, std::size_t element, double weight) {
  return std::make_unique<ceres::AutoDiffCostFunction<PairCost<Dim>, 1, PairTerm<Dim>::n_dofs>>(
      new PairCost<Dim>{&pairs, element, weight});
}

/// The residual of one pair, sqrt(2 w) B (phi(p) - y), or by how much its length exceeds the tolerance.
template <int Dim>
struct PairResidual {
  LocatedPair<Dim> pair;
  double factor, tolerance;
  int size() const { return tolerance > 0 || !pair.normal.isZero(0) ? 1 : Dim; }
  template <class T>
  bool operator()(const T* dofs, T* residual) const {
    using std::sqrt;
    std::array<T, Dim> gap;
    T square(0.0), along(0.0);
    for (int k = 0; k < Dim; ++k) {
      gap[k] = T(-pair.y[k]);
      for (int c = 0; c < n_corners<Dim>; ++c) gap[k] += pair.n[c] * dofs[c * Dim + k];
      square += gap[k] * gap[k];
      along += pair.normal[k] * gap[k];
    }
    const bool in_plane = !pair.normal.isZero(0);
    if (tolerance > 0) {
      const T counted = in_plane ? along * along : square;
      *residual = counted > tolerance * tolerance ? factor * (sqrt(counted) - tolerance) : T(0.0);
    } else if (in_plane) {
      *residual = factor * along;
    } else {
      for (int k = 0; k < Dim; ++k) residual[k] = factor * gap[k];
    }
    return true;
  }
};

/// A residual and its loss; the latter is null for the trivial one.
struct PairResidualBlock {
  ElementCostFunction residual;
  std::unique_ptr<ceres::LossFunction> loss;
};
template <int Dim>
PairResidualBlock pair_residual(const PairTerm<Dim>& pairs, const LocatedPair<Dim>& pair, double weight) {
  const double factor = std::sqrt(2 * weight * pair.weight), scale = factor * pairs.scale();
  auto* functor = new PairResidual<Dim>{pair, factor, pairs.tolerance()};
  PairResidualBlock block;
  block.residual =
      std::make_unique<ceres::AutoDiffCostFunction<PairResidual<Dim>, ceres::DYNAMIC, PairTerm<Dim>::n_dofs>>(
          functor, functor->size());
  if (pairs.loss() == RobustLoss::huber) block.loss = std::make_unique<ceres::HuberLoss>(scale);
  if (pairs.loss() == RobustLoss::cauchy) block.loss = std::make_unique<ceres::CauchyLoss>(scale);
  return block;
}

}  // namespace shellmatch
