#pragma once
/// \file
/// The energy that a derivative check examines, and the data that its parts share.

#include "energies/assembly/ceres_evaluator.h"
#include "matching/level/level_energy.h"

#include <cstddef>
#include <span>
#include <vector>

namespace shellmatch {

/// The energy as the minimisers see it. Tests derive classes with planted errors from it.
template <int Dim>
class CheckedEnergy {
 public:
  /// `level` must outlive it.
  explicit CheckedEnergy(const LevelEnergy<Dim>& level) : level_(level) {}
  virtual ~CheckedEnergy() = default;

  /// As MatchingEnergy::evaluate; together with the gradient it gives the element gradients.
  virtual bool evaluate(std::span<const Vec<Dim>> phi, const TermValues& weights, TermValues& values,
                        std::span<double> gradient, std::vector<double>& element_gradients) const;

 protected:
  const LevelEnergy<Dim>& level_;
};

/// How thorough a check is.
struct GradientCheckSettings {
  int n_directions = 2;
  unsigned seed = 1;
  std::size_t most_differenced = 2000;  ///< largest number of elements of a term compared with differences
  int n_ceres_elements = 4;             ///< number of elements of a term given to Ceres' checker
  bool newton_model = true;             ///< assemble and check the Newton model; else it is left unchanged
};

/// The data of a check that do not depend on the term: the energy's level, the functors and the positions.
template <int Dim>
struct CheckContext {
  LevelEnergy<Dim>& level;
  const CeresEvaluator<Dim>& costs;
  const std::vector<Vec<Dim>>& phi;
  const GradientCheckSettings& settings;
};

/// A term as the assembly evaluates it at the positions of the context.
struct AssembledTerm {
  TermValues weights;
  double value = 0;
  std::vector<double> gradient;           ///< by the unknowns
  std::vector<double> element_gradients;  ///< as in MatchingEnergy::evaluate
};

}  // namespace shellmatch
