#pragma once
/// \file
/// The findings of a check of the energy's derivatives, as text and as JSON.

#include "base/types.h"

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace shellmatch {

/// The Taylor remainder along one random direction. Steps are relative to the cells: a step of 1 moves a node by about
/// the side of the cells around it.
struct DirectionCheck {
  std::vector<double> steps, remainders, orders;
  double slope = 0;                       ///< derivative along the direction, by the gradient
  double curvature = 0;                   ///< second derivative along the direction, by differences
  std::optional<double> model_curvature;  ///< by the Newton model, which may drop terms of the second derivative
  /// Number of quadrature points that would cross a kink of the energy within the largest step. The direction is set to
  /// zero at the nodes of their elements.
  std::size_t n_points_near_faces = 0;
  double held_share = 0;  ///< share of the unknowns where the direction is zero for that reason, in [0, 1]
  bool resolved = false;  ///< whether three decades of steps lie above the rounding errors
};

/// The element whose gradient differs most from its reference, and the entry that differs most.
struct WorstElement {
  Index element = no_index;  ///< number in the order of the grid's leaves
  int level = 0;
  std::vector<double> centre;  ///< unit domain, reference frame
  int corner = 0, axis = 0;    ///< of the degree of freedom
  double analytic = 0;         ///< derivative by the assembly
  double by_jets = 0;          ///< by ceres::Jet
  double by_differences = 0;   ///< by central differences of the functor
};

/// Ceres' own GradientChecker on single elements.
struct CeresProbes {
  int n_elements = 0, n_failed = 0;
  double worst_relative_error = 0;
};

struct HessianCheck {
  double asymmetry = 0;       ///< |x.Hy - y.Hx| / sqrt(x.Hx y.Hy), largest of some random pairs
  double least_quotient = 0;  ///< smallest x.Hx / (|x| |Hx|); >= 0 for a positive semidefinite H
};

/// The results for one term, or for the sum of all.
struct TermCheck {
  enum class State { passed, failed, off, inactive, vanishing };
  std::string name;
  State state = State::off;
  double value = 0, gradient_norm = 0;
  std::vector<DirectionCheck> directions;
  double value_error = 0;     ///< value of the assembly against the sum of element functors, relative
  double gradient_error = 0;  ///< the same for the gradient by the unknowns, relative to its largest entry
  double element_error = 0;   ///< largest error of an element gradient against dual numbers, in units of its tolerance
  double difference_error = 0;  ///< largest error of an element gradient against differences, in units of its tolerance
  std::size_t n_elements = 0;   ///< elements on which the term is not zero
  std::size_t n_differenced = 0;          ///< of these, compared with differences
  std::size_t n_elements_near_faces = 0;  ///< of these, not compared: a point lies within one step of a kink
  std::size_t n_elements_with_kinks = 0;  ///< of these, with different one-sided derivatives, one the assembly's
  std::optional<WorstElement> worst;
  CeresProbes ceres;
  std::optional<HessianCheck> hessian;
  std::vector<std::string> faults;  ///< failures, one sentence each
  std::vector<std::string> notes;   ///< remarks on what could not be checked
};

/// The name of a state, as in JSON.
std::string_view name_of(TermCheck::State state);

struct GradientReport {
  std::string source, state;  ///< the experiment, and the deformation at which it was checked
  int dimension = 0, level = 0, substep = 0, iteration = 0;  ///< substep, iteration: 0 unless checked during a run
  Index n_nodes = 0, n_free_nodes = 0;
  double nu = 0, volume_weight = 0;
  std::vector<TermCheck> terms;  ///< in the order of the energy's terms, their sum last

  bool passed() const;
  /// Names of the terms with faults, separated by commas.
  std::string failed_terms() const;
  /// The same with the first fault of each in brackets, for a message.
  std::string faults() const;
};

/// A table with remarks, for people.
std::string gradient_report_text(const GradientReport& report);

/// The same figures as JSON, for programs.
std::string gradient_report_json(const GradientReport& report);

}  // namespace shellmatch
