#pragma once
/// \file
/// What a check of the energy's derivatives has found, and how it is told.

#include "base/types.h"

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace shellmatch {

/// The Taylor remainder along one random direction. Steps are in cells: a step of 1 moves nodes by about the side
/// of the cells around them.
struct DirectionCheck {
  std::vector<double> steps, remainders, orders;
  double slope = 0;            ///< derivative along the direction, by the gradient
  double curvature = 0;        ///< second derivative along it, by differences
  std::optional<double> model_curvature;  ///< by the Newton model; not the same where the model drops something
  /// Points that would have passed into another cell of the target within the greatest step, where the energy has a
  /// kink. The direction is zero around them.
  std::size_t n_points_near_faces = 0;
  double held_share = 0;       ///< of the unknowns, those where the direction is zero for that reason
  bool resolved = false;       ///< did three decades fit between rounding and the reach of the direction?
};

/// Where the element gradients differ most from their reference.
struct WorstElement {
  Index element = no_index;    ///< number in the order of the grid's leaves
  int level = 0;
  std::vector<double> centre;  ///< unit domain, reference frame
  int corner = 0, axis = 0;    ///< of the derivative that differs most
  double analytic = 0;         ///< that derivative as the assembly has it
  double by_jets = 0;          ///< as Ceres' dual numbers have it
  double by_differences = 0;   ///< and as central differences of the functor have it
};

/// Ceres' own GradientChecker on single elements.
struct CeresProbes {
  int n_elements = 0, n_failed = 0;
  double worst_relative_error = 0;
};

struct HessianCheck {
  double asymmetry = 0;       ///< |x.Hy - y.Hx| relative to sqrt(x.Hx y.Hy), the worst of some random pairs
  double least_quotient = 0;  ///< smallest x.Hx / (|x| |Hx|): >= 0 for a positive semidefinite H
};

/// One term, or the sum of them.
struct TermCheck {
  enum class State { passed, failed, off, inactive, vanishing };
  std::string name;
  State state = State::off;
  double value = 0, gradient_norm = 0;
  std::vector<DirectionCheck> directions;
  double value_error = 0;      ///< assembly against the sum of element functors, relative
  double gradient_error = 0;   ///< the same for the gradient by the unknowns, relative to its largest entry
  double element_error = 0;    ///< greatest error of an element gradient against the functor, in units of its tolerance
  double difference_error = 0; ///< the same against central differences
  std::size_t n_elements = 0;  ///< on which the term acts
  std::size_t n_differenced = 0;          ///< of these, compared with differences
  std::size_t n_elements_near_faces = 0;  ///< of these, left out: a point lies within the step of a cell's face
  std::size_t n_elements_with_kinks = 0;  ///< of these, with different derivatives to both sides, one of them ours
  std::optional<WorstElement> worst;
  CeresProbes ceres;
  std::optional<HessianCheck> hessian;
  std::vector<std::string> faults;  ///< what did not pass, one sentence each
  std::vector<std::string> notes;   ///< what the check could not tell
};

struct GradientReport {
  std::string source, state;  ///< the experiment and the deformation it was checked at
  int dimension = 0, level = 0, substep = 0, iteration = 0;  ///< the last two where a run was checked on its way
  Index n_nodes = 0, n_free_nodes = 0;
  double nu = 0, volume_weight = 0;
  std::vector<TermCheck> terms;  ///< in the order of the energy's terms, the sum last

  bool passed() const;
  /// Names of what failed, with commas.
  std::string failed_terms() const;
};

/// As a table with remarks, for people.
std::string gradient_report_text(const GradientReport& report);

/// For machines.
std::string gradient_report_json(const GradientReport& report);

}  // namespace shellmatch
