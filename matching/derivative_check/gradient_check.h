#pragma once
/// \file
/// Is the gradient of an experiment's energy the derivative of its value? Term by term and for the sum, by the order
/// of the Taylor remainder, against the element functors with dual numbers, against differences, by Ceres' checker,
/// and for the Newton model by symmetry and sign.

#include "matching/derivative_check/checked_energy.h"
#include "matching/derivative_check/gradient_report.h"

#include <functional>
#include <string>
#include <vector>

namespace shellmatch {

/// Checks at phi (a position for each node, hanging nodes consistent). `weights` as in the minimisation. Calls
/// `next` before each term. Evaluates, and leaves the Newton model assembled for something else.
/// \throws InputError where the energy cannot be evaluated at phi
template <int Dim>
GradientReport check_gradient(LevelEnergy<Dim>& level, const CheckedEnergy<Dim>& energy,
                              const std::vector<Vec<Dim>>& phi, const TermValues& weights,
                              const GradientCheckSettings& settings,
                              const std::function<void(const std::string& term)>& next = {});

}  // namespace shellmatch
