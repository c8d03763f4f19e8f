#pragma once
/// \file
/// Differences of the element functors, with which a derivative check compares the gradients of the assembly.

#include "matching/derivative_check/checked_energy.h"

#include <span>

namespace shellmatch {

/// The gradient of one term on one element, and the sizes to which its errors are relative.
struct ElementGradient {
  std::span<const double> assembled;  ///< gradient of the assembly, size CeresEvaluator::n_dofs
  double largest_by_jets = 0;         ///< largest absolute entry of the gradient by dual numbers
  double value = 0;                   ///< value of the term on the element
  double natural_size = 0;            ///< CeresEvaluator::natural_size()
};

/// What the comparison of an element gradient with differences has found.
struct DifferenceError {
  double error = 0;        ///< largest error of an entry, in units of its tolerance
  bool near_face = false;  ///< not compared: a quadrature point is nearer to a kink than the shortest step
  bool kink = false;       ///< the one-sided derivatives of an entry differ, and one of them is the assembly's
};

/// Differences of one term's element functor at the positions of the context. Steps are in units of the domain's side.
template <int Dim>
class ElementDifferences {
 public:
  using Dofs = typename CeresEvaluator<Dim>::Dofs;

  /// All must outlive this object.
  ElementDifferences(const CheckContext<Dim>& context, const TermValues& weights);

  /// Central differences with `step` and step / 2, extrapolated to fourth order: derivative by entry i of `dofs`.
  double central(std::size_t e, const Dofs& dofs, int i, double step) const;

  /// Compares all entries with steps of 1e-4, 1e-5 and 1e-6 of the element's side; the best of them counts.
  DifferenceError compare(std::size_t e, const ElementGradient& gradient) const;

 private:
  double value_at(std::size_t e, Dofs dofs, int i, double step) const;
  bool is_kink(std::size_t e, const Dofs& dofs, int i, const ElementGradient& gradient) const;

  const CheckContext<Dim>& context_;
  const CeresEvaluator<Dim>& costs_;
  std::span<const Element<Dim>> elements_;
  const TermValues& weights_;
};

}  // namespace shellmatch
