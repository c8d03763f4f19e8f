#pragma once
/// \file
/// The term of point pairs on one element as a cost function of Ceres.

#include "energies/cost/cost_function.h"
#include "energies/pairs/pair_term.h"

#include <ceres/autodiff_cost_function.h>

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

}  // namespace shellmatch
