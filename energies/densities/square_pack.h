#pragma once
/// \file
/// Cholesky factors of small positive semidefinite matrices, eight at a time.

#include "energies/autodiff/pack.h"

#include <array>

namespace shellmatch {

/// A square matrix of M rows, in packs of eight.
template <int M>
using SquarePack = std::array<std::array<autodiff::Pack, M>, M>;

/// Factor L with L L^T = h, h positive semidefinite but for rounding. A column whose pivot is below 1e-8 of the
/// trace is left out: what is left of it is at most 1e-4 of the trace by Cauchy and Schwarz, and divided by such a
/// pivot rounding would come out as stiffness.
template <int M>
SquarePack<M> cholesky(const SquarePack<M>& h) {
  using autodiff::Pack;
  Pack trace{};
  for (int i = 0; i < M; ++i) trace += h[i][i];
  const Pack floor = 1e-8 * trace + 1e-300;
  SquarePack<M> l{};
  for (int j = 0; j < M; ++j) {
    Pack d = h[j][j];
    for (int s = 0; s < j; ++s) d -= l[j][s] * l[j][s];
    const Pack root = autodiff::root_of(autodiff::max_of(d, floor));
    const Pack inverse = d > floor ? 1.0 / root : Pack{};
    l[j][j] = d * inverse;
    for (int i = j + 1; i < M; ++i) {
      Pack v = h[i][j];
      for (int s = 0; s < j; ++s) v -= l[i][s] * l[j][s];
      l[i][j] = v * inverse;
    }
  }
  return l;
}

}  // namespace shellmatch
