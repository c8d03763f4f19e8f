#pragma once
/// \file
/// Estimates the memory of a level just before it begins, so that a run ends in order before a level that would not
/// fit.

#include "base/stop.h"
#include "matching/experiment/options.h"

#include <cstdint>
#include <string>

namespace shellmatch {

/// What the memory of a level depends on. All but `n_new_field_nodes` are exact when the level begins.
struct LevelSizes {
  double n_nodes = 0, n_free_nodes = 0;  ///< of the grid of phi
  double n_cells = 0;                    ///< leaves
  double n_new_field_nodes = 0;          ///< nodes that the level adds to the shapes' own grids; 0 without such grids
  bool has_field_grids = true;           ///< otherwise the coefficients are at the nodes of phi
};

/// Bytes that the level allocates beyond what this process holds when it begins, at its peak.
/// \param solver the solver's options on that level: Newton's matrix and the pairs of L-BFGS are most of it
template <int Dim>
double level_memory_bytes(const LevelSizes& sizes, const SolverOptions& solver);

/// A level does not fit into the memory that the user has given, and has not begun.
class LevelTooLarge : public Stopped {
 public:
  explicit LevelTooLarge(const std::string& text) : Stopped(text, StopCause::memory_limit) {}
};

/// The peak of this process' resident memory in bytes by the end of the level: what it holds now and
/// level_memory_bytes(), or what it has reached before. \throws LevelTooLarge with the level and both numbers if that
/// exceeds memory_limit_bytes(), if there is one
template <int Dim>
double check_level_memory(int level, const LevelSizes& sizes, const SolverOptions& solver);

}  // namespace shellmatch
