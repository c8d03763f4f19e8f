// Tips are the ends of limbs, whatever the order of vertices and the pose; matched tips carry the surface.
#include "alignment/functional_map/starts.h"
#include "geometry/generate/hand.h"
#include "tests/geometry/generate/generated_surface.h"
#include "tests/geometry/surface/test_surfaces.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

namespace shellmatch {
namespace {

const Surface<3>& hand() {
  static const Surface<3> surface = generated_surface("hand", "", 0.02);
  return surface;
}

std::vector<SurfaceTip> tips_of(const Surface<3>& surface, std::size_t n = 7) {
  const EdgeGraph graph(surface);
  return surface_tips(graph, farthest_point_samples(graph, 0, 50), n,
                      0.05 * std::sqrt(test::boundary_measure(surface)));
}

TEST(SurfaceTips, AreFingersAndWrist) {
  const Hand shape{HandOptions{}};
  const std::vector<SurfaceTip> tips = tips_of(hand());
  ASSERT_EQ(tips.size(), 6u);
  std::set<int> parts;
  for (const SurfaceTip& tip : tips) {
    const Vec<3>& x = hand().vertices[tip.vertex];
    const int part = shape.part_of(x);
    EXPECT_TRUE(parts.insert(part).second) << part << " twice";
    // No point of this finger stands out farther.
    const bool is_finger_upward = part > 0 && part < 5;
    for (const Vec<3>& y : hand().vertices)
      if (is_finger_upward && shape.part_of(y) == part) {
        EXPECT_LT(y[1], x[1] + 0.03);
      }
    EXPECT_EQ(tip.distances[tip.vertex], 0);
  }
  EXPECT_TRUE(std::is_sorted(tips.begin(), tips.end(),
                             [](const SurfaceTip& a, const SurfaceTip& b) { return a.prominence > b.prominence; }));
  EXPECT_EQ(tips_of(hand(), 3).size(), 3u);
}

TEST(SurfaceTips, SphereHasTheHighestPointAlone) {
  // Mean distances of a sphere's points differ by the mesh alone.
  EXPECT_EQ(tips_of(test::unit_sphere(4)).size(), 1u);
}

TEST(TipStarts, OwnTipsCostNothing) {
  const std::vector<SurfaceTip> tips = tips_of(hand());
  const std::vector<TipAssignment> best = assign_tips(tips, tips, 10);
  ASSERT_EQ(best.size(), 10u);
  ASSERT_EQ(best[0].pairs.size(), tips.size());
  for (const auto& [a, b] : best[0].pairs) EXPECT_EQ(a, b);
  EXPECT_NEAR(best[0].cost, 0, 1e-12);
  for (std::size_t i = 1; i < best.size(); ++i) EXPECT_GE(best[i].cost, best[i - 1].cost);
  EXPECT_GT(best[1].cost, 0.01);
}

TEST(TipStarts, ATipThatOneSurfaceLacksIsLeftOut) {
  const std::vector<SurfaceTip> tips = tips_of(hand());
  std::vector<SurfaceTip> fewer = tips;
  fewer.erase(fewer.begin() + 2);
  const TipAssignment best = assign_tips(tips, fewer, 1).at(0);
  ASSERT_EQ(best.pairs.size(), fewer.size());
  for (const auto& [a, b] : best.pairs)
    EXPECT_EQ(tips[static_cast<std::size_t>(a)].vertex, fewer[static_cast<std::size_t>(b)].vertex);
  EXPECT_TRUE(assign_tips({tips[0], tips[1]}, tips, 5).empty()) << "two tips tell nothing";
}

TEST(TipStarts, MatchedTipsCarryTheSurface) {
  const SpectralShape shape = make_spectral_shape(hand(), {}),
                      bent = make_spectral_shape(generated_surface("hand", "bent", 0.02), {});
  const ShapePairSpectra pair = make_shape_pair(shape, bent);
  const std::vector<TipAssignment> best = assign_tips(shape.tips, bent.tips, 1);
  ASSERT_EQ(best.size(), 1u);
  // Fingers are carried to the same fingers; between the palm's sides distances from tips do not decide.
  const VertexMatches matches = match_by_tips(pair, best[0], 200);
  const Hand from{HandOptions{}},
      to{{.bend_thumb = 20, .bend_index = 25, .bend_middle = 30, .bend_ring = 25, .bend_little = 20}};
  int n = 0, n_same = 0;
  for (std::size_t i = 0; i < matches.from[0].size(); ++i) {
    const int part = from.part_of(shape.in_input_coordinates(shape.surface.vertices[matches.from[0][i]]));
    if (part < 0 || part == 5) continue;
    ++n;
    n_same += part == to.part_of(bent.in_input_coordinates(bent.surface.vertices[matches.to[0][i]]));
  }
  EXPECT_GT(n, 50);
  EXPECT_GT(n_same, 0.9 * n);
}

}  // namespace
}  // namespace shellmatch
