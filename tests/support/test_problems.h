#pragma once
/// \file
/// Unconstrained minimisation problems with known answers, as objects that check a solution.

#include "solvers/library_options.h"
#include "solvers/objective.h"

#include <algorithm>
#include <memory>
#include <string>
#include <vector>

namespace shellmatch::testing {

/// Ceres' options for a test of what a method can reach: no tolerance of Ceres ends it.
inline CeresOptions without_tolerances() {
  CeresOptions options;
  options.function_tolerance = options.gradient_tolerance = options.parameter_tolerance = 0;
  return options;
}

/// A model of the second derivative that is the identity, for objectives of which Newton's method is asked no more than
/// good manners.
struct UnitModel : SecondOrderObjective {
  void prepare_second_derivative(std::span<const double>, std::span<const float>) override {}
  void apply_second_derivative(std::span<const double> x, std::span<double> y) const override {
    std::copy(x.begin(), x.end(), y.begin());
  }
  void precondition(std::span<const double> r, std::span<double> z) const override {
    std::copy(r.begin(), r.end(), z.begin());
  }
};

/// A smooth problem with a published start and minimum. Its model of the second derivative is 2 J^T J, with the
/// diagonal as preconditioner: the Gauss-Newton model for a sum of squares.
class TestProblem : public SecondOrderObjective {
 public:
  /// The entries of J at x: derivatives of the residuals where the value is the sum of their squares, else such that
  /// 2 J^T J is the second derivative.
  using Entries = std::vector<Eigen::Triplet<double>>;
  virtual Entries jacobian(std::span<const double> x) const = 0;
  void prepare_second_derivative(std::span<const double> x, std::span<const float> damping) override;
  void apply_second_derivative(std::span<const double> x, std::span<double> y) const override;
  void precondition(std::span<const double> r, std::span<double> z) const override;

  virtual std::string name() const = 0;
  virtual std::vector<double> start() const = 0;

  /// Values of the minimum and of local minima known in the literature.
  virtual std::vector<double> minima() const { return {0.0}; }

  /// The minimiser, or empty where there are several.
  virtual std::vector<double> minimizer() const { return {}; }

  /// Largest distance of a coordinate from the minimiser that a first-order method can be asked for; wide
  /// where the second derivative is singular there.
  virtual double coordinate_tolerance() const { return 1e-3; }

  /// Empty where value and point solve the problem; else what is wrong.
  std::string check(double value, const std::vector<double>& x, double value_tolerance) const;

 private:
  Eigen::SparseMatrix<double> hessian_;
};

/// The problems of More, Garbow & Hillstrom, Testing unconstrained optimization software, ACM TOMS 7 (1981),
/// with their numbers: Rosenbrock (1), Powell singular (13), Wood (14), Beale (5), helical valley (7),
/// trigonometric (26, n = 10), extended Rosenbrock (21) and extended Powell (22), each of n = 100 and 1000.
std::vector<std::unique_ptr<TestProblem>> more_garbow_hillstrom();

/// Extended Rosenbrock with n unknowns, n even: a large problem with second derivatives of condition 2500.
std::unique_ptr<TestProblem> extended_rosenbrock(std::size_t n);

/// 1/2 |x - b|^2 - mu log(a.x), which cannot be evaluated where a.x <= 0; b lies there, so every method has
/// to find its way along the edge. The minimiser is known in closed form. `n` unknowns.
std::unique_ptr<TestProblem> log_barrier(std::size_t n, double mu);

/// A sum of two named terms on n unknowns with a lumped mass of widely different sizes:
/// sum m_i/2 (x_i - c_i)^2 + sum m_i/4 (x_i - c_i)^4. In the metric l2 its second derivative at the minimum
/// is 1. Where n is a multiple of 3 it has matrices for h1 and h1_band too, of a chain of nodes.
std::unique_ptr<TestProblem> weighted_bowl(std::size_t n);

}  // namespace shellmatch::testing
