// Coverage: which pairs it makes, and what it wins.

#include "matching/input/shape_source.h"
#include "matching/level/shape_fields.h"
#include "matching/match_shapes.h"
#include "matching/pairs/coverage.h"
#include "tests/geometry/surface/test_surfaces.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace shellmatch {
namespace {

template <int Dim>
Surface<Dim> built_in(const std::string& name) {
  return std::get<Shape<Dim>>(open_shape("generate:" + name)).surface;
}

template <int Dim>
void check_pairs(const std::string& name) {
  const Surface<Dim> surface = built_in<Dim>(name);
  const Octree<Dim> grid(5);
  const auto identity = identity_map(grid);
  double area = 0;
  for (std::size_t f = 0; f < surface.facets.size(); ++f) area += facet_measure(surface, static_cast<Index>(f));
  CoverageOptions options;
  options.samples = 300;
  options.tolerance = 0.125;
  const SignedDistance<Dim> distance(surface);
  const auto same = Coverage<Dim>(surface, distance, 1, options).pairs(grid, identity);
  EXPECT_LE(same.pairs.size(), 602u);
  EXPECT_GT(same.pairs.size(), 300u);
  EXPECT_DOUBLE_EQ(same.tolerance, 0.125 * bounding_box(surface.vertices).diagonal());
  // Half a cell on levels before the last, if that is more.
  const double half = 0.5 / 32, diagonal = bounding_box(surface.vertices).diagonal();
  options.tolerance = 0.001 / diagonal;
  EXPECT_DOUBLE_EQ(Coverage<Dim>(surface, distance, 1.0 / 64, options).pairs(grid, identity).tolerance, half);
  EXPECT_DOUBLE_EQ(Coverage<Dim>(surface, distance, 1.0 / 32, options).pairs(grid, identity).tolerance, 0.001);
  options.tolerance = 0.125;
  EXPECT_DOUBLE_EQ(Coverage<Dim>(surface, distance, 1.0 / 64, options).pairs(grid, identity).tolerance,
                   0.125 * diagonal);
  EXPECT_EQ(same.loss, RobustLoss::huber);
  EXPECT_DOUBLE_EQ(same.scale, options.loss_scale / 32);
  double sum = 0;
  for (const auto& pair : same.pairs) {
    EXPECT_LT((pair.p - pair.y).norm(), 1e-9) << "a point of the shape is its own nearest";
    EXPECT_NEAR(pair.normal.norm(), 1, 1e-12);
    sum += pair.weight;
  }
  EXPECT_NEAR(sum, 2 * area, 0.02 * area) << "both shapes are covered";
  options.samples = 1000000;
  EXPECT_EQ(Coverage<Dim>(surface, distance, 1, options).pairs(grid, identity).pairs.size(),
            2 * surface.vertices.size());
  options.samples = 300;

  // Under a shift no image is farther from its other point than the shift; those of M2's samples that are farther than
  // point_distance attract as points.
  auto shifted = identity;
  for (auto& x : shifted) x[0] += 0.01;
  for (const double point_distance : {1.0, 0.15}) {
    options.point_distance = point_distance;
    const auto pairs = Coverage<Dim>(surface, distance, 1, options).pairs(grid, shifted).pairs;
    int n_points = 0;
    for (const auto& pair : pairs) {
      const double apart = (pair.p + 0.01 * Vec<Dim>::Unit(0) - pair.y).norm();
      EXPECT_LT(apart, 0.0101);
      if (!pair.normal.isZero()) continue;
      ++n_points;
      EXPECT_GT(apart, point_distance / 32);
    }
    EXPECT_EQ(n_points > 0, point_distance < 0.3) << n_points << " of " << pairs.size();
  }

  // Seen from inside out, everything faces away.
  Surface<Dim> inverted = surface;
  for (auto& facet : inverted.facets) std::swap(facet[0], facet[1]);
  EXPECT_TRUE(Coverage<Dim>(inverted, distance, 1, options).pairs(grid, identity).pairs.empty());
}

TEST(Coverage, PairsSamplesOfBothShapesWithTheirNearestPoints) {
  check_pairs<2>("star/mild");
  check_pairs<3>("ellipsoid/long");
}

/// The same shape with its facets in the opposite order.
template <int Dim>
Surface<Dim> with_facets_reversed(Surface<Dim> surface) {
  std::reverse(surface.facets.begin(), surface.facets.end());
  return surface;
}

// Nearest points on an edge are as near to one of its facets as to the other, so that rounding or the order of facets
// decides.
template <int Dim>
void check_ties(const std::string& name) {
  const Surface<Dim> surface = built_in<Dim>(name), reversed = with_facets_reversed(surface);
  const SignedDistance<Dim> distance(surface), distance_of_reversed(reversed);
  const Octree<Dim> grid(5);
  auto moved = identity_map(grid);
  for (auto& x : moved) x += 0.01 * Vec<Dim>::LinSpaced(1.1, 2.3);
  CoverageOptions options;
  options.point_distance = 10;
  const auto one = Coverage<Dim>(surface, distance, 1, options).pairs(grid, moved).pairs;
  const auto other = Coverage<Dim>(reversed, distance_of_reversed, 1, options).pairs(grid, moved).pairs;
  ASSERT_EQ(one.size(), other.size());
  for (std::size_t i = 0; i < one.size(); ++i) {
    EXPECT_LT((one[i].p - other[i].p).norm(), 1e-12);
    EXPECT_LT((one[i].y - other[i].y).norm(), 1e-12);
    EXPECT_LT((one[i].normal - other[i].normal).norm(), 1e-9)
        << one[i].normal.transpose() << " or " << other[i].normal.transpose();
  }
}

TEST(Coverage, PairsDoNotDependOnTheOrderOfFacets) {
  check_ties<2>("star/mild");
  check_ties<3>("ellipsoid/long");
}

TEST(Coverage, LargeFacetsHaveSamplesWithin) {
  const Surface<3> cube = test::box({0.25, 0.25, 0.25}, {0.75, 0.75, 0.75});
  const SignedDistance<3> distance(cube);
  const Octree<3> grid(5);
  CoverageOptions options;
  options.samples = 3000;
  const auto pairs = Coverage<3>(cube, distance, grid.finest_side(), options).pairs(grid, identity_map(grid)).pairs;
  EXPECT_GT(pairs.size(), 3000u) << "edges of at most one side";
  EXPECT_LE(pairs.size(), 6000u);
  double area = 0;
  for (const auto& pair : pairs) {
    EXPECT_LT((pair.p - pair.y).norm(), 1e-9);
    EXPECT_LT(pair.weight, 0.01);
    area += pair.weight;
  }
  EXPECT_NEAR(area, 2 * 1.5, 1e-9);
  EXPECT_LT(Coverage<3>(cube, distance, 1, options).pairs(grid, identity_map(grid)).pairs.size(), 17u)
      << "a cell holds all of it";
}

TEST(Coverage, WeighsAsTheMatchTermNearGaps) {
  /// From 0 to 1 along x for the point of the reference and along y for that of the template.
  struct Ramp final : BandMask<3> {
    void reference_weights(std::span<const Vec<3>> x, std::span<double> weights) const override {
      std::ranges::transform(x, weights.begin(), [](const Vec<3>& p) { return std::max(0.0, 2 * p[0] - 1); });
    }
    void template_weights(std::span<const Vec<3>> y, std::span<double> weights) const override {
      std::ranges::transform(y, weights.begin(), [](const Vec<3>& p) { return p[1]; });
    }
  };
  const Surface<3> surface = built_in<3>("ellipsoid/long");
  const SignedDistance<3> distance(surface);
  const Octree<3> grid(5);
  const auto identity = identity_map(grid);
  const Coverage<3> coverage(surface, distance, 1, {});
  const Ramp ramp;
  const auto all = coverage.pairs(grid, identity).pairs, some = coverage.pairs(grid, identity, &ramp).pairs;
  EXPECT_LT(some.size(), 0.6 * all.size());
  std::size_t k = 0;
  for (const auto& pair : all)
    if (const double m = std::max(0.0, 2 * pair.p[0] - 1) * pair.y[1]; m > 0) {
      ASSERT_LT(k, some.size());
      EXPECT_EQ(some[k].p, pair.p);
      EXPECT_DOUBLE_EQ(some[k++].weight, m * pair.weight);
    }
  EXPECT_EQ(k, some.size()) << "no pair without weight";
}

TEST(Coverage, ActsOnTheFinestLevelsButNotOnTheCoarsest) {
  ExperimentOptions o = profile_defaults(Profile::standard);
  o.cascade.min_level = 3;
  o.cascade.max_level = 6;
  o.coverage.levels = 2;
  EXPECT_FALSE(covers(o, 4));
  EXPECT_TRUE(covers(o, 5));
  EXPECT_TRUE(covers(o, 6));
  o.coverage.levels = 9;
  EXPECT_FALSE(covers(o, 3));
  EXPECT_TRUE(covers(o, 4));
  o.cascade.min_level = 6;
  EXPECT_FALSE(has_coverage(o));
  EXPECT_TRUE(has_coverage(profile_defaults(Profile::standard)));
  EXPECT_FALSE(has_coverage(profile_defaults(Profile::paper)));
}

TEST(Coverage, ReachesWhatAOneSidedMatchLeavesOut) {
  ExperimentOptions o = profile_defaults(Profile::standard);
  o.cascade.max_level = 6;
  o.coverage.levels = 0;
  Observer quiet;
  const Shape<2> from = std::get<Shape<2>>(open_shape("generate:leaf/shallow"));
  const Shape<2> to = std::get<Shape<2>>(open_shape("generate:leaf/deep"));
  const auto one_sided = match_shapes(from, to, o, quiet);
  o.coverage.levels = 1;
  const auto covered = match_shapes(from, to, o, quiet);
  EXPECT_LT(covered.summary.distance->template_to_deformed.mean,
            0.5 * one_sided.summary.distance->template_to_deformed.mean);
  EXPECT_LT(covered.summary.distance->template_to_deformed.max,
            0.3 * one_sided.summary.distance->template_to_deformed.max);
  EXPECT_LT(covered.summary.distance->deformed_to_template.mean, one_sided.summary.distance->deformed_to_template.mean);
  EXPECT_EQ(covered.summary.levels.back().folds.n_uncertified_cells, 0);
  ASSERT_EQ(covered.history.term_names.back(), "coverage");
  for (const auto& row : covered.history.rows) EXPECT_EQ(row.record.terms.back() > 0, row.level == 6);
  EXPECT_EQ(covered.summary.levels.back().n_substeps, o.cascade.nu_substeps);
  // Rounds are minimisations of their own.
  o.coverage.rounds = 3;
  EXPECT_EQ(match_shapes(from, to, o, quiet).summary.levels.back().n_substeps, 3 * o.cascade.nu_substeps);
}

}  // namespace
}  // namespace shellmatch
