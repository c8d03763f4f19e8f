#include "matching/cascade/cascade.h"

#include "base/error.h"
#include "energies/assembly/energy_report.h"
#include "energies/terms/term_names.h"
#include "grid/fields/mass.h"
#include "grid/octree/prolongation.h"
#include "matching/cascade/level_memory.h"
#include "matching/derivative_check/gradient_check.h"
#include "matching/level/level_energy.h"
#include "matching/level/level_metric.h"
#include "matching/level/level_problem.h"
#include "matching/experiment/level_solver.h"
#include "matching/level/shape_fields.h"
#include "matching/pairs/coverage.h"
#include "matching/progress/process_info.h"
#include "solvers/methods/fallback.h"

#include <fmt/format.h>

#include <cmath>

namespace shellmatch {

std::vector<ScheduleStep> schedule_of_level(const CascadeOptions& o, int level) {
  const int k = level - o.min_level;
  const double volume = o.volume * std::pow(o.volume_factor, k);
  if (k == 0) return {{o.nu, volume}};
  std::vector<ScheduleStep> steps;
  for (int s = 1; s <= o.nu_substeps; ++s)
    steps.push_back({o.nu * std::pow(o.nu_factor, k - 1 + static_cast<double>(s) / o.nu_substeps), volume});
  return steps;
}

std::size_t step_after(const std::vector<ScheduleStep>& steps, std::size_t s, double match, double value,
                       double negligible) {
  const double rise = match * (steps[s].nu / steps.back().nu - 1);
  return s + 1 < steps.size() && rise < negligible * std::abs(value) ? steps.size() - 1 : s + 1;
}

namespace {

/// The minimisations on the grid of one level. They start from phi, which is replaced by the result.
template <int Dim>
class Level {
 public:
  /// \param coverage null where it does not act
  Level(const Octree<Dim>& grid, GeometryPair<Dim> geometry, const ExperimentOptions& options,
        const std::vector<PairSet<Dim>>& pairs, const Coverage<Dim>* coverage)
      : options_(options),
        grid_(grid),
        level_(grid, std::move(geometry), options, pairs),
        coverage_(level_.covers(options) ? coverage : nullptr) {}

  LevelResult minimise(int level, std::vector<Vec<Dim>>& phi, Observer& observer, bool& interrupted) {
    LevelResult result;
    LevelStart& start = result.start;
    start.level = level;
    start.sigma = level_.sigma;
    start.n_nodes = grid_.n_nodes();
    start.n_free_nodes = static_cast<Index>(grid_.free_nodes().size());
    start.n_cells = static_cast<Index>(grid_.leaves().size());
    result.n_band_cells = static_cast<Index>(level_.energy.band().n_elements());
    result.n_band_points = level_.energy.band().n_active_points();
    result.band_measure = level_.energy.band().measure();

    const std::vector<double> mass = lumped_mass_of(level_.unknowns.nodes());
    const auto steps = schedule_of_level(options_.cascade, level);
    const int rounds = coverage_ ? options_.coverage.rounds : 1;
    start.n_substeps = static_cast<int>(steps.size()) * rounds;
    result.term_names = level_.energy.term_names();
    const SolverOptions solver = solver_at_level(options_.solver, level);
    TermValues weights;
    for (std::size_t s = 0; s < steps.size() && !interrupted;) {
      start.nu = steps[s].nu;
      start.volume_weight = steps[s].volume_weight;
      weights = level_.weights(options_, start.nu, start.volume_weight);
      const bool is_last = level == options_.cascade.max_level && s + 1 == steps.size();
      std::vector<double> terms;  // values of the terms at the end of the last minimisation
      for (int round = 0; round < rounds && !interrupted; ++round) {
        start.substep = static_cast<int>(s) * rounds + round + 1;
        if (coverage_) level_.energy.replace_pairs(*level_.coverage, PairTerm<Dim>(grid_, coverage_->pairs(grid_, phi)));
        StopOptions stop = solver.stop;
        if (!is_last || round + 1 < rounds)
          stop.relative_decrease = std::max(stop.relative_decrease, options_.cascade.intermediate_decrease);
        terms = minimise_once(start, weights, mass, solver, stop, phi, observer, result);
        interrupted = result.last.reason == StopReason::interrupted;
      }
      s = terms.empty() ? s + 1
                        : step_after(steps, s, terms[static_cast<std::size_t>("match"_term)], result.last.final_value,
                                     options_.cascade.negligible_rise);
    }
    level_.energy.evaluate(phi, weights, result.minimised, {});
    weights_ = weights;
    return result;
  }

  /// Adds the energy by a finer quadrature, the measures of the band and the folds to the result of minimise().
  void report(const std::vector<Vec<Dim>>& phi, LevelResult& result) const {
    const int finer = std::min(options_.energy.quadrature_order + 1, 5);
    const EnergyReport report = report_energy<Dim>(level_.unknowns, level_.geometry, options_.energy, level_.sigma, finer,
                                                   phi, weights_);
    result.reported = report.values;
    result.reported.extend_to(weights_.size());
    level_.energy.set_pair_values(phi, weights_, result.reported);
    result.band = report.band;
    result.folds = find_folds<Dim>(level_.unknowns.elements(), phi);
  }

 private:
  // One minimisation from phi, which is replaced by its result. Adds its costs to `result` and returns the values of the
  // terms at its end.
  std::vector<double> minimise_once(const LevelStart& start, const TermValues& weights, const std::vector<double>& mass,
                                    const SolverOptions& solver, const StopOptions& stop, std::vector<Vec<Dim>>& phi,
                                    Observer& observer, LevelResult& result) {
    LevelProblem<Dim> problem(level_.unknowns, level_.energy, level_.hessian, weights, mass, phi,
                              [&](Metric metric) { return level_metric(level_, solver, weights, metric); });
    std::vector<double> x = problem.unknowns_of(phi);
    observer.minimisation_started(start);
    std::vector<double> terms;
    result.last = minimize_with_fallback(
        solver, problem, x, stop,
        [&](const IterationRecord& r) {
          check(r.iteration, start, problem.last_positions(), weights, observer);
          terms = r.terms;
          return observer.iterated(start, r);
        },
        [&](const std::string& change) {
          result.fallbacks.push_back(fmt::format("level {}, step {}: {}", start.level, start.substep, change));
          observer.note(result.fallbacks.back());
        });
    if (result.last.reason == StopReason::cannot_evaluate_start) {
      if (start.level == options_.cascade.min_level && start.substep == 1) refuse_start(start.level, phi, weights, result.last.message);
      result.fallbacks.push_back(fmt::format("level {}, step {}: {}; phi stays as it is", start.level, start.substep,
                                             result.last.message));
      observer.note(result.fallbacks.back());
    }
    observer.minimisation_finished(start, result.last);
    phi = problem.positions(x);
    result.iterations += result.last.iterations;
    result.value_evaluations += result.last.value_evaluations;
    result.gradient_evaluations += result.last.gradient_evaluations;
    result.linear_iterations += result.last.linear_iterations;
    result.regularised_systems += result.last.regularised_systems;
    result.seconds += result.last.seconds;
    return terms;
  }

  // The energy is not finite at the start of the very first minimisation: names the terms that cause it. The solver's
  // message names the first place.
  [[noreturn]] void refuse_start(int level, const std::vector<Vec<Dim>>& phi, const TermValues& weights,
                                 const std::string& message) const {
    std::string which;
    const std::vector<std::string> names = level_.energy.term_names();
    for (std::size_t t = 0; t < weights.size(); ++t) {
      TermValues alone(weights.size()), values;
      alone[t] = weights[t];
      if (alone[t] != 0 && !level_.energy.evaluate(phi, alone, values, {}))
        which += fmt::format("{}{} (weight {:.3g})", which.empty() ? "" : ", ", names[t], alone[t]);
    }
    throw_input_error("level {}: the energy cannot be evaluated where the first minimisation begins, as it is no finite number: {} "
                      "({}); choose smaller weights or parameters of it (energy.*, cascade.*)",
                      level, which.empty() ? "the sum of its terms" : which, message);
  }

  // Checks the derivatives at the positions evaluated last, which are the iterate or a trial point near it. The Newton
  // model is not checked, because the minimiser may still use the assembled one.
  void check(int iteration, const LevelStart& start, const std::vector<Vec<Dim>>& phi, const TermValues& weights,
             Observer& observer) {
    const CheckGradientOptions& o = options_.check_gradient;
    if (o.every == 0 || iteration % o.every != 0) return;
    // The last evaluation may have been a trial point at which the energy is not finite.
    TermValues values;
    if (!level_.energy.evaluate(phi, weights, values, {})) return;
    GradientReport report = check_gradient<Dim>(
        level_, CheckedEnergy<Dim>(level_), phi, weights,
        {.n_directions = o.directions, .seed = 1, .most_differenced = 200, .n_ceres_elements = 2, .newton_model = false});
    report.substep = start.substep;
    report.iteration = iteration;
    report.nu = start.nu;
    report.volume_weight = start.volume_weight;
    observer.gradient_checked(start, report);
  }

  std::vector<double> lumped_mass_of(std::span<const Index> nodes) const {
    const std::vector<double> all = lumped_mass(grid_);
    std::vector<double> mass;
    mass.reserve(nodes.size());
    for (const Index n : nodes) mass.push_back(all[grid_.free_index(n)]);
    return mass;
  }

  const ExperimentOptions& options_;
  const Octree<Dim>& grid_;
  LevelEnergy<Dim> level_;
  const Coverage<Dim>* coverage_;
  TermValues weights_;  ///< of the last minimisation
};

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
    throw_input_error("the levels that were kept lie on another grid than the one that this machine makes of the shapes; "
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
                               PhaseSeconds& seconds, std::optional<FinishedLevel<Dim>> before,
                               const std::vector<PairSet<Dim>>& pairs) {
  const CascadeOptions& schedule = options.cascade;
  CascadeResult<Dim> result{Octree<Dim>(schedule.min_level), {}, {}, {}, {}, false};
  Octree<Dim>& grid = result.grid;
  result.phi = identity_map(grid);
  ShapeFields<Dim> shapes(reference, template_shape, options);
  std::optional<Coverage<Dim>> coverage;
  if (options.coverage.levels > 0)
    coverage.emplace(reference.surface(), template_shape.surface(), options.coverage);

  const auto keep_fields = [&](const GeometryPair<Dim>& geometry) {
    result.reference = at_nodes(geometry.reference, grid);
    result.target = at_nodes(geometry.target, grid);
  };

  for (int level = schedule.min_level;; ++level) {
    const auto ends = [&] { return level == schedule.max_level || result.interrupted; };
    const bool is_finished = before && level <= before->level;
    const double memory_estimate =
        is_finished ? 0 : check_level_memory<Dim>(level, sizes_of(grid, shapes, options.coefficients), solver_at_level(options.solver, level));
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
      if (level == before->level) {
        result.phi = renumbered(before->map, grid);
        before.reset();
      }
      if (ends()) keep_fields(*geometry);
    } else {
      {  // frees the level's matrices before the output
        clock.start("set-up");
        Level<Dim> problem(grid, *geometry, options, pairs, coverage ? &*coverage : nullptr);
        clock.start("minimisation");
        result.levels.push_back(problem.minimise(level, result.phi, observer, result.interrupted));
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

template CascadeResult<2> run_cascade<2>(const SignedDistance<2>&, const SignedDistance<2>&, const ExperimentOptions&,
                                         Observer&, const LevelCallback<2>&, PhaseSeconds&,
                                         std::optional<FinishedLevel<2>>,
                                         const std::vector<PairSet<2>>&);
template CascadeResult<3> run_cascade<3>(const SignedDistance<3>&, const SignedDistance<3>&, const ExperimentOptions&,
                                         Observer&, const LevelCallback<3>&, PhaseSeconds&,
                                         std::optional<FinishedLevel<3>>,
                                         const std::vector<PairSet<3>>&);

}  // namespace shellmatch
