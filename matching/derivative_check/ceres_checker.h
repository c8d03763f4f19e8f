#pragma once
/// \file
/// The door to Ceres' GradientChecker, for a function of some numbers, an element's degrees of freedom as a rule.

#include <functional>
#include <span>
#include <string>

namespace shellmatch {

/// Value at `dofs`, and where `gradient` is not empty the derivative by each of them. False: cannot be evaluated.
using SmallFunction = std::function<bool(std::span<const double> dofs, double& value, std::span<double> gradient)>;

struct CeresVerdict {
  bool passed = false;
  double worst_relative_error = 0;  ///< of the entries of the derivative
  std::string log;                  ///< Ceres' own words where it did not pass; of the mixed entries
};

/// Compares the function's gradient at `dofs` with Ceres' numeric differentiation (Ridders) of its values, entry by
/// entry, each relative to itself. In the given degrees of freedom some entries may vanish by symmetry, so that rounding
/// is all there is to compare; hence they are mixed by a reflection first. `first_step` is the longest difference that is
/// taken, in the unit of the degrees of freedom.
CeresVerdict check_with_ceres(const SmallFunction& function, std::span<const double> dofs, double first_step,
                              double relative_precision);

}  // namespace shellmatch
