// A level as an object, and derivatives of the map that it belongs to.

#include "matching/pair_level.h"

#include "geometry/generate/generate_shape.h"
#include "matching/match_shapes.h"
#include "tests/support/expect_input_error.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <memory>
#include <utility>
#include <vector>

namespace shellmatch {
namespace {

ShapePair<2> ellipses() {
  Observer quiet;
  return std::get<ShapePair<2>>(
      open_shape_pair({ShapeInput{"generate:ellipse/round"}, ShapeInput{"generate:ellipse/long"}}, {}, {}, quiet));
}

ExperimentOptions options_of_level(int max_level) {
  ExperimentOptions o = profile_defaults(Profile::standard);
  o.align.mode = AlignMode::none;
  o.cascade.max_level = max_level;
  o.cascade.nu_substeps = 1;
  return o;
}

// Where the cascade begins a level, the object begins, on the same grid and with the same energy.
TEST(PairLevel, IsThatOfTheCascade) {
  const ExperimentOptions o = options_of_level(5);
  Observer quiet;
  const MatchResult<2> result = match_shapes(ellipses(), o, quiet, {});
  for (const int level : {3, 4, 5}) {
    PairLevel<2> kept(ellipses(), {}, o, level, quiet);
    const std::vector<Vec<2>> phi = kept.coarser_result(quiet);
    kept.energy().refresh(phi);
    LevelProblem<2> problem = kept.problem(o.solver, phi);
    double value = 0;
    ASSERT_TRUE(problem.evaluate(problem.unknowns_of(phi), value, {}));
    for (const HistoryRow& row : result.history.rows)
      if (row.level == level && row.record.iteration == 0) {
        EXPECT_NEAR(value, row.record.value, 1e-9 * value);
      }
    const LevelSummary& summary = result.summary.levels[static_cast<std::size_t>(level - 3)];
    EXPECT_EQ(kept.sizes().back().n_nodes, summary.n_nodes);
    EXPECT_EQ(kept.sizes().back().n_free_nodes, summary.n_free_nodes);
    EXPECT_EQ(kept.sizes().back().n_cells, summary.n_cells);
    EXPECT_EQ(kept.sizes().size(), static_cast<std::size_t>(level - 2));
  }
  // The coarsest begins with the identity.
  PairLevel<2> coarsest(ellipses(), {}, o, 3, quiet);
  EXPECT_EQ(coarsest.coarser_result(quiet), coarsest.identity());
}

TEST(PairLevel, FramesDifferInEachOfTheirParts) {
  MapFrame<3> frame;
  const Surface<3> corner{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}}};
  const auto bend = [&](double x) {
    std::vector<Vec<3>> bent = corner.vertices;
    bent[2].x() = x;
    return std::make_shared<const SurfaceBend<3>>(corner, std::move(bent));
  };
  frame.bend = bend(0.25);
  MapFrame<3> same = frame;
  same.bend = bend(0.25);
  EXPECT_TRUE(same_frame(frame, same));
  MapFrame<3> turned = frame, other_bend = frame, no_bend = frame, shifted = frame;
  turned.pose.rotation = -Mat<3>::Identity();
  other_bend.bend = bend(0.5);
  no_bend.bend = nullptr;
  shifted.placement.offset.x() += 0.1;
  for (const MapFrame<3>& other : {turned, other_bend, no_bend, shifted}) EXPECT_FALSE(same_frame(frame, other));
}

// A matching of what is in memory is that of the same names.
TEST(PairLevel, ShapesInMemoryAreThoseOfFiles) {
  Observer quiet;
  const auto original = std::get<OriginalShape<2>>(generate_shape("ellipse", "long"));
  auto pair = std::get<ShapePair<2>>(
      open_shape_pair({ShapeInput{"generate:ellipse/round"}, ShapeInput{"mine", original}}, {}, {}, quiet));
  EXPECT_EQ(pair.template_shape.source, "mine");
  const ExperimentOptions o = options_of_level(4);
  EXPECT_EQ(match_shapes(std::move(pair), o, quiet, {}).deformed.vertices,
            match_shapes(ellipses(), o, quiet, {}).deformed.vertices);
  const auto ball = std::get<OriginalShape<3>>(generate_shape("sphere", ""));
  expect_input_error(
      [&] {
        open_shape_pair({ShapeInput{"ball", ball}, ShapeInput{"mine", original}}, {}, {}, quiet);
      },
      {"ball is 3-dimensional", "mine is 2-dimensional"});
}

// In a cell the map is multilinear, so that the midpoint rule has no error but rounding along an axis.
TEST(Jacobian, IsTheDerivativeOfTheMap) {
  const ExperimentOptions o = options_of_level(4);
  Observer quiet;
  for (const MatchDirection direction : {MatchDirection::forward, MatchDirection::backward}) {
    ExperimentOptions directed = o;
    directed.align.direction = direction;
    MatchResult<2> result = match_shapes(ellipses(), directed, quiet, {});
    result.map.pose.rotation << 0, -1, 1, 0;
    result.map.pose.scale = 1.5;
    const PointMap<2> map(result.map, Toward::template_shape);
    constexpr double h = 1e-6;
    for (const Vec<2>& x : {Vec<2>(0.211, 0.123), Vec<2>(-0.137, 0.241), Vec<2>(7.1, 0.21), Vec<2>(-9, 12)}) {
      const std::optional<Mat<2>> derivative = map.jacobian(x);
      if (!derivative) {
        EXPECT_FALSE(map(x));
        continue;
      }
      for (int k = 0; k < 2; ++k) {
        const Vec<2> step = h * Vec<2>::Unit(k);
        const Vec<2> difference = (*map(x + step) - *map(x - step)) / (2 * h);
        EXPECT_LT((derivative->col(k) - difference).norm(), 1e-7) << x.transpose() << ", axis " << k;
      }
    }
  }
}

}  // namespace
}  // namespace shellmatch
