#pragma once
/// \file
/// Regularisation of Newton's steps region by region (Levenberg-Marquardt damping, locally): where a step leads
/// beyond what the model of the second derivative knows of, the model is made stiffer there and the step computed
/// again.

#include "solvers/objective.h"
#include "solvers/solver_options.h"

#include <span>
#include <vector>

namespace shellmatch {

/// The policy, and its state during one minimisation: the damping factor of every region.
class StepRegularisation {
 public:
  StepRegularisation(const NewtonOptions& options, const SecondOrderObjective& objective)
      : options_(options), damping_(objective.n_regions(), 0.0F) {}

  /// The factors with which the next model is to be prepared: those of the last one, faded.
  std::span<const float> next_damping();

  /// In place of next_damping() where the next step has the last one's model.
  void keep_damping() { n_of_step_ = 0; }

  /// Damps the regions that the step d from x would carry beyond the model, more than before, and extends the model and
  /// its gradient by what d meets (`extend_model`). False where there is neither, or where d has been computed
  /// `max_regularisations` times again.
  bool regularise(SecondOrderObjective& objective, std::span<const double> x, std::span<const double> d,
                  std::span<double> gradient);

  /// Where the step of the last system still leads beyond the model in single regions: halves it there
  /// (`contract_step`) and examines again, as neighbours may now be beyond, `max_contractions` times at most; if
  /// regions are left, halves the whole step, which shortens it for all regions and therefore comes last. d is not
  /// changed if the result were no direction of descent. \param g  the gradient at x
  void contract(SecondOrderObjective& objective, std::span<const double> x, std::span<const double> g,
                std::span<double> d);

  /// Has this step been computed again as often as may be? Its last system may still lead beyond the model.
  bool is_restrained() const { return n_of_step_ > 0 && n_of_step_ == options_.max_regularisations; }

  long n_systems() const { return n_systems_; }  ///< that were regularised so far

 private:
  const NewtonOptions& options_;
  std::vector<float> damping_;
  int n_of_step_ = 0;  ///< systems that were regularised for this step
  long n_systems_ = 0;
};

}  // namespace shellmatch
