#include "matching/render/canvas/plot.h"
#include "base/error.h"
#include "matching/render/canvas/ticks.h"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <limits>
#include <sstream>

namespace shellmatch {
namespace {

TEST(TicksTest, LinearTicksLieInsideAtEqualSteps) {
  for (const auto& [min, max] : {std::pair{0.0, 1.0}, {-3.7, 12.1}, {1e-9, 2.3e-9}, {1e6, 1.0001e6}, {-0.5, 0.5}}) {
    const auto ticks = linear_ticks(min, max);
    ASSERT_GE(ticks.size(), 3u);
    ASSERT_LE(ticks.size(), 13u);
    const double step = ticks[1].value - ticks[0].value;
    const double digit = step / std::pow(10, std::floor(std::log10(step) + 1e-6));
    EXPECT_NEAR(std::min({std::abs(digit - 1), std::abs(digit - 2), std::abs(digit - 5)}), 0, 1e-6);
    for (std::size_t i = 0; i < ticks.size(); ++i) {
      EXPECT_GE(ticks[i].value, min - 1e-6 * step);
      EXPECT_LE(ticks[i].value, max + 1e-6 * step);
      if (i > 0) {
        EXPECT_NEAR(ticks[i].value - ticks[i - 1].value, step, 1e-6 * step);
      }
    }
  }
}

TEST(TicksTest, LogarithmicTicksLabelPowersOrFewInBetween) {
  int n_labels = 0;
  for (const Tick& t : log_ticks(2e-7, 3.0))
    if (!t.label.empty()) {
      ++n_labels;
      EXPECT_NEAR(std::log10(t.value), std::round(std::log10(t.value)), 1e-9);
    }
  EXPECT_GE(n_labels, 2);
  EXPECT_LE(n_labels, 7);
  n_labels = 0;
  for (const Tick& t : log_ticks(1.5, 7)) n_labels += !t.label.empty();
  EXPECT_EQ(n_labels, 2);  // 2 and 5
}

long ink(const Image& image, int x0, int x1, int y0, int y1) {
  long sum = 0;
  for (int y = y0; y < y1; ++y)
    for (int x = x0; x < x1; ++x) sum += 765 - image.at(x, y)[0] - image.at(x, y)[1] - image.at(x, y)[2];
  return sum;
}

Image drawn(const Plot& plot) {
  Canvas canvas(plot.width, plot.height);
  draw_plot(plot, canvas);
  return canvas.to_image();
}

TEST(PlotTest, AFallingLineLeavesInkInTheUpperLeftAndLowerRight) {
  Plot plot{.title = "", .x_label = "x", .y_label = "y", .log_y = true, .series = {{.name = "", .x = {}, .y = {}}}};
  const Image empty_axes = [&] {
    Plot p = plot;
    p.series[0] = {.name = "", .x = {0, 100}, .y = {1, 1e-4}, .dashed = false};
    p.series[0].y = {1, 1e-4};
    p.series[0].x = {0, 100};
    return drawn(p);
  }();
  Plot dense = plot;
  for (int i = 0; i <= 100; ++i) {
    dense.series[0].x.push_back(i);
    dense.series[0].y.push_back(std::pow(10, -0.04 * i));
  }
  // An exponential is a straight line on this axis: the same picture from two points and from a hundred.
  const Image image = drawn(dense);
  long differing = 0;
  for (std::size_t i = 0; i < image.pixels.size(); ++i)
    differing += std::abs(int(image.pixels[i]) - int(empty_axes.pixels[i])) > 60;
  EXPECT_LT(differing, 100);
  const int w = image.width, h = image.height;
  EXPECT_GT(ink(image, w / 10, w / 2, 0, h / 2), ink(image, w / 2, w, 0, h / 2) + 10000);
  EXPECT_GT(ink(image, w / 2, 9 * w / 10, h / 2, 8 * h / 10),
            ink(image, w / 10 + 10, w / 2, h / 2, 8 * h / 10) + 10000);
}

TEST(PlotTest, BadValuesInterruptTheLineAndNothingIsAPicture) {
  const double nan = std::nan(""), inf = std::numeric_limits<double>::infinity();
  Plot plot{.title = "t",
            .x_label = "",
            .y_label = "",
            .log_y = true,
            .series = {{.name = "a", .x = {1, 2, 3, 4}, .y = {nan, -1, 0, inf}}}};
  EXPECT_GT(ink(drawn(plot), 0, plot.width, 0, plot.height), 0);  // says that there is nothing
  plot.series[0].y = {2, nan, 2, 2};
  EXPECT_GT(ink(drawn(plot), 0, plot.width, 0, plot.height), 0);  // an axis of no extent
}

TEST(PlotTest, WritesPngAndSvg) {
  const Plot plot{
      .title = "Energy", .x_label = "x", .y_label = "y", .series = {{.name = "one", .x = {0, 1}, .y = {1, 2}}}};
  const std::string base = ::testing::TempDir() + "shellmatch_plot";
  write_plot(plot, base + ".png");
  EXPECT_EQ(read_png(base + ".png"), drawn(plot));
  write_plot(plot, base + ".svg");
  std::stringstream svg;
  svg << std::ifstream(base + ".svg").rdbuf();
  EXPECT_NE(svg.str().find("<svg"), std::string::npos);
  EXPECT_NE(svg.str().find("</svg>"), std::string::npos);
  std::filesystem::remove(base + ".png");
  std::filesystem::remove(base + ".svg");
}

}  // namespace
}  // namespace shellmatch
