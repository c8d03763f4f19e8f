#pragma once
/// \file

#include "energies/terms/bending.h"

namespace shellmatch {

/// Bending whose W grows quadratically, not exponentially, where the surface has turned over
/// (energies/densities/thin_shell.h).
template <int Dim>
struct ExtrapolatedBending : Bending<Dim> {
  static constexpr TermInfo info{
      .name = "bending",
      .model = "extrapolated",
      .meaning =
          "the paper's, and where the surface has turned over its extrapolation, which Newton's method leaves in fewer "
          "steps",
      .weight = {"bending_weight", 1, {.min = 0, .meaning = "factor on the bending term; 0 switches it off"}},
      .scaled = [](double factor, const TermScales& s) { return factor * s.delta * s.delta * s.delta; }};
  using Density = ExtrapolatedThinShellDensity<Dim>;
};

}  // namespace shellmatch
