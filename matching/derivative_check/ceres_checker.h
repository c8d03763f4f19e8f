#pragma once
/// \file
/// The adapter of Ceres' GradientChecker, for a function of few variables, such as the energy of one element.

#include <functional>
#include <span>

namespace shellmatch {

/// Sets the value at `dofs` and, where `gradient` is not empty, the derivative by each of them. Returns false where the
/// function cannot be evaluated.
using SmallFunction = std::function<bool(std::span<const double> dofs, double& value, std::span<double> gradient)>;

struct CeresVerdict {
  bool passed = false;
  double worst_relative_error = 0;  ///< largest over the entries of the derivative
};

/// Compares the gradient at `dofs` with Ceres' numeric differentiation (Ridders' method) of the values, entry by entry
/// with relative errors. Entries that vanish by symmetry would compare rounding errors only, so the degrees of freedom
/// are mixed by a reflection first.
/// \param first_step the longest step of a difference, in the unit of the degrees of freedom
CeresVerdict check_with_ceres(const SmallFunction& function, std::span<const double> dofs, double first_step,
                              double relative_precision);

}  // namespace shellmatch
