#include "matching/alignment/search_starts.h"

#include "matching/input/shape_source.h"

#include <gtest/gtest.h>

namespace shellmatch {
namespace {

TEST(SearchStarts, ATurnedSurfaceFindsTheSameMapAsTheOneThatLiesAsItBelongs) {
  const auto shape = [](const char* name) { return std::get<Shape<3>>(open_shape(name)); };
  const AlignOptions options;
  const Shape<3> bent = shape("generate:dolphin/bent");
  const StartSearch<3> straight = search_starts(ShapePair<3>{shape("generate:dolphin/straight"), bent}, options),
                       reversed = search_starts(ShapePair<3>{shape("generate:dolphin/reversed"), bent}, options);
  EXPECT_NEAR(reversed.starts[0].score, straight.starts[0].score, 1e-3);
  EXPECT_GT(straight.margin, 1.5);
  EXPECT_GT(reversed.margin, 1.5);
}

}  // namespace
}  // namespace shellmatch
