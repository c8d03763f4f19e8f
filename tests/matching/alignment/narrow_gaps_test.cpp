#include "matching/alignment/narrow_gaps.h"

#include "tests/matching/alignment/letter.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace shellmatch {
namespace {

using testing::letter;

double length(const Surface<2>& s) {
  double sum = 0;
  for (Index f = 0; f < static_cast<Index>(s.facets.size()); ++f) sum += facet_measure(s, f);
  return sum;
}

TEST(NarrowGaps, AreTheSidesThatFaceEachOther) {
  const Surface<2> u = letter(0.1).surface;
  const SignedDistance<2> distance(u);
  // At the height 0.08 the opposite side is 0.02 away; the gap's two sides and its bottom are narrow.
  EXPECT_NEAR(narrow_gap_share(distance, 0.08), (2 * 0.7 + 0.1) / length(u), 0.02);
  EXPECT_LT(narrow_gap_share(distance, 0.01), 0.02);
  // The gap is of the body's outside: its thickness does not count.
  EXPECT_LT(narrow_gap_share(SignedDistance<2>(letter(1).surface), 0.08), 0.05);
}

TEST(NarrowGaps, TellWhichShapeIsToBeTheReference) {
  EXPECT_GT(narrow_gap_share(letter(0.04).surface), narrow_gap_share(letter(0.4).surface) + 0.2);
  EXPECT_TRUE(has_clearly_more_gaps(0.215, 0.1));
  EXPECT_FALSE(has_clearly_more_gaps(0.1, 0.215));
  EXPECT_FALSE(has_clearly_more_gaps(0.133, 0.1));
}

}  // namespace
}  // namespace shellmatch
