#pragma once
/// \file
/// The multilevel scheme (paper, algorithm 1): minimise on a grid, refine it at the shapes, and continue on the finer
/// grid.

#include "energies/assembly/band_report.h"
#include "energies/assembly/folds.h"
#include "energies/assembly/matching_energy.h"
#include "energies/pairs/point_pairs.h"
#include "geometry/distance/signed_distance.h"
#include "grid/fits/curvature.h"
#include "grid/octree/octree.h"
#include "matching/level/deformation.h"
#include "matching/progress/phase_clock.h"
#include "matching/experiment/options.h"
#include "matching/progress/observer.h"

#include <cstddef>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace shellmatch {

/// The result of one level.
struct LevelResult {
  std::vector<std::string> term_names;  ///< of `minimised` and `reported`
  LevelStart start;                  ///< of the level's last minimisation
  Index n_band_cells = 0;
  std::size_t n_band_points = 0;
  double band_measure = 0;           ///< integral of eta_sigma(d1); tends to the measure of M1
  TermValues minimised;              ///< weighted terms by the quadrature of the minimisation
  TermValues reported;               ///< weighted terms by a finer quadrature
  FoldReport folds;
  BandReport band;                   ///< by the finer quadrature
  MinimizerSummary last;             ///< summary of the level's last minimisation
  std::vector<std::string> fallbacks;  ///< one entry for each method that gave up: which, why, and its successor
  int iterations = 0;                ///< sum over the level's minimisations
  long value_evaluations = 0, gradient_evaluations = 0;
  long linear_iterations = 0, regularised_systems = 0;
  double seconds = 0;
  double memory_estimate = 0, memory_peak = 0;  ///< resident bytes: as expected before the level, and the run's peak after it
};

/// Grid and nodal positions at the end of a level.
template <int Dim>
struct LevelState {
  const Octree<Dim>& grid;
  const std::vector<Vec<Dim>>& phi;
};

/// The end of a level that an earlier run has finished.
template <int Dim>
struct FinishedLevel {
  int level = 0;
  Deformation<Dim> map;
};

template <int Dim>
struct CascadeResult {
  Octree<Dim> grid;
  std::vector<Vec<Dim>> phi;
  CoefficientFields<Dim> reference, target;  ///< at the nodes of the finest grid
  std::vector<LevelResult> levels;           ///< levels of this call; those that were finished before are left out
  bool interrupted = false;
};

/// Called at the end of every level, with the grid on which it was computed and the positions of its nodes.
template <int Dim>
using LevelCallback = std::function<void(const LevelResult&, const LevelState<Dim>&)>;

/// Runs the cascade from the identity, or continues after the level `before`: with the same shapes and options the
/// result is then the same bit for bit. \pre the shapes lie in the unit domain
/// \param pairs terms of point pairs, besides that of coverage (options.coverage)
/// \throws InputError if the map `before` does not lie on the grid that these shapes have at its level
template <int Dim>
CascadeResult<Dim> run_cascade(const SignedDistance<Dim>& reference, const SignedDistance<Dim>& template_shape,
                               const ExperimentOptions& options, Observer& observer, const LevelCallback<Dim>& finished,
                               PhaseSeconds& seconds, std::optional<FinishedLevel<Dim>> before = {},
                               const std::vector<PairSet<Dim>>& pairs = {});

/// Parameters nu and c_vol of one minimisation. schedule_of_level() lists those of a level in their order.
struct ScheduleStep {
  double nu, volume_weight;
};
std::vector<ScheduleStep> schedule_of_level(const CascadeOptions& options, int level);

/// The index of the step to follow step `s`, which ended with match term `match` and energy `value`: s + 1, or the
/// last. The match term is proportional to 1/nu, so that it tells by how much the last nu raises the energy. If that
/// rise is less than the share `negligible` of the energy, the steps in between are skipped.
std::size_t step_after(const std::vector<ScheduleStep>& steps, std::size_t s, double match, double value,
                       double negligible);

}  // namespace shellmatch
