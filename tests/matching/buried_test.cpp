// A ring with a gap onto one whose ends press into each other: what lies inside the body pulls nothing and is not
// measured.

#include "matching/input/shape_source.h"
#include "matching/match_shapes.h"
#include "geometry/distance/buried_parts.h"
#include "geometry/distance/surface_distance.h"
#include "matching/result/verdict.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <string>
#include <vector>

namespace shellmatch {
namespace {

struct Heard : Observer {
  void note(const std::string& text) override { notes.push_back(text); }
  bool has(const std::string& part) const {
    return std::ranges::any_of(notes, [&](const std::string& n) { return n.find(part) != std::string::npos; });
  }
  std::vector<std::string> notes;
};

class Buried : public ::testing::Test {
 protected:
  static Shape<3> ring(const std::string& variant) {
    return std::get<Shape<3>>(open_shape("generate:ring/" + variant));
  }
  static ExperimentOptions options(Burial buried) {
    ExperimentOptions o = profile_defaults(Profile::standard);
    o.cascade.max_level = 6;
    o.align.mode = AlignMode::none;
    o.input.buried = buried;
    return o;
  }
  // Largest distance of the template's boundary, without what is buried, from the deformed reference; diagonals.
  static double largest_miss(const MatchResult<3>& result, const Shape<3>& target) {
    const Evidence<3> evidence =
        without_buried(target.surface, {}, buried_parts(target.surface, target.crossing).facets);
    std::vector<Vec<3>> points;
    for (const auto& [a, b, c] : evidence.observed.facets)
      points.push_back((target.surface.vertices[a] + target.surface.vertices[b] + target.surface.vertices[c]) / 3);
    Surface<3> deformed{result.deformed.vertices, {}};
    for (const auto& p : result.deformed.polygons) deformed.facets.push_back({p[0], p[1], p[2]});
    return std::ranges::max(distances_to(points, deformed)) / bounding_box(target.surface.vertices).diagonal();
  }
};

TEST_F(Buried, EndsThatPressIntoEachOtherAreReached) {
  const Shape<3> open = ring("open"), clasped = ring("clasped");
  const double share = buried_parts(clasped.surface, clasped.crossing).share;
  // What of both half balls lies beyond the plane of symmetry: caps of this height.
  const double r = 0.09, arc = 330 * M_PI / 180, height = r - 1.28 / arc * std::sin(M_PI - arc / 2);
  EXPECT_NEAR(share, 4 * M_PI * r * height / surface_measure(clasped.surface), 1e-3);
  Heard left_out, kept;
  const MatchResult<3> fitted = match_shapes(open, clasped, options(Burial::left_out), left_out);
  const MatchResult<3> pulled = match_shapes(open, clasped, options(Burial::kept), kept);
  EXPECT_LT(largest_miss(fitted, clasped), 0.015);
  EXPECT_GT(largest_miss(pulled, clasped), 0.03);
  EXPECT_EQ(fitted.summary.verdict->outcome, "matched") << verdict_lines(fitted.summary).back();
  EXPECT_NE(pulled.summary.verdict->outcome, "matched");

  // It is said, and nothing is measured there.
  EXPECT_TRUE(left_out.has("4.4 % of the area lies inside other parts"));
  EXPECT_FALSE(kept.has("lies inside other parts"));
  ASSERT_TRUE(fitted.summary.template_shape.buried.has_value());
  EXPECT_NEAR(*fitted.summary.template_shape.buried, share, 1e-12);
  EXPECT_FALSE(fitted.summary.reference.buried || pulled.summary.template_shape.buried);
  EXPECT_NE(verdict_lines(fitted.summary)[0].find("where both have data"), std::string::npos);
  EXPECT_TRUE(std::ranges::any_of(fitted.surfaces.distance, [](double d) { return std::isnan(d); }));
  EXPECT_FALSE(std::ranges::any_of(pulled.surfaces.distance, [](double d) { return std::isnan(d); }));
}

TEST_F(Buried, TheOtherWayRound) {
  const Shape<3> open = ring("open"), clasped = ring("clasped");
  Heard heard;
  ExperimentOptions o = options(Burial::left_out);
  o.cascade.max_level = 5;
  const MatchResult<3> fitted = match_shapes(clasped, open, o, heard);
  EXPECT_TRUE(fitted.summary.reference.buried.has_value());
  EXPECT_EQ(fitted.summary.levels.back().folds.n_folded_cells, 0);
}

TEST_F(Buried, TheProfileOfThePaperKeepsAll) {
  EXPECT_EQ(profile_defaults(Profile::paper).input.buried, Burial::kept);
  EXPECT_EQ(profile_defaults(Profile::standard).input.buried, Burial::left_out);
}

}  // namespace
}  // namespace shellmatch
