#include "matching/render/canvas/contours.h"
#include "tests/matching/render/test_shapes.h"

#include <gtest/gtest.h>

namespace shellmatch {
namespace {

using testing::both;
using testing::circle;

// Share of the picture's darkness, 0 for white and 1 for black.
double ink(const Image& image) {
  double sum = 0;
  for (const std::uint8_t p : image.pixels) sum += 255 - p;
  return sum / (255.0 * static_cast<double>(image.pixels.size()));
}

TEST(ContoursTest, AreaOfADiscAndOfARing) {
  const Surface<2> disc = circle(200, 0.4, {0.5, 0.5});
  RenderContour look{.contour = &disc, .fill = black, .fill_alpha = 1, .line_width = 0};
  EXPECT_NEAR(ink(render_contours(std::span(&look, 1), Frame{}, 200, 200)), std::numbers::pi * 0.16, 1e-3);

  for (const bool clockwise : {true, false}) {  // a hole is a hole however it is oriented
    const Surface<2> ring = both(disc, circle(200, 0.2, {0.5, 0.5}, clockwise));
    look.contour = &ring;
    EXPECT_EQ(rings_of(ring).size(), 2u);
    EXPECT_NEAR(ink(render_contours(std::span(&look, 1), Frame{}, 200, 200)), std::numbers::pi * 0.12, 1e-3);
  }
}

TEST(ContoursTest, LinesAreAsLongAndWideAsTheyShould) {
  const Surface<2> line = circle(400, 0.4, {0.5, 0.5});
  const RenderContour look{.contour = &line, .line_width = 3};
  EXPECT_NEAR(ink(render_contours(std::span(&look, 1), Frame{}, 300, 300)), 2 * std::numbers::pi * 0.4 * 3 / 300, 1e-3);
}

TEST(ContoursTest, DashesLeaveGapsInWhichWhatLiesBelowIsSeen) {
  const Surface<2> line = circle(400, 0.4, {0.5, 0.5});
  const RenderContour whole{.contour = &line, .line_width = 3},
      dashed{.contour = &line, .line_width = 3, .dashes = {6, 6}};
  const double all = ink(render_contours(std::span(&whole, 1), Frame{}, 300, 300)),
               half = ink(render_contours(std::span(&dashed, 1), Frame{}, 300, 300));
  EXPECT_NEAR(half / all, 0.5, 0.03);
}

TEST(ContoursTest, UpIsUpAndTheFrameIsNotStretched) {
  const Surface<2> spot = circle(50, 0.05, {0.5, 0.9});
  const RenderContour look{.contour = &spot, .fill = black, .fill_alpha = 1};
  const Image image = render_contours(std::span(&look, 1), Frame{}, 200, 100);
  EXPECT_EQ(*image.at(100, 10), 0);
  EXPECT_EQ(*image.at(100, 90), 255);
  EXPECT_EQ(*image.at(112, 10), 255);
}

TEST(ContoursTest, FrameHoldsAllContours) {
  const Surface<2> a = circle(20, 1, {3, -2}), b = circle(20, 0.5, {5, 1});
  const Surface<2>* all[] = {&a, &b};
  const Frame frame = fit_frame(all, 0.1);
  for (const Surface<2>* s : all)
    for (const Vec<2>& v : s->vertices) {
      EXPECT_TRUE((v.array() > frame.min.array()).all());
      EXPECT_TRUE((v.array() < frame.max.array()).all());
    }
}

}  // namespace
}  // namespace shellmatch
