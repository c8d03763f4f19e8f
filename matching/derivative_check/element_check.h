#pragma once
/// \file
/// The part of a derivative check that examines single elements: compares the assembly with the element functors by
/// dual numbers, with differences, and by Ceres' checker.

#include "matching/derivative_check/checked_energy.h"
#include "matching/derivative_check/gradient_report.h"

namespace shellmatch {

/// Sets all members of `check` except those of the directions and the Newton model.
template <int Dim>
void check_elements(const CheckContext<Dim>& context, const AssembledTerm& term, TermCheck& check);

}  // namespace shellmatch
