#pragma once
/// \file
/// Options of the minimisers. Symbols and equations are those of Nocedal & Wright, Numerical Optimization,
/// 2nd edition (2006).

#include "base/options.h"
#include "solvers/library_options.h"
#include "solvers/minimizer.h"

#include <memory>
#include <string>
#include <vector>

namespace shellmatch {

/// Interpolation by which a step that was too long is shortened.
enum class Interpolation { halving, quadratic, cubic };
template <>
struct EnumNames<Interpolation> {
  static constexpr std::pair<Interpolation, std::string_view> names[] = {
      {Interpolation::halving, "halving"}, {Interpolation::quadratic, "quadratic"}, {Interpolation::cubic, "cubic"}};
};

/// Choice of the first trial of a line search of conjugate gradients, from the previous step.
enum class InitialStep { memory, slope, decrease, curvature };
template <>
struct EnumNames<InitialStep> {
  static constexpr std::pair<InitialStep, std::string_view> names[] = {{InitialStep::memory, "memory"},
                                                                       {InitialStep::slope, "slope"},
                                                                       {InitialStep::decrease, "decrease"},
                                                                       {InitialStep::curvature, "curvature"}};
};

/// The factor beta of conjugate gradients.
enum class ConjugateUpdate { fletcher_reeves, bounded_polak_ribiere };
template <>
struct EnumNames<ConjugateUpdate> {
  static constexpr std::pair<ConjugateUpdate, std::string_view> names[] = {
      {ConjugateUpdate::fletcher_reeves, "fletcher_reeves"},
      {ConjugateUpdate::bounded_polak_ribiere, "bounded_polak_ribiere"}};
};

/// The paper's method, solvers/methods/fletcher_reeves.h. Exactly as in the paper it is interpolation =
/// halving, initial_step = memory, step_growth = 1, update = fletcher_reeves, curvature = 0, orthogonality =
/// 0, least_cosine = 0.
struct FletcherReevesOptions {
  double armijo = 1e-4;
  double curvature = 0;
  Interpolation interpolation = Interpolation::cubic;
  double contraction = 0.5;
  InitialStep initial_step = InitialStep::curvature;
  double step_growth = 2;
  double first_step = 0.01;
  ConjugateUpdate update = ConjugateUpdate::fletcher_reeves;
  int restart_every = 0;
  double orthogonality = 0;
  double least_cosine = 0.03;
  int max_trials = 40;
  int gradient_trials = 2;
  static void describe(auto& self, auto& visit) {
    visit("interpolation", self.interpolation,
          {.meaning = "how a step that was too long is shortened: by `contraction` (halving, the paper's), or to the "
                      "minimum of a parabola or a cubic, kept within 0.1 to 0.8 of it"});
    visit(
        "initial_step", self.initial_step,
        {.meaning = "first trial alpha of a line search: memory, the last one accepted times `step_growth`; slope, the "
                    "same first-order change as in the last step (page 59) times `step_growth`; decrease, from the "
                    "last decrease (3.60); curvature, the minimum if the function bends along the new direction as it "
                    "did along the last; all but memory are kept within a tenth and ten times of the last one"});
    visit("step_growth", self.step_growth,
          {.min = 1,
           .max = 100,
           .meaning = "factor of initial_step = memory and slope, and of curvature where the function has not bent "
                      "upwards; 1 lets the step only shrink, as the paper's words can be read"});
    visit("update", self.update,
          {.meaning =
               "beta: the paper's, or Polak and Ribiere's kept within plus and minus Fletcher and Reeves' (5.48)"});
    visit("least_cosine", self.least_cosine,
          {.min = 0,
           .max = 0.9,
           .meaning = "restart where the cosine of the angle between direction and steepest descent is smaller (the "
                      "method jams there); 0 restarts only where the direction does not go down"});
  }
};

/// Limited-memory BFGS, solvers/methods/lbfgs.h.
struct LbfgsOptions {
  int memory = 12;
  double armijo = 1e-4;
  double curvature = 0.9;
  Interpolation interpolation = Interpolation::cubic;
  double contraction = 0.5;
  double first_step = 0.01;
  double least_cosine = 1e-8;
  int max_trials = 40;
  static void describe(auto& self, auto& visit) {
    visit("memory", self.memory,
          {.unit = "pairs of vectors",
           .min = 1,
           .max = 200,
           .meaning = "steps from which second derivatives are estimated; each costs two vectors of memory"});
  }
};

/// Newton's method with an inexact linear solver, solvers/methods/newton.h.
struct NewtonOptions {
  double armijo = 1e-4;
  double max_forcing = 0.1, min_forcing = 0.1;
  int max_linear_iterations = 60;
  double reuse_below = 0.25;
  int max_regularisations = 3, max_contractions = 500;
  double regularisation_growth = 8, regularisation_decay = 0.25;
  int max_trials = 30;
  static void describe(auto& self, auto& visit) {
    visit("max_forcing", self.max_forcing,
          {.min = 0,
           .max = 0.9,
           .min_excluded = true,
           .meaning = "the linear system is solved to this share of its residual where the model predicts badly, and "
                      "to the root of the relative gradient norm where that is smaller"});
  }
};

struct SolverOptions {
  std::string name = "fletcher_reeves";
  Metric metric = Metric::l2;
  double h1_length = 0.1;
  std::vector<std::string> fallback = {"auto"};
  StopOptions stop;
  FletcherReevesOptions fletcher_reeves;
  LbfgsOptions lbfgs;
  NewtonOptions newton;
  CeresOptions ceres;
  static void describe(auto& self, auto& visit) {
    visit(
        "name", self.name,
        {.meaning =
             "the method: fletcher_reeves (the paper's), lbfgs, newton, ceres_steepest_descent, ceres_ncg, ceres_bfgs, "
             "ceres_lbfgs, nlopt_lbfgs, nlopt_var1, nlopt_var2, nlopt_mma or nlopt_ccsaq"});
    visit("metric", self.metric,
          {.meaning = "the inner product in which gradients are taken: euclidean, l2 (lumped mass), h1 (mass + "
                      "h1_length^2 stiffness), h1_band (a second weighted metric, given by the objective: in matching "
                      "the stiffness of the energy's own terms); newton brings its own"});
    visit("h1_length", self.h1_length,
          {.unit = "side of the domain",
           .min = 0,
           .max = 10,
           .meaning = "length over which metric h1 smooths gradients"});
    visit("fallback", self.fallback,
          {.meaning = "methods that go on, in this order, where one gives up without having converged; auto: lbfgs "
                      "after newton, none after others; [] for none"});
    visit("stop", self.stop, {.meaning = "when a minimisation ends"});
    visit("fletcher_reeves", self.fletcher_reeves, {.meaning = "options of the paper's conjugate gradients"});
    visit("lbfgs", self.lbfgs, {.meaning = "options of our limited-memory BFGS"});
    visit("newton", self.newton, {.meaning = "options of Newton's method"});
    visit("ceres", self.ceres, {.meaning = "options of the methods ceres_*, under Ceres' own names"});
  }
};

/// Names of all minimisers, in the order of the documentation.
std::vector<std::string> minimizer_names();

/// The minimiser options.name. \throws InputError for a name that is not among minimizer_names(), for an
/// option out of its range, and for inconsistent options.
std::unique_ptr<Minimizer> make_minimizer(const SolverOptions& options);

}  // namespace shellmatch
