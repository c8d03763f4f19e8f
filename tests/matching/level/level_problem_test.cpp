// An evaluation that is made ahead, for the minimisation that is to begin there.
#include "matching/level/level_problem.h"

#include "matching/cascade/schedule.h"
#include "matching/input/shape_source.h"
#include "matching/level/level_energy.h"
#include "matching/level/shape_fields.h"

#include <gtest/gtest.h>

#include <memory>
#include <string>
#include <variant>
#include <vector>

namespace shellmatch {
namespace {

SignedDistance<2> built_in(const std::string& name) {
  return SignedDistance<2>(std::get<Shape<2>>(open_shape("generate:" + name)).surface);
}

/// Circle and ellipse on a uniform grid of 16 x 16 cells.
struct Level {
  ExperimentOptions options = profile_defaults(Profile::standard);
  SignedDistance<2> reference = built_in("circle/large"), target = built_in("ellipse/long");
  Octree<2> grid{4};
  ShapeFields<2> fields;
  std::unique_ptr<LevelEnergy<2>> level;
  TermValues weights;

  Level() : fields(reference, target, with_levels(options)) {
    fields.compute_distances(grid);
    level = std::make_unique<LevelEnergy<2>>(grid, fields.geometry(grid), options);
    weights = level->weights(options, 1e-3, 0.1);
  }
  static const ExperimentOptions& with_levels(ExperimentOptions& o) {
    o.cascade.min_level = o.cascade.max_level = 4;
    return o;
  }
  LevelProblem<2> problem() {
    return {level->unknowns, level->energy, level->hessian, weights, level->unknown_mass(), identity_map(grid)};
  }
};

struct Found {
  bool is_finite;
  double value;
  std::vector<double> gradient, terms;
  bool operator==(const Found&) const = default;
};

Found evaluate(LevelProblem<2>& problem, const std::vector<double>& x, bool with_gradient = true) {
  Found found{false, 0, std::vector<double>(with_gradient ? x.size() : 0), {}};
  found.is_finite = problem.evaluate(x, found.value, found.gradient);
  found.terms = problem.term_values();
  return found;
}

TEST(LevelProblem, WhatWasEvaluatedAheadIsWhatIsFound) {
  Level level;
  LevelProblem<2> plain = level.problem(), ahead = level.problem();
  const std::vector<double> start = plain.unknowns_of(identity_map(level.grid));
  std::vector<double> other = start;
  for (double& x : other) x = 0.99 * x + 0.003;
  ASSERT_TRUE(ahead.evaluate_ahead(start));
  EXPECT_EQ(ahead.term_values(), evaluate(plain, start).terms);
  EXPECT_EQ(evaluate(ahead, start), evaluate(plain, start));
  EXPECT_EQ(evaluate(ahead, start), evaluate(plain, start)) << "once more, evaluated anew";
  // Another point, or the value alone, is evaluated as ever.
  ASSERT_TRUE(ahead.evaluate_ahead(start));
  EXPECT_EQ(evaluate(ahead, other), evaluate(plain, other));
  EXPECT_EQ(evaluate(ahead, start), evaluate(plain, start));
  ASSERT_TRUE(ahead.evaluate_ahead(other));
  EXPECT_EQ(evaluate(ahead, start, false), evaluate(plain, start, false));
  EXPECT_NE(evaluate(plain, start).value, evaluate(plain, other).value);
}

TEST(LevelProblem, WhereTheEnergyIsNotFiniteNothingIsKept) {
  Level level;
  LevelProblem<2> problem = level.problem();
  std::vector<double> x = problem.unknowns_of(identity_map(level.grid));
  x[x.size() / 2] = 1e300;
  EXPECT_FALSE(problem.evaluate_ahead(x));
  EXPECT_FALSE(evaluate(problem, x).is_finite);
}

}  // namespace
}  // namespace shellmatch
