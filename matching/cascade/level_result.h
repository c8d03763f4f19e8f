#pragma once
/// \file
/// What is known of a level when its minimisations are done.

#include "energies/assembly/band_report.h"
#include "energies/assembly/folds.h"
#include "energies/terms/term_values.h"
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

}  // namespace shellmatch
