#pragma once
/// \file
/// The part of a derivative check that looks at single elements: the assembly against the element functors with dual
/// numbers, against differences, and by Ceres' checker.

#include "energies/assembly/element_oracle.h"
#include "matching/derivative_check/gradient_check.h"

#include <span>
#include <vector>

namespace shellmatch {

/// Where an energy is checked: all that does not depend on the term.
template <int Dim>
struct CheckPlace {
  LevelEnergy<Dim>& level;
  const ElementOracle<Dim>& oracle;
  const std::vector<Vec<Dim>>& phi;
  const GradientCheckSettings& settings;
};

/// A term as the assembly has it at the place.
struct AssembledTerm {
  TermValues weights;
  double value = 0;
  std::vector<double> gradient;           ///< by the unknowns
  std::vector<double> element_gradients;  ///< as of MatchingEnergy::evaluate
};

/// Fills everything of `check` but directions and Newton model.
template <int Dim>
void check_elements(const CheckPlace<Dim>& place, const AssembledTerm& term, TermCheck& check);

}  // namespace shellmatch
