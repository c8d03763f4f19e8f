#include "matching/alignment/narrow_gaps.h"

#include "geometry/repair/make_shape.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace shellmatch {
namespace {

/// A letter U of width 1 and height 1, whose arms have the thickness 0.3 and a gap of `gap` between them.
Surface<2> letter(double gap) {
  const double arm = 0.3, w = 2 * arm + gap, bottom = 0.3;
  const Vec<2> corners[] = {{0, 0}, {w, 0}, {w, 1}, {w - arm, 1}, {w - arm, bottom}, {arm, bottom}, {arm, 1}, {0, 1}};
  OriginalShape<2> outline;
  outline.polygons.emplace_back();
  for (int c = 0; c < 8; ++c)
    for (int i = 0; i < 50; ++i) {
      outline.polygons[0].push_back(static_cast<Index>(outline.vertices.size()));
      outline.vertices.push_back(corners[c] + (corners[(c + 1) % 8] - corners[c]) * (i / 50.0));
    }
  return make_shape(std::move(outline), "letter").surface;
}

double length(const Surface<2>& s) {
  double sum = 0;
  for (Index f = 0; f < static_cast<Index>(s.facets.size()); ++f) sum += facet_measure(s, f);
  return sum;
}

TEST(NarrowGaps, AreTheSidesThatFaceEachOther) {
  const Surface<2> u = letter(0.1);
  const SignedDistance<2> distance(u);
  // At the height 0.08 the opposite side is 0.02 away; the gap's two sides and its bottom are narrow.
  EXPECT_NEAR(narrow_gap_share(distance, 0.08), (2 * 0.7 + 0.1) / length(u), 0.02);
  EXPECT_LT(narrow_gap_share(distance, 0.01), 0.02);
  // The gap is of the body's outside: its thickness does not count.
  EXPECT_LT(narrow_gap_share(SignedDistance<2>(letter(1)), 0.08), 0.05);
}

TEST(NarrowGaps, TellWhichShapeIsToBeTheReference) {
  EXPECT_GT(narrow_gap_share(letter(0.04)), narrow_gap_share(letter(0.4)) + 0.2);
  EXPECT_TRUE(has_clearly_more_gaps(0.215, 0.1));
  EXPECT_FALSE(has_clearly_more_gaps(0.1, 0.215));
  EXPECT_FALSE(has_clearly_more_gaps(0.133, 0.1));
}

}  // namespace
}  // namespace shellmatch
