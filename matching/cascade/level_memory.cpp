#include "matching/cascade/level_memory.h"

#include "matching/progress/process_info.h"

#include <fmt/format.h>

#include <algorithm>

namespace shellmatch {

namespace {

// Measured as the rise of resident memory over levels (docs/limits.md).
template <int Dim>
struct BytesPer {
  static constexpr double cell = Dim == 2 ? 150 : 500;         // elements, band, blocks of cells
  static constexpr double newton_node = Dim == 2 ? 200 : 650;  // Newton's matrix, by free node
  static constexpr double vector = 8 * Dim;                    // one number for each unknown, by free node
  static constexpr double coefficients =
      Dim == 2 ? 120 : 200;  // at the nodes of phi, where the shapes have no grids of their own
  static constexpr double new_field_node = Dim == 2 ? 400 : 320;  // tree, distance, its second derivatives, splines
};

// Vectors that a method keeps while it runs, at the most.
double n_vectors(const SolverOptions& solver) {
  constexpr double own = 8;
  if (solver.name == "lbfgs") return own + 2.0 * solver.lbfgs.memory;
  if (solver.name == "ceres_lbfgs") return own + 2.0 * solver.ceres.max_lbfgs_rank;
  return own;
}

}  // namespace

template <int Dim>
double level_memory_bytes(const LevelSizes& sizes, const SolverOptions& solver) {
  using Per = BytesPer<Dim>;
  const double of_solver = solver.name == "newton" ? Per::newton_node : Per::vector * n_vectors(solver);
  const double of_coefficients = sizes.has_field_grids ? 0 : Per::coefficients * sizes.n_nodes;
  return of_coefficients + Per::cell * sizes.n_cells + of_solver * sizes.n_free_nodes +
         Per::new_field_node * sizes.n_new_field_nodes;
}

template <int Dim>
double check_level_memory(int level, const LevelSizes& sizes, const SolverOptions& solver) {
  const auto held = static_cast<double>(resident_memory_bytes());
  const double peak = held + level_memory_bytes<Dim>(sizes, solver);
  if (const auto limit = static_cast<double>(memory_limit_bytes()); limit > 0 && peak > limit)
    throw LevelTooLarge(
        fmt::format("level {} would need about {:.3g} GB of memory, {:.3g} GB more than now ({:.3g} million nodes)",
                    level, peak / 1e9, (peak - held) / 1e9, sizes.n_nodes / 1e6));
  return std::max(peak, static_cast<double>(peak_memory_bytes()));
}

SHELLMATCH_2D_3D(level_memory_bytes);
SHELLMATCH_2D_3D(check_level_memory);

}  // namespace shellmatch
