#pragma once
/// \file
/// The multilevel scheme (paper, algorithm 1): minimise on a grid, refine where the shapes are, go on from there.

#include "energies/assembly/band_report.h"
#include "energies/assembly/folds.h"
#include "energies/assembly/matching_energy.h"
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

/// What came of one level.
struct LevelResult {
  LevelStart start;                  ///< of its last minimisation
  Index n_band_cells = 0;
  std::size_t n_band_points = 0;
  double band_measure = 0;           ///< integral of eta_sigma(d1): tends to the measure of M1
  TermValues minimised;              ///< with the quadrature that was minimised
  TermValues reported;               ///< with a finer one
  FoldReport folds;
  BandReport band;                   ///< with the finer quadrature
  MinimizerSummary last;             ///< of the last minimisation
  std::vector<std::string> fallbacks;  ///< of all minimisations: which method gave up, why, and which went on
  int iterations = 0;                ///< of all minimisations of the level
  long value_evaluations = 0, gradient_evaluations = 0;
  double seconds = 0;
};

/// Everything that belongs to the grid of one level.
template <int Dim>
struct LevelState {
  const Octree<Dim>& grid;
  const std::vector<Vec<Dim>>& phi;
};

/// The end of a level that was finished by an earlier run.
template <int Dim>
struct FinishedLevel {
  int level = 0;
  Deformation<Dim> map;
};

template <int Dim>
struct CascadeResult {
  Octree<Dim> grid;
  std::vector<Vec<Dim>> phi;
  CoefficientFields<Dim> reference, target;  ///< on the finest grid
  std::vector<LevelResult> levels;           ///< of this call, without those that were finished before
  bool interrupted = false;
};

/// Called at the end of every level, with the grid on which it was computed.
template <int Dim>
using LevelCallback = std::function<void(const LevelResult&, const LevelState<Dim>&)>;

/// Runs the cascade from the identity, or goes on after the level `before`: with the same shapes and options the result
/// is then the same to the bit. The shapes lie in the unit domain.
/// \throws InputError if the map `before` does not lie on the grid that these shapes have at its level
template <int Dim>
CascadeResult<Dim> run_cascade(const SignedDistance<Dim>& reference, const SignedDistance<Dim>& template_shape,
                               const ExperimentOptions& options, Observer& observer, const LevelCallback<Dim>& finished,
                               PhaseSeconds& seconds, std::optional<FinishedLevel<Dim>> before = {});

/// nu and c_vol of a level's minimisations, in their order.
struct ScheduleStep {
  double nu, volume_weight;
};
std::vector<ScheduleStep> schedule_of_level(const CascadeOptions& options, int level);

/// Which step follows step `s`, that ended with these values of the match term and of all: the next one, or the
/// last at once. The match term is in inverse ratio to nu, so that it tells by how much the last nu raises the
/// energy; if that is a share of less than `negligible`, no step in between has more than that to win.
std::size_t step_after(const std::vector<ScheduleStep>& steps, std::size_t s, double match, double value,
                       double negligible);

}  // namespace shellmatch
