// Newton's method on terms that nobody wrote a second derivative for: one from outside the program, and those that are
// there to compare with.

#include "docs/examples/normal_alignment.h"
#include "energies/compiled/compile_term.h"
#include "energies/terms/term_names.h"
#include "grid/fields/mass.h"
#include "matching/cascade/cascade.h"
#include "matching/cascade/schedule.h"
#include "matching/input/shape_source.h"
#include "matching/level/level_energy.h"
#include "matching/level/level_problem.h"
#include "matching/level/shape_fields.h"
#include "solvers/solver_options.h"

#include <gtest/gtest.h>

#include <memory>
#include <string>
#include <utility>

namespace shellmatch {
namespace {

using example::NormalAlignment;

template <int Dim>
SignedDistance<Dim> built_in(const std::string& name) {
  return SignedDistance<Dim>(std::get<Shape<Dim>>(open_shape("generate:" + name)).surface);
}

ExperimentOptions experiment(int min_level, int max_level) {
  ExperimentOptions o = profile_defaults(Profile::standard);
  o.cascade.min_level = min_level;
  o.cascade.max_level = max_level;
  return o;
}

/// First-order methods go on until they hardly move, so that nothing is left for them to win.
StopOptions stop_of(const std::string& solver) {
  if (solver == "newton") return {.max_iterations = 300, .relative_decrease = 1e-6, .decrease_window = 5};
  return {.max_iterations = 3000, .relative_decrease = 1e-7, .decrease_window = 20};
}

/// The energy of the default options and normal alignment, with a stretch of 1.2, on one grid.
template <int Dim>
struct WithAlignment {
  ExperimentOptions options;
  SignedDistance<Dim> reference, target;
  ShapeFields<Dim> fields{reference, target, options};
  Octree<Dim> grid{options.cascade.min_level};
  std::unique_ptr<LevelEnergy<Dim>> level;  ///< of the terms in the list alone
  std::shared_ptr<EnergyTerms<Dim>> terms = std::make_shared<EnergyTerms<Dim>>(options.energy);
  const Term alignment = terms->add(compile_term<NormalAlignment<Dim>>(), {1.2});

  WithAlignment(const std::string& from, const std::string& to, int finest)
      : options(experiment(3, finest)), reference(built_in<Dim>(from)), target(built_in<Dim>(to)) {
    fields.compute_distances(grid);
    for (int l = options.cascade.min_level; l < finest; ++l) {
      fields.refine(grid);
      fields.compute_distances(grid);
    }
    level = std::make_unique<LevelEnergy<Dim>>(grid, fields.geometry(grid), options);
  }

  struct Minimum {
    MinimizerSummary summary;
    TermValues values;
  };
  /// From phi = id.
  Minimum minimise(const std::string& solver, double alignment_weight) const {
    const MatchingEnergy<Dim> energy(level->unknowns, level->geometry, terms, level->sigma,
                                     options.energy.quadrature_order);
    EnergyHessian<Dim> hessian(energy, level->unknowns);
    const ScheduleStep step = schedule_of_level(options.cascade, options.cascade.max_level).front();
    const TermValues listed = term_weights(options.energy, step.nu, step.volume_weight);
    TermValues weights(terms->size());
    for (std::size_t t = 0; t < listed.size(); ++t) weights[t] = listed[t];
    weights[alignment] = alignment_weight;
    LevelProblem<Dim> problem(level->unknowns, energy, hessian, weights, lumped_mass(grid), identity_map(grid));
    SolverOptions method = options.solver;
    method.name = solver;
    const StopOptions stop = stop_of(solver);
    std::vector<double> x = problem.unknowns_of(identity_map(grid));
    Minimum found{make_minimizer(method)->minimize(problem, x, stop), TermValues(terms->size())};
    weights[alignment] = 1;
    EXPECT_TRUE(energy.evaluate(problem.positions(x), weights, found.values, {}));
    return found;
  }
};

template <int Dim>
void check_alignment(const std::string& from, const std::string& to, int finest, int most_steps) {
  const WithAlignment<Dim> matching(from, to, finest);
  EXPECT_EQ(matching.terms->names().back(), "normal_alignment");
  const auto newton = matching.minimise("newton", 10), first_order = matching.minimise("fletcher_reeves", 10);
  const StopReason reason = newton.summary.reason;
  EXPECT_TRUE(reason == StopReason::relative_decrease || reason == StopReason::gradient_norm) << newton.summary.message;
  EXPECT_LE(newton.summary.iterations, most_steps);
  EXPECT_LT(newton.summary.final_value, first_order.summary.final_value);
  EXPECT_LT(newton.summary.final_value, 0.5 * newton.summary.initial_value);
  // The term is what it is minimised for.
  const auto without = matching.minimise("newton", 0);
  EXPECT_LT(newton.values[matching.alignment], 0.5 * without.values[matching.alignment]);
}
TEST(NewtonTerms, ATermOfOnesOwnIsMinimisedInThePlane) { check_alignment<2>("circle/large", "ellipse/long", 5, 30); }
TEST(NewtonTerms, ATermOfOnesOwnIsMinimisedInSpace) { check_alignment<3>("ellipsoid/round", "ellipsoid/long", 4, 30); }

template <int Dim>
void check_models(const std::string& from, const std::string& to, int level) {
  for (const auto& [membrane, bending] :
       {std::pair{"no_p2", "thin_shell"}, std::pair{"thin_shell", "no_p2"}, std::pair{"cauchy_green", "thin_shell"},
        std::pair{"thin_shell", "quadratic"}}) {
    SCOPED_TRACE(std::string("membrane ") + membrane + ", bending " + bending);
    ExperimentOptions o = experiment(level, level);
    o.energy.terms.model("membrane"_term) = membrane;
    o.energy.terms.model("bending"_term) = bending;
    const auto run = [&](const std::string& solver) {
      o.solver.name = solver;
      o.solver.stop = stop_of(solver);
      Observer observer;
      PhaseSeconds seconds;
      return run_cascade<Dim>(built_in<Dim>(from), built_in<Dim>(to), o, observer, {}, seconds).levels.back();
    };
    const LevelResult newton = run("newton"), first_order = run("lbfgs");
    EXPECT_TRUE(newton.fallbacks.empty());
    EXPECT_EQ(newton.last.solver, "newton");
    EXPECT_LT(newton.last.final_value, (1 + 1e-3) * first_order.last.final_value);
    EXPECT_LT(10 * newton.iterations, first_order.iterations);
  }
}
TEST(NewtonTerms, EveryModelIsMinimisedInThePlane) { check_models<2>("circle/large", "ellipse/long", 5); }
TEST(NewtonTerms, EveryModelIsMinimisedInSpace) { check_models<3>("ellipsoid/round", "ellipsoid/long", 4); }

}  // namespace
}  // namespace shellmatch
