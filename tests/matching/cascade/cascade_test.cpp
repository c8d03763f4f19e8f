// What the cascade promises: every accepted step goes down, refinement changes no value of phi, a smaller nu gives
// a smaller mismatch, no cell folds under the barrier, and all solvers find the same minimum.

#include "base/error.h"
#include "base/parallel.h"
#include "matching/cascade/cascade.h"
#include "matching/cascade/schedule.h"
#include "matching/input/shape_source.h"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <set>
#include <string>
#include <tuple>

namespace shellmatch {
namespace {

struct Steps final : Observer {
  std::vector<std::vector<double>> values;  // of every minimisation
  void minimisation_started(const LevelStart&) override { values.emplace_back(); }
  bool iterated(const LevelStart&, const IterationRecord& r) override {
    values.back().push_back(r.value);
    return true;
  }
};

template <int Dim>
SignedDistance<Dim> built_in(const std::string& name) {
  return SignedDistance<Dim>(std::get<Shape<Dim>>(open_shape("generate:" + name)).surface);
}

ExperimentOptions small(int max_level, Profile profile = Profile::standard) {
  ExperimentOptions o = profile_defaults(profile);
  o.cascade.max_level = max_level;
  return o;
}

template <int Dim>
CascadeResult<Dim> run(const std::string& reference, const std::string& target, const ExperimentOptions& options,
                       Observer& observer, const LevelCallback<Dim>& finished = {}) {
  PhaseSeconds seconds;
  return run_cascade<Dim>(built_in<Dim>(reference), built_in<Dim>(target), options, observer, finished, seconds);
}

TEST(Schedule, DividesNuByTenAndHalvesTheVolumePerLevel) {
  CascadeOptions o = profile_defaults(Profile::paper).cascade;
  o.nu_substeps = 3;
  const auto first = schedule_of_level(o, o.min_level), third = schedule_of_level(o, o.min_level + 2);
  ASSERT_EQ(first.size(), 1u);
  EXPECT_EQ(first[0].nu, o.nu);
  ASSERT_EQ(third.size(), static_cast<std::size_t>(o.nu_substeps));
  EXPECT_NEAR(third.back().nu, o.nu / 100, 1e-15);
  EXPECT_NEAR(third[0].nu / third[1].nu, third[1].nu / third[2].nu, 1e-9);
  EXPECT_EQ(third.back().volume_weight, o.volume / 4);
}

TEST(Schedule, StepsThatCanWinNothingAreLeftOut) {
  EXPECT_EQ(step_after(0, 3, 3e-5, 2.9e-5), 1u);
  EXPECT_EQ(step_after(0, 3, 3e-5, 3.1e-5), 2u);
  EXPECT_EQ(step_after(0, 3, 0, 0), 1u) << "with nothing to spare";
  EXPECT_EQ(step_after(1, 3, 0, 1e-4), 2u);
  EXPECT_EQ(step_after(2, 3, 0, 1e-4), 3u) << "the last one ends the level";
}

TEST(Schedule, EachMinimisationStopsAsWhatFollowsItNeeds) {
  const auto of = [](const ExperimentOptions& o, const std::string& name, Followed followed) {
    SolverOptions solver = o.solver;
    solver.name = name;
    return relative_decrease(o.cascade, solver, followed);
  };
  ExperimentOptions o;
  o.cascade.intermediate_decrease = 1e-3;
  o.cascade.substep_decrease = 0.02;
  o.solver.stop.relative_decrease = 5e-3;
  EXPECT_EQ(of(o, "newton", Followed::by_nothing), 5e-3);
  EXPECT_EQ(of(o, "newton", Followed::by_level), 1e-3) << "also where the last one stops earlier";
  EXPECT_EQ(of(o, "newton", Followed::on_level), 0.02);
  EXPECT_EQ(of(o, "lbfgs", Followed::on_level), 0.002);
  o.cascade.intermediate_decrease = 0;
  EXPECT_EQ(of(o, "newton", Followed::by_level), 5e-3);
  EXPECT_EQ(of(o, "lbfgs", Followed::on_level), 5e-3);
  const ExperimentOptions paper = profile_defaults(Profile::paper);
  for (const Followed f : {Followed::on_level, Followed::by_level, Followed::by_nothing})
    EXPECT_EQ(of(paper, paper.solver.name, f), paper.solver.stop.relative_decrease)
        << "the paper's minimisations all converge alike";
}

// The numbers of the minimisations that each level of circle to ellipse/long runs.
std::map<int, std::vector<int>> steps_of_levels(const ExperimentOptions& o) {
  struct Counter final : Observer {
    void minimisation_started(const LevelStart& start) override { steps[start.level].push_back(start.substep); }
    std::map<int, std::vector<int>> steps;
  } counter;
  run<2>("circle", "ellipse/long", o, counter);
  return counter.steps;
}

TEST(Cascade, LeavesOutStepsThatCanWinNothing) {
  ExperimentOptions o = small(6);
  o.cascade.nu_substeps = 4;
  o.cascade.negligible_start_rise = 0;
  o.cascade.negligible_rise = 0.1;
  int n_left_out = 0;
  for (const auto& [level, steps] : steps_of_levels(o)) {
    EXPECT_EQ(steps.front(), 1) << "the first nu is not left out, whatever it wins";
    EXPECT_EQ(steps.back(), level == o.cascade.min_level ? 1 : 4) << "the last nu is never left out";
    n_left_out += level == o.cascade.min_level ? 0 : 4 - static_cast<int>(steps.size());
  }
  EXPECT_GT(n_left_out, 2);
}

TEST(Cascade, ALevelBeginsWithItsLastNuWhereThatRaisesTheEnergyLittle) {
  ExperimentOptions o = small(6);
  o.cascade.negligible_rise = 0;
  o.cascade.negligible_start_rise = 0;
  for (const auto& [level, steps] : steps_of_levels(o))
    EXPECT_EQ(steps.size(), level == o.cascade.min_level ? 1u : 3u) << "all steps are asked for";
  o.cascade.negligible_start_rise = 10;  // nu falls to a third at most: no energy rises so much
  for (const auto& [level, steps] : steps_of_levels(o))
    EXPECT_EQ(steps, std::vector<int>{level == o.cascade.min_level ? 1 : 3});
  o.cascade.negligible_start_rise = profile_defaults(Profile::standard).cascade.negligible_start_rise;
  std::set<std::size_t> counts;
  for (const auto& [level, steps] : steps_of_levels(o))
    if (level > o.cascade.min_level) counts.insert(steps.size());
  EXPECT_EQ(counts, (std::set<std::size_t>{1, 3}))
      << "coarse levels, far from the target, keep all; fine ones need the last";
  o.coverage.levels = 1;
  o.coverage.tolerance = 0;
  o.coverage.weight = 1000;
  EXPECT_EQ(steps_of_levels(o).at(6), std::vector<int>{3}) << "what new pairs ask for says nothing of nu";
}

TEST(Cascade, AnEnergyThatIsNoNumberIsRefusedByItsTerms) {
  for (const auto& [delta, lambda, told] :
       {std::tuple{1e200, 1.0, "bending (weight inf)"}, std::tuple{1.0, 8e307, "membrane (weight "}}) {
    ExperimentOptions o = small(4);
    o.cascade.min_level = 4;
    o.energy.delta = delta;
    o.energy.lambda = lambda;
    Steps steps;
    try {
      run<2>("leaf/deep", "leaf/shallow", o, steps);
      ADD_FAILURE() << told;
    } catch (const InputError& error) {
      const std::string message = error.what();
      EXPECT_NE(message.find("level 4: "), std::string::npos) << message;
      EXPECT_NE(message.find(told), std::string::npos) << message;
    }
  }
}

TEST(Cascade, EnergyNeverRisesWithinAMinimisation) {
  Steps steps;
  run<2>("circle", "ellipse/long", small(6), steps);
  ASSERT_GE(steps.values.size(), 4u);
  for (const auto& values : steps.values)
    for (std::size_t i = 1; i < values.size(); ++i) EXPECT_LE(values[i], values[i - 1]);
}

TEST(Cascade, RefinementChangesNoValueOfPhi) {
  std::vector<Vec<2>> points;
  for (int i = 0; i < 200; ++i) points.emplace_back(0.5 + 0.45 * std::cos(0.7 * i), 0.5 + 0.45 * std::sin(1.3 * i));
  struct StopAtLevelFive final : Observer {
    bool iterated(const LevelStart& start, const IterationRecord&) override { return start.level < 5; }
  } stop;
  // Stopped before its first step on level 5, the second run has the first one's phi, prolonged.
  ExperimentOptions o = small(5);
  o.cascade.intermediate_decrease = 0;                   // so that both converge alike on level 4
  o.cascade.coarse_sigma_cells = o.cascade.sigma_cells;  // and to the same
  o.coefficients.levels_ahead = 0;
  o.coverage.levels = 1;  // none on level 4
  Steps steps;
  ExperimentOptions same = o;
  same.cascade.max_level = 4;
  same.coverage.levels = 0;
  const auto reference = run<2>("circle", "ellipse/long", same, steps);
  const Deformation<2> before_map{{}, reference.grid, reference.phi};
  const auto fine = run<2>("circle", "ellipse/long", o, stop);
  EXPECT_TRUE(fine.interrupted);
  const Deformation<2> after{{}, fine.grid, fine.phi};
  EXPECT_GT(fine.grid.n_nodes(), reference.grid.n_nodes());
  for (const auto& x : points)
    EXPECT_LT((before_map.apply_in_unit_domain(x) - after.apply_in_unit_domain(x)).norm(), 1e-14);
}

TEST(Cascade, SmallerNuGivesSmallerMismatch) {
  const SignedDistance<2> target = built_in<2>("ellipse/long");
  double last = 1e300;
  for (const double nu : {2.0, 0.2, 0.02}) {
    ExperimentOptions o = small(4);
    o.cascade.nu = nu;
    Steps steps;
    const auto result = run<2>("circle", "ellipse/long", o, steps);
    // From the map itself: the term's value would shrink with nu whatever nu did.
    double mismatch = 0;
    for (const Index node : result.grid.free_nodes())
      if (const double d1 = result.moving_fields.distance[node]; std::abs(d1) < result.grid.finest_side())
        mismatch += std::pow(target(result.phi[node]) - d1, 2);
    EXPECT_LT(mismatch, 0.9 * last) << nu;
    last = mismatch;
  }
}

TEST(Cascade, NoCellFoldsUnderTheBarrier) {
  Steps steps;
  const auto safe = run<3>("sphere", "ellipsoid/long", small(4), steps);
  for (const auto& level : safe.levels) EXPECT_EQ(level.folds.n_uncertified_cells, 0);
}

// The energy at the minimum from the identity, to a tight tolerance.
double tight_minimum(const std::string& solver, Metric metric) {
  ExperimentOptions o = small(4);
  o.solver.name = solver;
  o.solver.metric = metric;
  o.solver.ceres.function_tolerance = o.solver.ceres.gradient_tolerance = o.solver.ceres.parameter_tolerance = 0;
  o.solver.stop = {.max_iterations = 3000,
                   .relative_decrease = 1e-9,
                   .decrease_window = 20,
                   .gradient_norm = 1e-9,
                   .max_seconds = 0};
  Steps steps;
  return run<2>("circle", "ellipse/long", o, steps).levels.back().minimised.sum();
}

// Newton's minimum is the others' minimum: same energy, same start.
TEST(Cascade, AllSolversReachTheSameMinimum) {
  const double newton = tight_minimum("newton", SolverOptions().metric);
  for (const char* name : {"lbfgs", "fletcher_reeves", "ceres_lbfgs", "nlopt_lbfgs"})
    EXPECT_NEAR(tight_minimum(name, SolverOptions().metric), newton, 1e-3 * newton) << name;
}

TEST(Cascade, EveryMetricLeadsToTheSameMinimum) {
  for (const char* name : {"lbfgs", "fletcher_reeves", "ceres_ncg", "nlopt_var2"}) {
    double first = 0;
    for (const auto& [metric, metric_name] : EnumNames<Metric>::names) {
      const double energy = tight_minimum(name, metric);
      if (first == 0) first = energy;
      EXPECT_NEAR(energy, first, 2e-3 * first) << name << ", " << metric_name;
    }
  }
}

// Notes what an observer is told of methods.
struct Methods final : Observer {
  std::map<int, std::set<std::string>> by_level;
  std::vector<std::string> notes;
  void note(const std::string& text) override { notes.push_back(text); }
  bool iterated(const LevelStart& start, const IterationRecord& r) override {
    if (r.iteration > 0) by_level[start.level].insert(r.solver);
    return true;
  }
};

TEST(Cascade, EveryLevelHasItsSolver) {
  ExperimentOptions o = small(5);
  o.solver.levels.at("4", "").set("name", {std::string("lbfgs")});
  o.solver.levels.at("5-7", "").set("name", {std::string("ceres_ncg")});
  Methods methods;
  run<2>("circle", "ellipse/long", o, methods);
  EXPECT_EQ(methods.by_level[3], std::set<std::string>{"newton"});
  EXPECT_EQ(methods.by_level[4], std::set<std::string>{"lbfgs"});
  EXPECT_EQ(methods.by_level[5], std::set<std::string>{"ceres_ncg"});
}

TEST(Cascade, AMethodThatGivesUpIsReplacedAndEverybodyIsTold) {
  ExperimentOptions o = small(3);
  o.solver.name = "fletcher_reeves";
  o.solver.fletcher_reeves.max_trials = 1;  // it gives up at the first difficulty
  o.solver.fallback = {"lbfgs"};
  o.solver.stop.relative_decrease = 1e-12;
  o.solver.stop.decrease_window = 50;
  o.solver.stop.gradient_norm = 1e-7;
  o.cascade.intermediate_decrease = 0;
  Methods methods;
  const auto result = run<2>("circle", "ellipse/long", o, methods);
  ASSERT_EQ(methods.notes.size(), 1u);
  EXPECT_NE(methods.notes[0].find("level 3, step 1: fletcher_reeves gave up after"), std::string::npos)
      << methods.notes[0];
  EXPECT_NE(methods.notes[0].find("(no_descent: no lower value"), std::string::npos) << methods.notes[0];
  EXPECT_EQ(result.levels.back().fallbacks, methods.notes);
  EXPECT_EQ(result.levels.back().last.solver, "lbfgs");
  EXPECT_EQ(methods.by_level[3], (std::set<std::string>{"fletcher_reeves", "lbfgs"}));
}

TEST(Cascade, SameBitsWithOneAndTwoThreads) {
  std::vector<Vec<3>> phi;
  for (const int threads : {1, 2}) {
    set_n_threads(threads);
    Steps steps;
    const auto result = run<3>("sphere", "ellipsoid/long", small(4), steps);
    if (threads == 1) phi = result.phi;
    else EXPECT_TRUE(phi == result.phi);
  }
  set_n_threads(0);
}

}  // namespace
}  // namespace shellmatch
