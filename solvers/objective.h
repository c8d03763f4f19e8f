#pragma once
/// \file
/// The interface of a problem to the solvers.

#include "base/options.h"

#include <Eigen/SparseCore>

#include <cstddef>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace shellmatch {

/// The inner products in which gradients can be taken (docs/solvers.md): Euclidean, the lumped mass matrix
/// (Objective::lumped_mass), and two matrices that couple the nodes (Objective::metric_matrix).
enum class Metric { euclidean, l2, h1, weighted_h1 };
template <>
struct EnumNames<Metric> {
  static constexpr std::pair<Metric, std::string_view> names[] = {
      {Metric::euclidean, "euclidean"}, {Metric::l2, "l2"}, {Metric::h1, "h1"}, {Metric::weighted_h1, "h1_band"}};
};

class SecondOrderObjective;

/// A function of n real unknowns, a sum of named terms.
class Objective {
 public:
  virtual ~Objective() = default;

  /// Number of unknowns.
  virtual std::size_t size() const = 0;

  /// Value at x, and the Euclidean gradient if `gradient` is not empty (its size is then size()). Returns
  /// false where the function cannot be evaluated (a fold under a barrier, anything not finite); value and
  /// gradient are then undefined and the solver must shorten its step.
  virtual bool evaluate(std::span<const double> x, double& value, std::span<double> gradient) = 0;

  /// Names of the terms whose sum is the value; may be empty.
  virtual std::vector<std::string> term_names() const { return {}; }

  /// Weighted values of the terms at the last point that was evaluated, in the order of term_names().
  virtual std::vector<double> term_values() const { return {}; }

  /// Diagonal of the lumped mass matrix, one positive number for each unknown: the L2 metric. Empty if the
  /// problem has none; the L2 metric is then Euclidean.
  virtual std::span<const double> lumped_mass() const { return {}; }

  /// Matrix of the metric h1 or weighted_h1: symmetric positive definite with both triangles stored, one row
  /// for each node. Unknown n_components * i + k is component k of node i, and size() is n_components times
  /// the number of rows. Empty if the problem has none. The weights of weighted_h1 are the objective's
  /// choice.
  virtual Eigen::SparseMatrix<double> metric_matrix(Metric /*metric*/) const { return {}; }

  /// Which part of the value or the gradient is infinite or NaN at x, in words for a message; empty where all is finite
  /// or nothing is known. It may take long: solvers ask where they cannot go on for that reason.
  virtual std::string what_is_not_finite(std::span<const double> /*x*/) { return {}; }

  /// This objective as one that offers a model of its second derivative; null where it does not.
  virtual SecondOrderObjective* second_order() { return nullptr; }

  /// L2 norm of the L2 gradient (Euclidean if there is no mass) for the Euclidean `gradient` that evaluate()
  /// returned last. The records contain it for every method and metric.
  virtual double l2_gradient_norm(std::span<const double> gradient) const;
};

/// A region of the problem, such as a cell, and a factor on its damping matrix.
struct RegionDamping {
  std::size_t region;
  double factor;
};

/// An objective that offers a positive semidefinite model H of its second derivative. Its unknowns may be divided into
/// regions r, each with a positive semidefinite damping matrix D_r that can be added to the model.
class SecondOrderObjective : public Objective {
 public:
  SecondOrderObjective* second_order() override { return this; }

  /// Computes H at x, where the objective has been evaluated, plus the sum of damping[r] D_r.
  /// \param damping  one factor for each region, or empty: none
  virtual void prepare_second_derivative(std::span<const double> x, std::span<const float> damping) = 0;
  /// y = H x with the H prepared last.
  virtual void apply_second_derivative(std::span<const double> x, std::span<double> y) const = 0;
  /// z = B^{-1} r, where B is symmetric positive definite and spectrally close to H.
  virtual void precondition(std::span<const double> r, std::span<double> z) const = 0;

  /// The same as what_is_not_finite() of H at x.
  virtual std::string what_of_model_is_not_finite(std::span<const double> /*x*/) { return {}; }

  /// Number of regions that can be damped; 0: none.
  virtual std::size_t n_regions() const { return 0; }
  /// The regions in which the step d from x leads beyond where H models the objective, with the factor that makes D_r
  /// as stiff as H is there.
  virtual std::vector<RegionDamping> regions_beyond_model(std::span<const double> /*x*/,
                                                          std::span<const double> /*d*/) {
    return {};
  }
  /// Adds factor * D_r to H for each of these regions.
  virtual void add_damping(std::span<const RegionDamping> /*regions*/) {}
  /// Adds to H what the step d from x activates and H at x does not know of, and the same to the gradient of the model
  /// at x, of which d is the descent. Returns whether there was any that had not been added since H was prepared.
  virtual bool extend_model(std::span<const double> /*x*/, std::span<const double> /*d*/,
                            std::span<double> /*gradient*/) {
    return false;
  }
  /// Brings the step d in each of these regions nearer to one that leads nowhere beyond the model: of what would, this
  /// share stays.
  virtual void contract_step(std::span<const RegionDamping> /*regions*/, double /*share*/, std::span<double> /*d*/) {}
};

}  // namespace shellmatch
