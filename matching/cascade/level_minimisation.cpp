#include "matching/cascade/level_minimisation.h"

#include "base/error.h"
#include "energies/assembly/energy_report.h"
#include "energies/terms/term_names.h"
#include "matching/derivative_check/gradient_check.h"
#include "matching/experiment/level_solver.h"
#include "matching/level/level_energy.h"
#include "matching/level/level_problem.h"
#include "solvers/methods/fallback.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

namespace shellmatch {

namespace {

// Minimisations of a level between which its mask follows phi.
constexpr int mask_rounds = 2;

}  // namespace

template <int Dim>
LevelMinimisation<Dim>::LevelMinimisation(const Octree<Dim>& grid, GeometryPair<Dim> geometry,
                                          const ExperimentOptions& options, const PointTerms<Dim>& points,
                                          const ObservedPair<Dim>& observed)
    : options_(options),
      grid_(grid),
      level_(grid, std::move(geometry), options, observed),
      mass_(level_.unknown_mass()) {
  points.add_to(level_);
}

template <int Dim>
LevelStart LevelMinimisation<Dim>::start_of(int level) const {
  LevelStart start;
  start.level = level;
  start.sigma = level_.sigma;
  start.n_nodes = grid_.n_nodes();
  start.n_free_nodes = static_cast<Index>(grid_.free_nodes().size());
  start.n_cells = static_cast<Index>(grid_.leaves().size());
  return start;
}

template <int Dim>
LevelResult LevelMinimisation<Dim>::minimise(int level, std::vector<Vec<Dim>>& phi, bool is_start, Observer& observer,
                                             bool& interrupted) {
  LevelResult result;
  LevelStart& start = result.start;
  start = start_of(level);
  result.n_band_cells = static_cast<Index>(level_.energy.band().n_elements());
  result.n_band_points = level_.energy.band().n_active_points();
  result.band_measure = level_.energy.band().measure();

  const auto steps = schedule_of_level(options_.cascade, level);
  const int rounds = std::max(level_.terms->follow_phi() ? options_.coverage.rounds : 1, level_.mask ? mask_rounds : 1);
  start.n_substeps = static_cast<int>(steps.size()) * rounds;
  result.term_names = level_.energy.term_names();
  const SolverOptions solver = solver_at_level(options_.solver, level);
  TermValues weights;
  level_.refresh(phi);
  std::optional<LevelProblem<Dim>> ahead;
  if (steps.size() > 1 && options_.cascade.negligible_start_rise > 0) {
    ahead.emplace(problem_of(solver, level_.weights(options_, steps.back().nu, steps.back().volume_weight), phi));
    if (!begins_with_last(steps, *ahead, phi)) ahead.reset();
  }
  const std::size_t first = ahead ? steps.size() - 1 : 0;
  std::vector<double> terms;  // values at the end of the last minimisation; empty if it could not begin
  for (std::size_t s = first; s < steps.size() && !interrupted;) {
    start.nu = steps[s].nu;
    start.volume_weight = steps[s].volume_weight;
    weights = level_.weights(options_, start.nu, start.volume_weight);
    for (int round = 0; round < rounds && !interrupted; ++round) {
      start.substep = static_cast<int>(s) * rounds + round + 1;
      StopOptions stop = solver.stop;
      const bool ends_level = s + 1 == steps.size() && round + 1 == rounds;
      stop.relative_decrease = relative_decrease(options_.cascade, solver,
                                                 !ends_level                          ? Followed::on_level
                                                 : level < options_.cascade.max_level ? Followed::by_level
                                                                                      : Followed::by_nothing);
      if (!ends_level || level < options_.cascade.max_level) stop.restrained_factor = 1;  // what follows builds on it
      LevelProblem<Dim> problem = ahead ? *std::exchange(ahead, std::nullopt) : problem_of(solver, weights, phi);
      terms = minimise_once(start, std::move(problem), weights, solver, stop, phi, observer, result);
      interrupted = result.last.reason == StopReason::interrupted;
      const bool is_refused = result.last.reason == StopReason::cannot_evaluate_start;
      if (is_refused && is_start && s == first && round == 0) refuse_start(level, phi, weights, result.last.message);
      if (!ends_level && !interrupted) level_.refresh(phi);
    }
    const double negligible = options_.cascade.negligible_rise * std::abs(result.last.final_value);
    s = terms.empty() ? s + 1 : step_after(s, steps.size(), rise_at(steps.back(), terms, weights), negligible);
  }
  if (terms.size() == weights.size()) {
    result.minimised = TermValues(terms.size());
    for (std::size_t t = 0; t < terms.size(); ++t) result.minimised[t] = terms[t];
  } else {
    level_.energy.evaluate(phi, weights, result.minimised, {});
  }
  weights_ = weights;
  return result;
}

template <int Dim>
void LevelMinimisation<Dim>::report(const std::vector<Vec<Dim>>& phi, LevelResult& result) const {
  const int finer = std::min(options_.energy.quadrature_order + 1, 5);
  const EnergyReport report = report_energy<Dim>(level_.unknowns, level_.geometry, options_.energy, level_.sigma, finer,
                                                 phi, weights_, level_.mask ? &*level_.mask : nullptr);
  result.reported = report.values;
  result.reported.extend_to(weights_.size());
  level_.energy.set_point_values(phi, weights_, result.reported);
  result.band = report.band;
  result.folds = find_folds<Dim>(level_.unknowns.elements(), phi);
}

template <int Dim>
LevelProblem<Dim> LevelMinimisation<Dim>::problem_of(const SolverOptions& solver, const TermValues& weights,
                                                     const std::vector<Vec<Dim>>& phi) {
  return {level_.unknowns, level_.energy, level_.hessian, weights, mass_, phi, [this, &solver, weights](Metric metric) {
            return level_metric(level_, solver, weights, metric);
          }};
}

template <int Dim>
bool LevelMinimisation<Dim>::begins_with_last(const std::vector<ScheduleStep>& steps, LevelProblem<Dim>& last,
                                              const std::vector<Vec<Dim>>& phi) const {
  if (!last.evaluate_ahead(last.unknowns_of(phi))) return false;
  const std::vector<double> terms = last.term_values();
  TermValues weights = level_.weights(options_, steps.back().nu, steps.back().volume_weight);
  double energy = 0;
  for (const double term : terms) energy += term;
  for (std::size_t t = 0; t < terms.size(); ++t) {
    if (!(*level_.terms)[t].renewal) continue;
    // Its points are new on this level, and their energy at first mostly what they ask for beyond the level before.
    energy -= terms[t];
    weights[t] = 0;
  }
  const double rise = -rise_at(steps.front(), terms, weights);
  return rise < options_.cascade.negligible_start_rise * std::abs(energy - rise);
}

template <int Dim>
double LevelMinimisation<Dim>::rise_at(const ScheduleStep& step, const std::vector<double>& terms,
                                       const TermValues& weights) const {
  const TermValues at_step = level_.weights(options_, step.nu, step.volume_weight);
  double rise = 0;
  for (std::size_t t = 0; t < terms.size(); ++t)
    if (weights[t] > 0) rise += terms[t] * (at_step[t] / weights[t] - 1);
  return rise;
}

// One minimisation from phi, which is replaced by its result. Adds its costs to `result` and returns the values of the
// terms at its end.
template <int Dim>
std::vector<double> LevelMinimisation<Dim>::minimise_once(const LevelStart& start, LevelProblem<Dim> problem,
                                                          const TermValues& weights, const SolverOptions& solver,
                                                          const StopOptions& stop, std::vector<Vec<Dim>>& phi,
                                                          Observer& observer, LevelResult& result) {
  std::vector<double> x = problem.unknowns_of(phi);
  std::vector<Vec<Dim>>().swap(phi);  // the problem has the fixed nodes
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
    result.fallbacks.push_back(
        fmt::format("level {}, step {}: {}; phi stays as it is", start.level, start.substep, result.last.message));
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
  result.library_reports.insert(result.library_reports.end(), result.last.library_reports.begin(),
                                result.last.library_reports.end());
  return terms;
}

// The energy is not finite at the start of the very first minimisation: names the terms that cause it. The solver's
// message names the first place.
template <int Dim>
void LevelMinimisation<Dim>::refuse_start(int level, const std::vector<Vec<Dim>>& phi, const TermValues& weights,
                                          const std::string& message) const {
  std::string which;
  const std::vector<std::string> names = level_.energy.term_names();
  for (std::size_t t = 0; t < weights.size(); ++t) {
    TermValues alone(weights.size()), values;
    alone[t] = weights[t];
    if (alone[t] != 0 && !level_.energy.evaluate(phi, alone, values, {}))
      which += fmt::format("{}{} (weight {:.3g})", which.empty() ? "" : ", ", names[t], alone[t]);
  }
  throw_input_error(
      "level {}: the energy cannot be evaluated where the first minimisation begins, as it is no finite number: {} "
      "({}); choose other weights or parameters of it (energy.*, cascade.*, coefficients.*, landmarks.*)",
      level, which.empty() ? "the sum of its terms" : which, message);
}

// Checks the derivatives at the positions evaluated last, which are the iterate or a trial point near it. The Newton
// model is not checked, because the minimiser may still use the assembled one.
template <int Dim>
void LevelMinimisation<Dim>::check(int iteration, const LevelStart& start, const std::vector<Vec<Dim>>& phi,
                                   const TermValues& weights, Observer& observer) {
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

template class LevelMinimisation<2>;
template class LevelMinimisation<3>;

}  // namespace shellmatch
