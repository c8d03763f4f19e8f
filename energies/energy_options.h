#pragma once
/// \file
/// What can be chosen of the energy. Lengths are in units of the domain's side.

#include "base/options.h"
#include "energies/elements/unknowns.h"
#include "energies/terms/term_values.h"

#include <cstddef>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace shellmatch {

/// Names of the terms, in the order of TermValues.
const std::vector<std::string_view>& term_names();

/// Weights, models and own options of the terms in energies/terms/list.h, whose files describe them.
class TermOptions {
 public:
  TermOptions();

  /// The user's factor on a term; 0 switches it off.
  double& factor(Term t) { return factors_[static_cast<std::size_t>(t)]; }
  double factor(Term t) const { return factors_[static_cast<std::size_t>(t)]; }
  /// Which of the terms of this name.
  Choice& model(Term t) { return models_[static_cast<std::size_t>(t)]; }
  const Choice& model(Term t) const { return models_[static_cast<std::size_t>(t)]; }
  /// An option of a term's own, such as "fold_threshold". \pre there is one of this name
  double& own(std::string_view name);
  double own(std::string_view name) const;

  /// Place in energies/terms/list.h of the chosen term of this name.
  std::size_t chosen(Term t) const;
  /// The own options of the term at this place, in its order.
  const double* own_of(std::size_t place) const { return own_.data() + first_own(place); }

  /// Names every option of the terms to a visitor (base/options.h).
  static void describe_factors(auto& self, auto& visit) {
    for (std::size_t t = 0; t < self.factors_.size(); ++t) {
      const Described option = factor_option(t);
      visit(option.name, self.factors_[t], option.info);
    }
  }
  static void describe_models(auto& self, auto& visit) {
    for (std::size_t t = 0; t < self.models_.size(); ++t)
      if (self.models_[t].names().size() > 1)
        visit(term_names()[t], self.models_[t], OptionInfo{.meaning = model_meaning(t)});
    for (std::size_t i = 0; i < self.own_.size(); ++i) visit(own_option(i).name, self.own_[i], own_option(i).info);
  }

 private:
  struct Described {
    std::string_view name;
    OptionInfo info;
  };
  static Described factor_option(std::size_t t);
  static std::string_view model_meaning(std::size_t t);  ///< "model: meaning; ..." of all models
  static Described own_option(std::size_t i);
  static std::size_t first_own(std::size_t place);

  std::vector<double> factors_;
  std::vector<Choice> models_;
  std::vector<double> own_;  ///< of all terms, in the order of the list
};

/// What evaluates value and gradient.
enum class Evaluator { compiled, ceres };
template <>
struct EnumNames<Evaluator> {
  static constexpr std::pair<Evaluator, std::string_view> names[] = {{Evaluator::compiled, "compiled"},
                                                                     {Evaluator::ceres, "ceres"}};
};

/// Weights and material of the terms in energies/terms/list.h.
struct EnergyOptions {
  double lambda = 1, mu = 1;
  double delta = 1;
  TermOptions terms;
  BoundaryCondition boundary = BoundaryCondition::neumann;
  int quadrature_order = 2;
  Evaluator evaluator = Evaluator::compiled;
  static void describe(auto& self, auto& visit) {
    visit("lambda", self.lambda, {.unit = "energy/volume", .min = 0, .meaning = "first Lame coefficient of W"});
    visit("mu", self.mu,
          {.unit = "energy/volume",
           .min = 0,
           .min_excluded = true,
           .meaning = "second Lame coefficient (shear modulus) of W"});
    visit("delta", self.delta,
          {.unit = "length", .min = 0, .meaning = "thickness of the shell: membrane weighs delta, bending delta^3"});
    TermOptions::describe_factors(self.terms, visit);
    TermOptions::describe_models(self.terms, visit);
    visit("boundary", self.boundary, {.meaning = "neumann: the domain's boundary is free; dirichlet: phi = id there"});
    visit("quadrature_order", self.quadrature_order,
          {.unit = "points per direction",
           .min = 1,
           .max = 5,
           .meaning = "Gauss points for minimising; reported energies take one more, at most 5"});
    visit("evaluator", self.evaluator,
          {.meaning = "compiled: value and gradient by vector code made from the terms' functors; ceres: by "
                      "ceres::AutoDiffCostFunction of the same functors on every element, some 50 times slower"});
  }
};

/// Weights of the terms for given nu and c_vol: the options' factors, scaled as each term says.
TermValues term_weights(const EnergyOptions& options, double nu, double volume_weight);

/// Does a chosen term read the shape operators themselves, and not roots of classified ones?
bool reads_shape_operators(const EnergyOptions& options);

}  // namespace shellmatch
