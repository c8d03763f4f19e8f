#pragma once
/// \file
/// What the parts of a derivative check share: the energy that is checked, where, and how thoroughly.

#include "energies/assembly/element_oracle.h"
#include "matching/cascade/level_energy.h"

#include <cstddef>
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

/// Where an energy is checked: all that does not depend on the term.
template <int Dim>
struct CheckContext {
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

}  // namespace shellmatch
