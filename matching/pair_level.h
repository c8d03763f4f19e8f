#pragma once
/// \file
/// One level of the cascade of a given pair, with its energy, as an object that can be kept: for checks of derivatives
/// and for solvers from elsewhere.

#include "geometry/distance/signed_distance.h"
#include "matching/alignment/prepare_pair.h"
#include "matching/cascade/schedule.h"
#include "matching/input/shape_pair.h"
#include "matching/level/level_energy.h"
#include "matching/level/level_problem.h"
#include "matching/level/shape_fields.h"
#include "matching/pairs/coverage.h"
#include "matching/pairs/landmarks.h"
#include "matching/progress/observer.h"

#include <functional>
#include <optional>
#include <vector>

namespace shellmatch {

/// Number of cells and nodes of a level's grid.
struct LevelSize {
  int level = 0;
  Index n_nodes = 0, n_free_nodes = 0, n_cells = 0;
};

/// Do two maps belong to shapes in the same place, direction, pose and bend?
template <int Dim>
bool same_frame(const MapFrame<Dim>& a, const MapFrame<Dim>& b);

/// The grid, the coefficients and the energy that the cascade has on a level. Its members refer to each other.
template <int Dim>
class PairLevel {
 public:
  /// Aligns and places the shapes, refines from cascade.min_level up to `level`, and makes the energy there.
  /// \param shapes in the user's coordinates \param options kept \param level between cascade.min_level and
  /// cascade.max_level \param observer is told the stages \param prepared told where the pair lies, before anything
  /// that takes long; what it throws is passed on \throws InputError as match_shapes; EnvironmentError
  PairLevel(ShapePair<Dim> shapes, std::vector<Landmark<Dim>> landmarks, const ExperimentOptions& options, int level,
            Observer& observer, const std::function<void(const MapFrame<Dim>&)>& prepared = {});
  PairLevel(const PairLevel&) = delete;
  PairLevel& operator=(const PairLevel&) = delete;

  /// phi = x.
  std::vector<Vec<Dim>> identity() const { return identity_map(grid_); }

  /// The result of the cascade on the level before, at the nodes of this one: where the cascade begins here. The
  /// identity on the coarsest. \throws Stopped where the observer ends it before
  std::vector<Vec<Dim>> coarser_result(Observer& observer) const;

  /// A map of the same shapes, at the nodes of this grid. \pre it lies where this pair does: same_frame()
  std::vector<Vec<Dim>> sampled(const Deformation<Dim>& map) const;

  LevelEnergy<Dim>& energy() { return *level_; }
  const LevelEnergy<Dim>& energy() const { return *level_; }
  /// The last step of the schedule on this level, and the terms' weights there.
  ScheduleStep step() const { return schedule_of_level(options_.cascade, number_).back(); }
  TermValues weights() const { return level_->weights(options_, step().nu, step().volume_weight); }

  /// The energy as a problem for the solvers. This object must outlive it.
  LevelProblem<Dim> problem(const SolverOptions& solver, const std::vector<Vec<Dim>>& phi);

  /// The map with these nodal positions, in the user's coordinates.
  Deformation<Dim> map(std::vector<Vec<Dim>> phi) const { return {prepared_.frame(), grid_, std::move(phi)}; }

  int number() const { return number_; }
  const ExperimentOptions& options() const { return options_; }
  const std::vector<LevelSize>& sizes() const { return sizes_; }  ///< of this level and those before it

 private:
  ExperimentOptions options_;
  const int number_;
  ShapePair<Dim> shapes_;  ///< in the unit domain; the one that phi deforms first
  std::vector<Landmark<Dim>> landmarks_;
  PreparedPair<Dim> prepared_;
  std::optional<SignedDistance<Dim>> d1_, d2_;
  std::optional<ShapeFields<Dim>> fields_;
  Octree<Dim> grid_;
  std::vector<LevelSize> sizes_;
  std::optional<LevelEnergy<Dim>> level_;
  std::optional<PointTerms<Dim>> points_;
};

}  // namespace shellmatch
