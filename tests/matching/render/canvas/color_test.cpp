#include "matching/render/canvas/color.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace shellmatch {
namespace {

TEST(ColorTest, OklabAndBackIsTheIdentity) {
  for (double r = 0; r <= 1; r += 0.25)
    for (double g = 0; g <= 1; g += 0.25)
      for (double b = 0; b <= 1; b += 0.25) {
        const Color c = color_from_oklab(oklab_from_color({r, g, b}));
        EXPECT_NEAR(c.r, r, 1e-5);
        EXPECT_NEAR(c.g, g, 1e-5);
        EXPECT_NEAR(c.b, b, 1e-5);
      }
}

TEST(ColorTest, GreysHaveNoChromaAndLightnessOrdersThem) {
  double last = -1;
  for (double v = 0; v <= 1; v += 0.125) {
    const Vec<3> lab = oklab_from_color({v, v, v});
    EXPECT_NEAR(lab[1], 0, 1e-4);
    EXPECT_NEAR(lab[2], 0, 1e-4);
    EXPECT_GT(lab[0], last);
    last = lab[0];
  }
  EXPECT_NEAR(last, 1, 1e-6);
}

TEST(ColorTest, ColoursOutsideOfTheGamutKeepLightnessAndHue) {
  const Vec<3> wanted(0.6, 0.3, 0.2);
  const Vec<3> lab = oklab_from_color(color_from_oklab(wanted));
  EXPECT_NEAR(lab[0], wanted[0], 1e-4);
  EXPECT_NEAR(std::atan2(lab[2], lab[1]), std::atan2(wanted[2], wanted[1]), 1e-3);
  EXPECT_LT(lab.tail<2>().norm(), wanted.tail<2>().norm());
}

// Equal steps must look equal: that is what keeps a colour map from showing edges that are not there.
TEST(ColorTest, MapsAreUniform) {
  for (const ColorMap map : {ColorMap::sequential, ColorMap::diverging}) {
    double least = std::numeric_limits<double>::infinity(), most = 0;
    for (int i = 0; i < 64; ++i) {
      const double step =
          (oklab_from_color(map_color(map, (i + 1) / 64.0)) - oklab_from_color(map_color(map, i / 64.0))).norm();
      least = std::min(least, step);
      most = std::max(most, step);
    }
    EXPECT_LT(most / least, 1.03);
  }
}

TEST(ColorTest, SequentialGetsLighterAndDivergingIsSymmetric) {
  for (int i = 0; i < 64; ++i)
    EXPECT_LT(oklab_from_color(map_color(ColorMap::sequential, i / 64.0))[0],
              oklab_from_color(map_color(ColorMap::sequential, (i + 1) / 64.0))[0]);
  for (const double t : {0.1, 0.25, 0.4})
    EXPECT_NEAR(oklab_from_color(map_color(ColorMap::diverging, t))[0],
                oklab_from_color(map_color(ColorMap::diverging, 1 - t))[0], 0.02);
  EXPECT_GT(oklab_from_color(map_color(ColorMap::diverging, 0.5))[0], 0.93);
}

TEST(ColorTest, MapsClampAndNanIsGrey) {
  EXPECT_EQ(map_color(ColorMap::sequential, -3).r, map_color(ColorMap::sequential, 0).r);
  EXPECT_EQ(map_color(ColorMap::sequential, 7).g, map_color(ColorMap::sequential, 1).g);
  const Color grey = map_color(ColorMap::sequential, std::nan(""));
  EXPECT_EQ(grey.r, grey.g);
  EXPECT_EQ(grey.g, grey.b);
}

TEST(ColorTest, SeriesColoursAreFarApart) {
  for (int i = 0; i < 8; ++i)
    for (int j = 0; j < i; ++j)
      EXPECT_GT((oklab_from_color(series_color(i)) - oklab_from_color(series_color(j))).norm(), 0.08) << i << " " << j;
}

}  // namespace
}  // namespace shellmatch
