#include "matching/cascade/cascade.h"

#include "base/error.h"
#include "energies/assembly/folds.h"
#include "grid/octree/prolongation.h"
#include "matching/cascade/level_memory.h"
#include "matching/cascade/level_minimisation.h"
#include "matching/experiment/level_solver.h"
#include "matching/level/shape_fields.h"
#include "matching/pairs/coverage.h"
#include "matching/progress/process_info.h"

#include <utility>

namespace shellmatch {

namespace {

/// The map at the nodes of `grid`, which has the cells of the map's own grid, numbered differently.
template <int Dim>
std::vector<Vec<Dim>> renumbered(const Deformation<Dim>& map, const Octree<Dim>& grid) {
  bool same = map.grid.n_nodes() == grid.n_nodes() && map.grid.leaves().size() == grid.leaves().size();
  std::vector<Vec<Dim>> phi(static_cast<std::size_t>(grid.n_nodes()));
  for (Index i = 0; same && i < grid.n_nodes(); ++i) {
    const Index there = map.grid.find_node(grid.node_coord(i));
    same = there != no_index;
    if (same) phi[i] = map.phi[there];
  }
  if (!same)
    throw_input_error(
        "the levels that were kept lie on another grid than the one that this machine makes of the shapes; "
        "begin anew with --restart");
  return phi;
}

// Of the level that begins: the grid of phi is refined already, the shapes' own grids are not.
template <int Dim>
LevelSizes sizes_of(const Octree<Dim>& grid, const ShapeFields<Dim>& shapes, const CoefficientOptions& options) {
  LevelSizes sizes;
  sizes.n_nodes = static_cast<double>(grid.n_nodes());
  sizes.n_free_nodes = static_cast<double>(grid.free_nodes().size());
  sizes.n_cells = static_cast<double>(grid.leaves().size());
  sizes.n_new_field_nodes = shapes.n_new_field_nodes(grid);
  sizes.has_field_grids = options.interpolation == FieldInterpolation::smooth;
  return sizes;
}

}  // namespace

template <int Dim>
CascadeResult<Dim> run_cascade(const SignedDistance<Dim>& reference, const SignedDistance<Dim>& template_shape,
                               const ExperimentOptions& options, Observer& observer, const LevelCallback<Dim>& finished,
                               PhaseSeconds& seconds, std::optional<FinishedLevel<Dim>> resume_after,
                               const std::vector<PairSet<Dim>>& pairs, const ObservedPair<Dim>& observed) {
  const CascadeOptions& schedule = options.cascade;
  CascadeResult<Dim> result{Octree<Dim>(schedule.min_level), {}, {}, {}, {}, false};
  Octree<Dim>& grid = result.grid;
  result.phi = identity_map(grid);
  ShapeFields<Dim> shapes(reference, template_shape, options);
  const PointTerms<Dim> points(pairs, reference.surface(), template_shape, options, observed);

  const auto keep_fields = [&](const GeometryPair<Dim>& geometry) {
    result.moving_fields = at_nodes(geometry.reference, grid);
    result.target_fields = at_nodes(geometry.target, grid);
  };

  bool is_start = !(resume_after && resume_after->is_same_run);
  for (int level = schedule.min_level;; ++level) {
    const auto ends = [&] { return level == schedule.max_level || result.interrupted; };
    if (resume_after && !resume_after->is_same_run && level == resume_after->level + 1) {
      result.phi = sampled_map(resume_after->map, grid);
      if (find_folds<Dim>(Unknowns<Dim>(grid, options.energy.boundary).elements(), result.phi).n_uncertified_cells >
          0) {
        observer.warn("the earlier map folds between the nodes of this grid: it is not used");
        return run_cascade(reference, template_shape, options, observer, finished, seconds, {}, pairs, observed);
      }
      resume_after.reset();
    }
    const bool is_finished = resume_after && level <= resume_after->level;
    const double memory_estimate = is_finished
                                       ? 0
                                       : check_level_memory<Dim>(level, sizes_of(grid, shapes, options.coefficients),
                                                                 solver_at_level(options.solver, level));
    PhaseClock clock(seconds);
    clock.start("distances");
    shapes.compute_distances(grid);
    // The grids of earlier levels are refined again and not read, so that nodes get the same numbers as in an
    // uninterrupted run: sums depend on their order.
    std::optional<GeometryPair<Dim>> geometry;
    if (!is_finished || level == schedule.max_level) {
      clock.start("coefficients");
      geometry.emplace(shapes.geometry(grid));
    }
    if (is_finished) {
      if (resume_after->is_same_run && level == resume_after->level) {
        result.phi = renumbered(resume_after->map, grid);
        resume_after.reset();
      }
      if (ends()) keep_fields(*geometry);
    } else {
      {  // frees the level's matrices before the output
        clock.start("set-up");
        LevelMinimisation<Dim> problem(grid, *geometry, options, points, observed);
        return_freed_memory();
        clock.start("minimisation");
        result.levels.push_back(
            problem.minimise(level, result.phi, std::exchange(is_start, false), observer, result.interrupted));
        clock.start("report");
        problem.report(result.phi, result.levels.back());
        result.levels.back().memory_estimate = memory_estimate;
        result.levels.back().memory_peak = static_cast<double>(peak_memory_bytes());
      }
      clock.start("output");
      if (finished) finished(result.levels.back(), {grid, result.phi});
      if (ends()) keep_fields(*geometry);
    }
    if (ends()) break;

    clock.start("refinement");
    const Index n_old = grid.n_nodes();
    shapes.refine(grid);
    prolongate(grid, n_old, result.phi);
  }
  return result;
}

SHELLMATCH_2D_3D(run_cascade);

}  // namespace shellmatch
