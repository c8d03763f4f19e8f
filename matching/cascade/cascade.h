#pragma once
/// \file
/// The multilevel scheme (paper, algorithm 1): minimise on a grid, refine it at the shapes, and continue on the finer
/// grid.

#include "energies/pairs/point_pairs.h"
#include "geometry/distance/signed_distance.h"
#include "grid/fits/curvature.h"
#include "grid/octree/octree.h"
#include "matching/cascade/level_minimisation.h"
#include "matching/experiment/options.h"
#include "matching/level/deformation.h"
#include "matching/level/observed_mask.h"
#include "matching/progress/observer.h"
#include "matching/progress/phase_clock.h"

#include <cstddef>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace shellmatch {

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
  /// Of the same shapes and options: the map lies on the grid of its level, and the result is that of an uninterrupted
  /// run. Otherwise it is of similar shapes in the same places, and is sampled at the nodes of the next level.
  bool is_same_run = true;
};

template <int Dim>
struct CascadeResult {
  Octree<Dim> grid;
  std::vector<Vec<Dim>> phi;
  CoefficientFields<Dim> moving_fields,
      target_fields;  ///< of the shape that phi deforms and of the other one, at the nodes of the finest grid
  std::vector<LevelResult> levels;  ///< levels of this call; those that were finished before are left out
  bool interrupted = false;
};

/// Called at the end of every level, with the grid on which it was computed and the positions of its nodes.
template <int Dim>
using LevelCallback = std::function<void(const LevelResult&, const LevelState<Dim>&)>;

/// Runs the cascade from the identity, or continues after the level `resume_after`: with the same shapes and options
/// the result is then the same bit for bit. \pre the shapes lie in the unit domain \param pairs terms of point pairs,
/// besides that of coverage (options.coverage) \param observed what the shapes have data of; match, membrane, bending
/// and coverage weigh nothing elsewhere \param resume_after where it is of another run and folds on the grid of these
/// shapes, the observer is warned and the cascade begins anew \throws InputError if `resume_after` is of the same run
/// and does not lie on the grid that these shapes have at its level
template <int Dim>
CascadeResult<Dim> run_cascade(const SignedDistance<Dim>& reference, const SignedDistance<Dim>& template_shape,
                               const ExperimentOptions& options, Observer& observer, const LevelCallback<Dim>& finished,
                               PhaseSeconds& seconds, std::optional<FinishedLevel<Dim>> resume_after = {},
                               const std::vector<PairSet<Dim>>& pairs = {}, const ObservedPair<Dim>& observed = {});

}  // namespace shellmatch
