#include "matching/cascade.h"

#include "base/parallel.h"
#include "grid/constraints.h"
#include "grid/elements.h"
#include "grid/mass.h"
#include "grid/prolongation.h"
#include "matching/level_problem.h"
#include "matching/phase_clock.h"
#include "solvers/metric.h"

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

namespace {

/// Exact distances at the nodes, kept over refinements: a node's distance does not change, only new nodes ask.
template <int Dim>
class NodalDistance {
 public:
  explicit NodalDistance(const SignedDistance<Dim>& distance) : distance_(&distance) {}
  const std::vector<double>& on(const Octree<Dim>& grid) {
    const std::size_t known = values_.size();
    values_.resize(static_cast<std::size_t>(grid.n_nodes()));
    parallel_for(values_.size() - known, [&](std::size_t i) {
      values_[known + i] = (*distance_)(grid.node_position(static_cast<Index>(known + i)));
    }, 256);
    return values_;
  }

 private:
  const SignedDistance<Dim>* distance_;
  std::vector<double> values_;
};

/// The finite element function with these values at the free nodes.
template <int Dim>
std::vector<double> conforming(const Octree<Dim>& grid, std::vector<double> nodal) {
  distribute(grid, nodal);
  return nodal;
}

template <int Dim>
std::vector<Vec<Dim>> identity(const Octree<Dim>& grid) {
  std::vector<Vec<Dim>> phi(static_cast<std::size_t>(grid.n_nodes()));
  for (Index i = 0; i < grid.n_nodes(); ++i) phi[i] = grid.node_position(i);
  return phi;
}

/// One level: all its minimisations, from phi, which is replaced by the result.
template <int Dim>
class Level {
 public:
  Level(const Octree<Dim>& grid, const CoefficientFields<Dim>& reference, const CoefficientFields<Dim>& target,
        const ExperimentOptions& options)
      : options_(options),
        grid_(grid),
        sigma_(options.cascade.sigma_cells * grid.finest_side()),
        unknowns_(grid, options.energy.boundary),
        target_(grid, target.distance, target.normal, target.root),
        fields_{reference.distance, reference.normal, reference.root, !options.coefficients.invert_at_point},
        energy_(unknowns_, fields_, target_, options.energy, sigma_, options.energy.quadrature_order),
        hessian_(energy_, unknowns_, target_, options.energy) {}

  LevelResult minimise(int level, std::vector<Vec<Dim>>& phi, Observer& observer, bool& interrupted) {
    LevelResult result;
    LevelStart& start = result.start;
    start.level = level;
    start.sigma = sigma_;
    start.n_nodes = grid_.n_nodes();
    start.n_free_nodes = static_cast<Index>(grid_.free_nodes().size());
    start.n_cells = static_cast<Index>(grid_.leaves().size());
    result.n_band_cells = static_cast<Index>(energy_.band().n_elements());
    result.n_band_points = energy_.band().n_active_points();
    result.band_measure = energy_.band().measure();

    const std::vector<double> mass = lumped_mass_of(unknowns_.nodes());
    const auto steps = schedule_of_level(options_.cascade, level);
    start.n_substeps = static_cast<int>(steps.size());
    const auto minimizer = make_minimizer(options_.solver);
    const Metric metric = minimizer->uses_metric() ? options_.solver.metric : Metric::euclidean;
    TermValues weights;
    for (std::size_t s = 0; s < steps.size() && !interrupted; ++s) {
      start.substep = static_cast<int>(s) + 1;
      start.nu = steps[s].nu;
      start.volume_weight = steps[s].volume_weight;
      weights = term_weights(options_.energy, start.nu, start.volume_weight);
      LevelProblem<Dim> problem(unknowns_, energy_, hessian_, weights, mass, phi);
      std::vector<double> x = problem.unknowns_of(phi);
      StopOptions stop = options_.solver.stop;
      if (level < options_.cascade.max_level || s + 1 < steps.size())
        stop.relative_decrease = std::max(stop.relative_decrease, options_.cascade.intermediate_decrease);
      observer.level_started(start);
      result.last = minimize_in_metric(*minimizer, metric, problem, x, stop,
                                       [&](const IterationRecord& r) { return observer.iterated(start, r); });
      observer.level_finished(start, result.last);
      interrupted = result.last.reason == StopReason::interrupted;
      phi = problem.positions(x);
      result.iterations += result.last.iterations;
      result.value_evaluations += result.last.value_evaluations;
      result.gradient_evaluations += result.last.gradient_evaluations;
      result.seconds += result.last.seconds;
    }
    energy_.evaluate(phi, weights, result.minimised, {});
    // The solution overfits its own Gauss points: report with others.
    const int finer = std::max(4, options_.energy.quadrature_order + 1);
    const MatchingEnergy<Dim> report(unknowns_, fields_, target_, options_.energy, sigma_, std::min(finer, 5));
    report.evaluate(phi, weights, result.reported, {});
    result.folds = find_folds<Dim>(unknowns_.elements(), phi);
    return result;
  }

 private:
  std::vector<double> lumped_mass_of(std::span<const Index> nodes) const {
    const std::vector<double> all = lumped_mass(grid_);
    std::vector<double> mass;
    mass.reserve(nodes.size());
    for (const Index n : nodes) mass.push_back(all[grid_.free_index(n)]);
    return mass;
  }

  const ExperimentOptions& options_;
  const Octree<Dim>& grid_;
  double sigma_;
  Unknowns<Dim> unknowns_;
  TargetField<Dim> target_;
  ReferenceFields<Dim> fields_;
  MatchingEnergy<Dim> energy_;
  EnergyHessian<Dim> hessian_;
};

}  // namespace

template <int Dim>
CascadeResult<Dim> run_cascade(const SignedDistance<Dim>& reference, const SignedDistance<Dim>& template_shape,
                               const ExperimentOptions& options, Observer& observer, const LevelCallback<Dim>& finished,
                               PhaseSeconds& seconds) {
  const CascadeOptions& schedule = options.cascade;
  CascadeResult<Dim> result{Octree<Dim>(schedule.min_level), {}, {}, {}, {}, false};
  Octree<Dim>& grid = result.grid;
  result.phi = identity(grid);
  NodalDistance<Dim> d1(reference), d2(template_shape);

  for (int level = schedule.min_level;; ++level) {
    PhaseClock clock(seconds);
    clock.start("distances");
    const std::vector<double>& nodal1 = d1.on(grid);
    const std::vector<double>& nodal2 = d2.on(grid);
    clock.start("coefficients");
    auto coefficients = compute_coefficient_pair(grid, conforming(grid, nodal1), conforming(grid, nodal2),
                                                       options.coefficients);
    clock.start("set-up");
    Level<Dim> problem(grid, coefficients.reference, coefficients.target, options);
    clock.start("minimisation");
    result.levels.push_back(problem.minimise(level, result.phi, observer, result.interrupted));
    clock.start("output");
    if (finished) finished(result.levels.back(), {grid, result.phi, coefficients.reference, coefficients.target});
    if (level == schedule.max_level || result.interrupted) {
      result.reference = std::move(coefficients.reference);
      result.target = std::move(coefficients.target);
      break;
    }

    clock.start("refinement");
    const Index n_old = grid.n_nodes();
    grid.refine([&](Index leaf) {
      return meets_surface<Dim>(grid, nodal1, std::cref(reference), leaf) ||
             meets_surface<Dim>(grid, nodal2, std::cref(template_shape), leaf);
    });
    prolongate(grid, n_old, result.phi);
  }
  return result;
}

template CascadeResult<2> run_cascade<2>(const SignedDistance<2>&, const SignedDistance<2>&, const ExperimentOptions&,
                                         Observer&, const LevelCallback<2>&, PhaseSeconds&);
template CascadeResult<3> run_cascade<3>(const SignedDistance<3>&, const SignedDistance<3>&, const ExperimentOptions&,
                                         Observer&, const LevelCallback<3>&, PhaseSeconds&);

}  // namespace shellmatch
