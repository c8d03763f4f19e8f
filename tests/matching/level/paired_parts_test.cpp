#include "matching/level/paired_parts.h"

#include "tests/geometry/surface/test_surfaces.h"

#include <gtest/gtest.h>

namespace shellmatch {
namespace {

// A ball of which the half below has no partner, in the unit domain, and a part that was closed with a lid.
const Vec<3> centre(0.5, 0.5, 0.5);
struct Ball {
  Shape<3> whole, part;
  std::vector<PairSet<3>> sets = std::vector<PairSet<3>>(1);

  Ball() {
    whole.surface = test::mapped<3>(test::unit_sphere(4), [](const Vec<3>& x) { return Vec<3>(centre + 0.3 * x); });
    part.surface = whole.surface;
    part.evidence.observed = part.evidence.unobserved = {whole.surface.vertices, {}};
    for (const auto& facet : whole.surface.facets)
      (whole.surface.vertices[facet[0]][2] > 0.5 ? part.evidence.observed : part.evidence.unobserved)
          .facets.push_back(facet);
    sets[0].name = "alignment";
    for (std::size_t v = 0; v < whole.surface.vertices.size(); v += 4) {
      const Vec<3>& x = whole.surface.vertices[v];
      if (x[2] > 0.5) sets[0].pairs.pairs.push_back({x, x});
    }
  }
};

ObservedPair<3> paired(const Shape<3>& deformed, const Shape<3>& other, const std::vector<PairSet<3>>& sets) {
  return paired_parts(observed_pair(deformed, other), deformed, other, sets);
}

TEST(PairedParts, OfTheWholeOnlyWhatIsNearPairsCounts) {
  const Ball ball;
  const Vec<3> above(0.5, 0.5, 0.8), below(0.5, 0.5, 0.2);
  for (const bool whole_first : {true, false}) {
    const auto parts =
        whole_first ? paired(ball.whole, ball.part, ball.sets) : paired(ball.part, ball.whole, ball.sets);
    EXPECT_TRUE(parts.contains(above, above));
    EXPECT_FALSE(parts.contains(whole_first ? below : above, whole_first ? above : below));
  }
}

// A side of the part has no pairs: that side of the whole counts.
TEST(PairedParts, WhereThePartHasNoPairsTheWholeNeedsNone) {
  Ball ball;
  std::erase_if(ball.sets[0].pairs.pairs, [](const PointPair<3>& pair) { return pair.p[0] > 0.55; });
  const ObservedPart<3> part = paired(ball.whole, ball.part, ball.sets).reference;
  EXPECT_TRUE(part.contains(centre + 0.3 * Vec<3>(1, 0, 0.3).normalized()));
  EXPECT_TRUE(part.contains(centre + 0.3 * Vec<3>(-1, 0, 0.3).normalized()));
  EXPECT_FALSE(part.contains(centre + 0.3 * Vec<3>(-0.3, 0, -1).normalized()));
}

TEST(PairedParts, WithoutPairsOfTheSearchAllCounts) {
  Ball ball;
  ball.sets[0].name = "landmarks";
  EXPECT_TRUE(paired(ball.whole, ball.part, ball.sets).reference.is_all());
  EXPECT_TRUE(paired(ball.whole, ball.part, {}).reference.is_all());
}

// What was made up of the whole stays so, and what has no partner is added.
TEST(PairedParts, GapsOfTheWholeRemain) {
  Ball ball;
  Evidence<3>& evidence = ball.whole.evidence;
  evidence.observed = evidence.unobserved = {ball.whole.surface.vertices, {}};
  for (const auto& facet : ball.whole.surface.facets)
    (ball.whole.surface.vertices[facet[0]][0] > 0.7 ? evidence.unobserved : evidence.observed).facets.push_back(facet);
  const ObservedPart<3> part = paired(ball.whole, ball.part, ball.sets).reference;
  EXPECT_TRUE(part.contains({0.5, 0.5, 0.8}));
  EXPECT_FALSE(part.contains({0.8, 0.5, 0.5}));
  EXPECT_FALSE(part.contains({0.5, 0.5, 0.2}));
}

}  // namespace
}  // namespace shellmatch
