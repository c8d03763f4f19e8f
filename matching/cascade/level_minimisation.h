#pragma once
/// \file
/// The minimisations on the grid of one level.

#include "energies/assembly/band_report.h"
#include "energies/assembly/folds.h"
#include "energies/terms/term_values.h"
#include "grid/octree/octree.h"
#include "matching/cascade/schedule.h"
#include "matching/experiment/options.h"
#include "matching/level/level_energy.h"
#include "matching/level/level_problem.h"
#include "matching/pairs/coverage.h"
#include "matching/progress/observer.h"
#include "solvers/minimizer.h"

#include <cstddef>
#include <string>
#include <vector>

namespace shellmatch {

/// The result of one level.
struct LevelResult {
  std::vector<std::string> term_names;  ///< of `minimised` and `reported`
  LevelStart start;                     ///< of the level's last minimisation
  Index n_band_cells = 0;
  std::size_t n_band_points = 0;
  double band_measure = 0;  ///< integral of eta_sigma(d1); tends to the measure of M1
  TermValues minimised;     ///< weighted terms by the quadrature of the minimisation
  TermValues reported;      ///< weighted terms by a finer quadrature
  FoldReport folds;
  BandReport band;                             ///< by the finer quadrature
  MinimizerSummary last;                       ///< summary of the level's last minimisation
  std::vector<LibraryReport> library_reports;  ///< of all minimisations by a library that has one, in their order
  std::vector<std::string> fallbacks;  ///< one entry for each method that gave up: which, why, and its successor
  int iterations = 0;                  ///< sum over the level's minimisations
  long value_evaluations = 0, gradient_evaluations = 0;
  long linear_iterations = 0, regularised_systems = 0;
  double seconds = 0;
  double memory_estimate = 0,
         memory_peak = 0;  ///< resident bytes: as expected before the level, and the run's peak after it
};

/// The energy on one grid and its minimisations, which start from phi and replace it by their result.
template <int Dim>
class LevelMinimisation {
 public:
  /// \param grid, options  outlive this object
  /// \param points         added to the energy; outlive this object
  /// \param observed       what the shapes have data of: the terms of the band are masked elsewhere
  LevelMinimisation(const Octree<Dim>& grid, GeometryPair<Dim> geometry, const ExperimentOptions& options,
                    const PointTerms<Dim>& points, const ObservedPair<Dim>& observed);

  /// All steps of the schedule of `level`. \param is_start phi has not been minimised on any level
  /// \param interrupted set where the observer ends it
  /// \throws InputError where is_start and the energy of phi is no finite number
  LevelResult minimise(int level, std::vector<Vec<Dim>>& phi, bool is_start, Observer& observer, bool& interrupted);

  /// Adds the energy by a finer quadrature, the measures of the band and the folds to the result of minimise().
  void report(const std::vector<Vec<Dim>>& phi, LevelResult& result) const;

 private:
  LevelStart start_of(int level) const;
  LevelProblem<Dim> problem_of(const SolverOptions& solver, const TermValues& weights,
                               const std::vector<Vec<Dim>>& phi);
  /// Whether phi, as the level before left it, goes to the last step of the schedule at once: where that raises the
  /// energy that it has in the first step, terms that follow phi aside, by less than cascade.negligible_start_rise.
  /// Evaluates the last step's problem ahead.
  bool begins_with_last(const std::vector<ScheduleStep>& steps, LevelProblem<Dim>& last,
                        const std::vector<Vec<Dim>>& phi) const;
  /// By how much the energy of the present phi, the sum of `terms` with these weights, would rise with the weights of
  /// another step.
  double rise_at(const ScheduleStep& step, const std::vector<double>& terms, const TermValues& weights) const;
  std::vector<double> minimise_once(const LevelStart& start, LevelProblem<Dim> problem, const TermValues& weights,
                                    const SolverOptions& solver, const StopOptions& stop, std::vector<Vec<Dim>>& phi,
                                    Observer& observer, LevelResult& result);
  [[noreturn]] void refuse_start(int level, const std::vector<Vec<Dim>>& phi, const TermValues& weights,
                                 const std::string& message) const;
  void check(int iteration, const LevelStart& start, const std::vector<Vec<Dim>>& phi, const TermValues& weights,
             Observer& observer);

  const ExperimentOptions& options_;
  const Octree<Dim>& grid_;
  LevelEnergy<Dim> level_;
  std::vector<double> mass_;  ///< lumped, of each unknown node
  TermValues weights_;        ///< of the last minimisation
};

}  // namespace shellmatch
