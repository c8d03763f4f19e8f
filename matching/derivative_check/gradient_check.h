#pragma once
/// \file
/// Is the gradient of an experiment's energy the derivative of its value? Term by term and for the sum, by the order
/// of the Taylor remainder, against the element functors with dual numbers, against differences, by Ceres' checker,
/// and for the Newton model by symmetry and sign.

#include "base/options.h"
#include "matching/derivative_check/gradient_report.h"
#include "matching/cascade/level_energy.h"

#include <functional>
#include <span>
#include <vector>

namespace shellmatch {

/// What is checked: an energy as the minimisers see it. Tests derive from it to plant errors.
template <int Dim>
class CheckedEnergy {
 public:
  /// `level` must outlive it.
  explicit CheckedEnergy(const LevelEnergy<Dim>& level) : level_(level) {}
  virtual ~CheckedEnergy() = default;

  /// As MatchingEnergy::evaluate; with a gradient also the element gradients behind it.
  virtual bool evaluate(std::span<const Vec<Dim>> phi, const TermValues& weights, TermValues& values,
                        std::span<double> gradient, std::vector<double>& element_gradients) const;

 protected:
  const LevelEnergy<Dim>& level_;
};

/// How thorough a check is.
struct GradientCheckSettings {
  int n_directions = 2;
  unsigned seed = 1;
  std::size_t most_differenced = 2000;  ///< elements of a term that are compared with differences
  int n_ceres_elements = 4;             ///< elements of a term that Ceres' checker is given
  bool newton_model = true;             ///< assemble and check it; without, the model is left as it is
};

/// Checks at phi (a position for each node, hanging nodes consistent). `weights` as in the minimisation. Calls
/// `next` before each term. Evaluates, and leaves the Newton model assembled for something else.
/// \throws InputError where the energy cannot be evaluated at phi
template <int Dim>
GradientReport check_gradient(LevelEnergy<Dim>& level, const CheckedEnergy<Dim>& energy,
                              const std::vector<Vec<Dim>>& phi, const TermValues& weights,
                              const GradientCheckSettings& settings,
                              const std::function<void(const std::string& term)>& next = {});

}  // namespace shellmatch
