#pragma once
/// \file
/// The part of a derivative check that looks at single elements: the assembly against the element functors with dual
/// numbers, against differences, and by Ceres' checker.

#include "matching/derivative_check/checked_energy.h"
#include "matching/derivative_check/gradient_report.h"

namespace shellmatch {

/// Fills everything of `check` but directions and Newton model.
template <int Dim>
void check_elements(const CheckContext<Dim>& context, const AssembledTerm& term, TermCheck& check);

}  // namespace shellmatch
