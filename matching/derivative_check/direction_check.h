#pragma once
/// \file
/// The part of a derivative check that evaluates the whole energy along directions: the Taylor remainder, and the
/// Newton model of the second derivative.

#include "matching/derivative_check/checked_energy.h"
#include "matching/derivative_check/gradient_report.h"

namespace shellmatch {

/// Checks random directions and adds the results to `check`.
template <int Dim>
void check_directions(const CheckContext<Dim>& context, const CheckedEnergy<Dim>& energy, const AssembledTerm& term,
                      TermCheck& check);

/// Checks symmetry and definiteness of the Newton model, and adds the result to `check`.
template <int Dim>
void check_hessian(const CheckContext<Dim>& context, const AssembledTerm& term, TermCheck& check);

}  // namespace shellmatch
