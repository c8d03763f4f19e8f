// Coverage: which pairs it makes, and what it wins.

#include "matching/input/shape_source.h"
#include "matching/level/shape_fields.h"
#include "matching/match_shapes.h"
#include "matching/pairs/coverage.h"

#include <gtest/gtest.h>

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
  const auto same = Coverage<Dim>(surface, surface, options).pairs(grid, identity);
  EXPECT_LE(same.pairs.size(), 301u);
  EXPECT_GT(same.pairs.size(), 150u);
  EXPECT_DOUBLE_EQ(same.tolerance, 0.125 * bounding_box(surface.vertices).diagonal());
  double sum = 0;
  for (const auto& pair : same.pairs) {
    EXPECT_LT((pair.p - pair.y).norm(), 1e-9) << "a point of the shape is its own nearest";
    EXPECT_NEAR(pair.normal.norm(), 1, 1e-12);
    sum += pair.weight;
  }
  EXPECT_NEAR(sum, area, 0.01 * area);
  options.samples = 1000000;
  EXPECT_EQ(Coverage<Dim>(surface, surface, options).pairs(grid, identity).pairs.size(), surface.vertices.size());
  options.samples = 300;

  // Under a shift the image of the nearest point's preimage is no farther away than the shift.
  auto shifted = identity;
  for (auto& x : shifted) x[0] += 0.01;
  for (const auto& pair : Coverage<Dim>(surface, surface, options).pairs(grid, shifted).pairs) {
    EXPECT_LT((pair.p + 0.01 * Vec<Dim>::Unit(0) - pair.y).norm(), 0.0101);
  }

  // Seen from inside out, everything faces away.
  Surface<Dim> inverted = surface;
  for (auto& facet : inverted.facets) std::swap(facet[0], facet[1]);
  EXPECT_TRUE(Coverage<Dim>(inverted, surface, options).pairs(grid, identity).pairs.empty());
}

TEST(Coverage, PairsEverySampleWithItsNearestPoint) {
  check_pairs<2>("star/mild");
  check_pairs<3>("ellipsoid/long");
}

TEST(Coverage, ReachesWhatAOneSidedMatchLeavesOut) {
  ExperimentOptions o = profile_defaults(Profile::standard);
  o.cascade.max_level = 6;
  Observer quiet;
  const Shape<2> from = std::get<Shape<2>>(open_shape("generate:leaf/shallow"));
  const Shape<2> to = std::get<Shape<2>>(open_shape("generate:leaf/deep"));
  const auto one_sided = match_shapes(from, to, o, quiet);
  o.coverage.levels = 1;
  const auto covered = match_shapes(from, to, o, quiet);
  EXPECT_LT(covered.summary.distance->template_to_deformed.mean, 0.5 * one_sided.summary.distance->template_to_deformed.mean);
  EXPECT_LT(covered.summary.distance->template_to_deformed.max, 0.3 * one_sided.summary.distance->template_to_deformed.max);
  EXPECT_LT(covered.summary.distance->deformed_to_template.mean, one_sided.summary.distance->deformed_to_template.mean);
  EXPECT_EQ(covered.summary.levels.back().folds.n_uncertified_cells, 0);
  ASSERT_EQ(covered.history.term_names.back(), "coverage");
  for (const auto& row : covered.history.rows) EXPECT_EQ(row.record.terms.back() > 0, row.level == 6);
  // Three rounds for each nu, as minimisations of their own.
  EXPECT_EQ(covered.summary.levels.back().n_substeps, 3 * o.cascade.nu_substeps);
}

}  // namespace
}  // namespace shellmatch
