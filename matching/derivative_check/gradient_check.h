#pragma once
/// \file
/// Checks that the gradient of an experiment's energy is the derivative of its value, for each term and for their sum:
/// by the order of the Taylor remainder, against the element functors by dual numbers, against differences and by
/// Ceres' checker. Checks symmetry and definiteness of the Newton model.

#include "matching/derivative_check/checked_energy.h"
#include "matching/derivative_check/gradient_report.h"

#include <functional>
#include <string>
#include <vector>

namespace shellmatch {

/// Checks the derivatives at phi. Afterwards the Newton model in `level` is that of the last term checked, unless
/// settings.newton_model is false.
/// \param phi a position for each node, with hanging nodes consistent
/// \param weights of the terms, as in the minimisation
/// \param next called before each term; may be empty
/// \throws InputError where the energy cannot be evaluated at phi
template <int Dim>
GradientReport check_gradient(LevelEnergy<Dim>& level, const CheckedEnergy<Dim>& energy,
                              const std::vector<Vec<Dim>>& phi, const TermValues& weights,
                              const GradientCheckSettings& settings,
                              const std::function<void(const std::string& term)>& next = {});

}  // namespace shellmatch
