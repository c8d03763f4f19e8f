// Tips are the ends of limbs, whatever the order of vertices and the pose; matched tips carry the surface.
#include "alignment/functional_map/starts.h"
#include "alignment/spectrum/limb_ends.h"
#include "geometry/generate/hand.h"
#include "tests/geometry/generate/generated_surface.h"
#include "tests/geometry/surface/test_surfaces.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

namespace shellmatch {
namespace {

const Surface<3>& hand() {
  static const Surface<3> surface = generated_surface("hand", "", 0.02);
  return surface;
}

std::vector<SurfaceTip> tips_of(Surface<3> surface, std::size_t n = 7) {
  const double root_area = std::sqrt(test::boundary_measure(surface));
  for (Vec<3>& x : surface.vertices) x /= root_area;
  const EdgeGraph graph(surface);
  return surface_tips(graph, farthest_point_samples(graph, 0, n_tip_samples), n);
}

/// Tips whose vertices are 0, 1, ... with these lengths of limbs, which begin at a front and a back end of a trunk.
std::vector<SurfaceTip> tips_of_limbs(const std::vector<double>& at_front, const std::vector<double>& at_back,
                                      double trunk) {
  std::vector<double> lengths = at_front;
  lengths.insert(lengths.end(), at_back.begin(), at_back.end());
  const auto is_front = [&](std::size_t i) { return i < at_front.size(); };
  std::vector<SurfaceTip> tips;
  for (std::size_t i = 0; i < lengths.size(); ++i) {
    SurfaceTip& tip = tips.emplace_back(static_cast<Index>(i), 0.3);
    for (std::size_t j = 0; j < lengths.size(); ++j)
      tip.distances.push_back(i == j ? 0 : lengths[i] + lengths[j] + (is_front(i) == is_front(j) ? 0 : trunk));
  }
  const std::vector<int> twins = twins_of_tips(tips);
  for (std::size_t i = 0; i < tips.size(); ++i) tips[i].twin = twins[i];
  return tips;
}

// Head, front legs; hind legs, tail.
std::vector<SurfaceTip> short_tailed() { return tips_of_limbs({0.5, 0.9, 0.9}, {0.8, 0.8, 0.25}, 0.8); }
std::vector<SurfaceTip> long_tailed() { return tips_of_limbs({0.4, 0.7, 0.7}, {0.7, 0.7, 1.1}, 0.8); }

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

TEST(SurfaceTips, LegsAreTwins) {
  const std::vector<int> expected = {0, 2, 1, 4, 3, 5};
  EXPECT_EQ(twins_of_tips(short_tailed()), expected);
  EXPECT_EQ(twins_of_tips(long_tailed()), expected);
  // In another pose distances along the surface differ a little.
  EXPECT_EQ(twins_of_tips(tips_of_limbs({0.4, 0.7, 0.73}, {0.7, 0.72, 1.1}, 0.8)), expected);
  const std::vector<int> none = {0, 1, 2, 3, 4, 5};
  EXPECT_EQ(twins_of_tips(tips_of_limbs({0.2, 0.4, 0.8}, {1.2, 1.7, 2.4}, 0.8)), none);
}

TEST(SurfaceTips, DisorderTellsMissesAndExchangedTwins) {
  const std::vector<SurfaceTip> tips = short_tailed(), others = long_tailed();
  const std::vector<Index> right = {0, 1, 2, 3, 4, 5}, mirrored = {0, 2, 1, 4, 3, 5};
  EXPECT_EQ(tip_disorder(tips, right, others, right), 0);
  EXPECT_EQ(tip_disorder(tips, mirrored, others, mirrored), 0) << "twins of twins are twins";
  // The tail and a hind leg are exchanged: three of six tips have a twin whose image is no twin.
  const std::vector<Index> exchanged = {0, 1, 2, 3, 5, 4};
  EXPECT_NEAR(tip_disorder(tips, exchanged, others, exchanged), 1, 1e-12);
  // One of twelve images is half as far from a tip as what counts as no tip.
  std::vector<SurfaceTip> with_place = others;
  for (SurfaceTip& tip : with_place) tip.distances.push_back(tip.vertex == 0 ? 0.2 : 3);
  EXPECT_NEAR(tip_disorder(tips, {6, 1, 2, 3, 4, 5}, with_place, right), 0.25 / 12, 1e-12);
  // The one tip of a round shape tells nothing, wherever it is taken.
  EXPECT_EQ(tip_disorder({with_place[0]}, {6}, {with_place[1]}, {6}), 0);
}

TEST(SurfaceTips, LimbsEndWhereAMotionTakesThem) {
  const LimbEnds ends = limb_ends(hand(), {});
  EXPECT_EQ(ends.share, 1);
  std::vector<Vec<3>> moved = ends.vertices;
  for (Vec<3>& x : moved) x += Vec<3>(3, 0, 0);
  EXPECT_EQ(limb_disorder(ends, moved, ends, moved), 0);
  // All of the hand in the middle of the palm.
  const auto from_tips = [&](std::size_t v) {
    double least = 10;
    for (const SurfaceTip& tip : ends.tips) least = std::min(least, tip.distances[v]);
    return least;
  };
  std::size_t middle = 0;
  for (std::size_t v = 0; v < moved.size(); ++v)
    if (from_tips(v) > from_tips(middle)) middle = v;
  const std::vector<Vec<3>> collapsed(moved.size(), moved[middle]);
  EXPECT_GT(limb_disorder(ends, collapsed, ends, moved), 0.5);
}

TEST(TipStarts, LegsGoToLegs) {
  const auto n_legs_to_others = [](const std::vector<SurfaceTip>& tips, const std::vector<SurfaceTip>& others) {
    const auto is_leg = [](int i) { return i > 0 && i < 5; };
    const TipAssignment best = assign_tips(tips, others, 1).at(0);
    return std::ranges::count_if(best.pairs, [&](const auto& p) { return is_leg(p.first) != is_leg(p.second); });
  };
  std::vector<SurfaceTip> tips = short_tailed(), others = long_tailed();
  EXPECT_EQ(n_legs_to_others(tips, others), 0);
  // By distances alone the long tail is a leg.
  for (auto* all : {&tips, &others})
    for (std::size_t i = 0; i < all->size(); ++i) (*all)[i].twin = static_cast<int>(i);
  EXPECT_GT(n_legs_to_others(tips, others), 0);
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
  const std::vector<int> twins = twins_of_tips(fewer);
  for (std::size_t i = 0; i < fewer.size(); ++i) fewer[i].twin = twins[i];
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
  Embedding distances;
  const SpectralShape* const shapes[2] = {&shape, &bent};
  for (int s = 0; s < 2; ++s) {
    const Features all = tip_features(*shapes[s], best[0], s);
    distances.on[s] = all(Eigen::all, pair.coarsest[s].vertices);
  }
  const VertexMatches matches = match_vertices(pair.coarsest, distances, 200);
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
