// Claims of the paper on whole minimisations: the limit of small nu, and oscillations of the naive membrane
// under compression.

#include "matching/cascade/cascade.h"
#include "matching/input/shape_source.h"
#include "energies/terms/term_names.h"

#include <gtest/gtest.h>

#include <cmath>

namespace shellmatch {
namespace {

CascadeResult<2> run(const std::string& reference, const std::string& target, const ExperimentOptions& options) {
  const auto distance = [](const std::string& name) {
    return SignedDistance<2>(std::get<Shape<2>>(open_shape("generate:" + name)).surface);
  };
  Observer observer;
  PhaseSeconds seconds;
  return run_cascade<2>(distance(reference), distance(target), options, observer, {}, seconds);
}

ExperimentOptions first_order(int min_level, int max_level) {
  ExperimentOptions o = profile_defaults(Profile::standard);
  o.cascade.min_level = min_level;
  o.cascade.max_level = max_level;
  o.cascade.nu = 0.002;
  o.cascade.nu_factor = 0.1;
  o.cascade.coarse_sigma_cells = o.cascade.sigma_cells;
  o.cascade.negligible_start_rise = o.cascade.negligible_rise = 0;
  o.cascade.intermediate_decrease = 0;
  o.solver.name = "lbfgs";
  o.solver.stop = {.max_iterations = 3000, .relative_decrease = 1e-9, .decrease_window = 20};
  return o;
}

// Proposition prop:penalization-limit, under its own conditions: phi = id on the boundary, W_hat in the
// volume.
TEST(Claims, SmallerNuGivesSmallerMismatchAndEnergiesConverge) {
  ExperimentOptions o = first_order(6, 6);
  o.cascade.volume = 0.1;
  o.energy.terms.model("volume"_term) = "full";
  o.energy.boundary = BoundaryCondition::dirichlet;
  o.energy.terms.factor("barrier"_term) = 0;
  std::vector<double> mismatch, rest, total;
  for (const double nu : {1e-1, 1e-2, 1e-3, 1e-4, 1e-5}) {
    o.cascade.nu = nu;
    const TermValues e = run("circle/large", "ellipse/long", o).levels.back().minimised;
    mismatch.push_back(e["match"_term] * nu);
    rest.push_back(e.sum() - e["match"_term]);
    total.push_back(e.sum());
  }
  for (std::size_t i = 1; i < total.size(); ++i) {
    EXPECT_LT(mismatch[i], 0.5 * mismatch[i - 1]);
    EXPECT_GT(total[i], total[i - 1]);  // E_nu grows as nu falls ...
    EXPECT_GT(rest[i], rest[i - 1]);
  }
  // ... towards the energy of the constrained minimiser, and the penalty itself vanishes.
  EXPECT_LT(total[4] - total[3], 0.2 * (total[2] - total[1]));
  EXPECT_LT(total[4] - rest[4], 0.05 * total[4]);
}

// A circle onto one of two thirds its radius: the Cauchy-Green membrane buckles, the model compresses.
TEST(Claims, TheCauchyGreenMembraneOscillatesUnderCompression) {
  ExperimentOptions o = first_order(4, 5);
  o.energy.terms.factor("bending"_term) = 0;
  const BandReport ours = run("circle/large", "circle/small", o).levels.back().band;
  o.energy.terms.model("membrane"_term) = "cauchy_green";
  const BandReport naive = run("circle/large", "circle/small", o).levels.back().band;
  EXPECT_LT(ours.normal_angle, 4);
  EXPECT_GT(naive.normal_angle, 5 * ours.normal_angle);
}

// Every comparison runs through the cascade with the coefficients that it reads: identical shapes cost
// little, and less on a finer grid. Roots in the place of shape operators would cost about 10.
TEST(Claims, ComparisonEnergiesVanishOnIdenticalShapes) {
  for (const auto& [membrane, bending] : {std::pair{"no_p2", "no_p2"}, std::pair{"cauchy_green", "quadratic"}}) {
    ExperimentOptions o = first_order(4, 5);
    o.energy.terms.model("membrane"_term) = membrane;
    o.energy.terms.model("bending"_term) = bending;
    o.solver.stop.max_iterations = 100;
    const auto result = run("ellipse/long", "ellipse/long", o);
    for (const LevelResult& level : result.levels)
      for (const double e : level.minimised) EXPECT_LT(std::abs(e), level.start.level == 5 ? 0.02 : 0.5) << membrane;
  }
}

}  // namespace
}  // namespace shellmatch
