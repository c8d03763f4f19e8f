#pragma once
/// \file
/// The deformations at which derivatives can be checked.

#include "matching/level/deformation.h"
#include "matching/level/level_energy.h"

#include <optional>
#include <string>
#include <vector>

namespace shellmatch {

/// The deformation that the option `--state` of check-gradient names.
struct CheckState {
  enum class Kind { identity, random, folder };
  Kind kind = Kind::random;
  double amplitude = 0.03;  ///< of the random field, in sides of the domain
  unsigned seed = 1;
  std::string folder;  ///< output folder of a run, or its deformation.vtu

  /// Parses "identity", "random:AMPLITUDE", "random:AMPLITUDE:SEED" or the name of a folder. \throws InputError
  static CheckState parse(const std::string& text);
  std::string text() const;
};

/// The position of each node. Random: a smooth field of the given amplitude, plus an independent random displacement of
/// each node that brings cells close to folding, so that the barrier against folds acts.
/// \param found the map of state.folder, which is evaluated at the nodes; none for other kinds
/// \throws InputError where the smooth field alone folds
template <int Dim>
std::vector<Vec<Dim>> positions_of(const CheckState& state, const LevelEnergy<Dim>& level, const EnergyOptions& options,
                                   const std::optional<Deformation<Dim>>& found);

}  // namespace shellmatch
