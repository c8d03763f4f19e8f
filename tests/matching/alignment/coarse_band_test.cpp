// Where pairs of points lead a surface, the match term acts in a narrow band on the levels before the finest.

#include "matching/alignment/known_pairs.h"

#include "matching/alignment/trial.h"
#include "matching/match_shapes.h"
#include "matching/pair_level.h"
#include "tests/matching/alignment/coarse_hands.h"

#include <gtest/gtest.h>

#include <string>

namespace shellmatch {
namespace {

ExperimentOptions to_level_4() {
  ExperimentOptions o = profile_defaults(Profile::standard);
  o.cascade.max_level = 4;
  o.cascade.coarse_sigma_cells = 3;
  o.align.coarse_sigma_cells = 1.5;
  o.align.search.max_vertices = 2000;
  o.align.search.start_functions = 4;
  o.align.search.functions = 60;
  o.align.search.refined = 2;
  return o;
}

template <int Dim>
double coarse_sigma_cells(const Alignment<Dim>& alignment, const ExperimentOptions& options = to_level_4()) {
  return cascade_options(options, alignment).cascade.coarse_sigma_cells;
}

TEST(CoarseBand, IsNarrowWherePairsLeadASurface) {
  EXPECT_EQ(ExperimentOptions().align.coarse_sigma_cells, 1);
  Alignment<3> none, found;
  found.pairs = {{"a", Vec<3>(0, 0, 0), Vec<3>(1, 0, 0)}};
  EXPECT_EQ(coarse_sigma_cells(none), 3);
  EXPECT_EQ(coarse_sigma_cells(found), 1.5);
  ExperimentOptions for_pose_alone = to_level_4();
  for_pose_alone.align.weight = 0;
  EXPECT_EQ(coarse_sigma_cells(found, for_pose_alone), 3);
  EXPECT_EQ(cascade_options(to_level_4(), found).cascade.sigma_cells, to_level_4().cascade.sigma_cells)
      << "on the finest level it stays";
  // The teeth of outlines lie between their pairs.
  Alignment<2> of_outline;
  of_outline.pairs = {{"a", Vec<2>(0, 0), Vec<2>(1, 0)}};
  EXPECT_EQ(coarse_sigma_cells(of_outline), 3);
}

TEST(CoarseBand, IsNarrowAndLevelsEndEarlyWhereAPredictedPoseIsNear) {
  Alignment<3> near;
  near.is_near = true;
  EXPECT_EQ(coarse_sigma_cells(near), 1.5);
  ExperimentOptions o = to_level_4();
  const auto decrease = [&](const Alignment<3>& a) { return cascade_options(o, a).cascade.intermediate_decrease; };
  EXPECT_EQ(decrease(near), o.cascade.substep_decrease);
  EXPECT_LT(decrease({}), decrease(near));
  o.cascade.intermediate_decrease = 0.1;
  EXPECT_EQ(decrease(near), 0.1) << "what ends earlier still does";
}

TEST(CoarseBand, IsThatOfTheCascadeAndOfItsLevelsAsObjects) {
  Observer quiet;
  ExperimentOptions o = to_level_4();
  const MatchResult<3> led = match_shapes(testing::coarse_hands(), o, quiet, {});
  ASSERT_GT(led.summary.alignment->n_pairs, 0u);
  EXPECT_EQ(led.summary.levels.front().sigma, 1.5 / 8);
  EXPECT_EQ(led.summary.levels.back().sigma, 2.0 / 16);
  EXPECT_EQ(PairLevel<3>(testing::coarse_hands(), {}, o, 3, quiet).energy().sigma, 1.5 / 8);
  o.align.mode = AlignMode::none;
  EXPECT_EQ(match_shapes(testing::coarse_hands(), o, quiet, {}).summary.levels.front().sigma, 3.0 / 8);
  EXPECT_EQ(PairLevel<3>(testing::coarse_hands(), {}, o, 3, quiet).energy().sigma, 3.0 / 8);
}

// Starts with and without pairs are compared by their energies, which a narrow band lowers; directions by the maps that
// a run would begin with.
TEST(CoarseBand, IsTheSameForAllStartsThatAreComparedByEnergy) {
  const ShapePair<3> shapes = testing::coarse_hands();
  Alignment<3> start;
  for (const auto& [vertex, place] : testing::truth_of_coarse_hands())
    if (vertex % 10 == 0)
      start.pairs.push_back({std::to_string(vertex), shapes.reference.original.vertices[vertex], place});
  Observer quiet;
  const ExperimentOptions narrow = to_level_4();
  ExperimentOptions wide = narrow;
  wide.align.coarse_sigma_cells = 6;
  const Trials<3> in_narrow(shapes, {}, narrow, quiet), in_wide(shapes, {}, wide, quiet);
  EXPECT_EQ(in_narrow(start).energy, in_wide(start).energy);
  EXPECT_NE(in_narrow.of_direction(start, Carried::reference).energy,
            in_wide.of_direction(start, Carried::reference).energy);
}

}  // namespace
}  // namespace shellmatch
