#pragma once
/// \file
/// The deformations at which derivatives can be checked.

#include "matching/level/deformation.h"
#include "matching/level/level_energy.h"

#include <optional>
#include <string>
#include <vector>

namespace shellmatch {

/// `--state` of check-gradient.
struct CheckState {
  enum class Kind { identity, random, folder };
  Kind kind = Kind::random;
  double amplitude = 0.03;  ///< of random, in sides of the domain
  unsigned seed = 1;
  std::string folder;       ///< output folder of a run, or its deformation.vtu

  /// "identity", "random:AMPLITUDE", "random:AMPLITUDE:SEED" or a folder. \throws InputError
  static CheckState parse(const std::string& text);
  std::string text() const;
};

/// Positions for each node. `random`: a smooth field of the given amplitude, and on top of it every node by itself,
/// as far as that goes before a cell is near to folding, so that the barrier against folds acts. `found`: the map of
/// `folder`, read at the nodes. \throws InputError where a smooth field of that amplitude folds by itself
template <int Dim>
std::vector<Vec<Dim>> positions_of(const CheckState& state, const LevelEnergy<Dim>& level, const EnergyOptions& options,
                                   const std::optional<Deformation<Dim>>& found);

}  // namespace shellmatch
