#include "matching/render/canvas/plot.h"

#include "base/error.h"
#include "matching/render/canvas/ticks.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace shellmatch {

namespace {

constexpr double font = 13;
const Color light_grey{0.88, 0.89, 0.91}, faint{0.94, 0.945, 0.95};

// Map of one axis from values to pixels.
struct Axis {
  bool log = false;
  double min = std::numeric_limits<double>::infinity(), max = -min;
  double from = 0, to = 1;  // pixels of min and max

  bool shows(double v) const { return std::isfinite(v) && (!log || v > 0); }
  void add(double v) {
    min = std::min(min, v);
    max = std::max(max, v);
  }
  double unit(double v) const { return log ? std::log10(v) : v; }
  // Widens an axis without extent, and adds a margin to others.
  void finish(double air) {
    if (log) {
      const double extent = std::max(std::log10(max / min), 0.05);
      min *= std::pow(10, -air * extent);
      max *= std::pow(10, air * extent);
      return;
    }
    const double extent = max > min ? max - min : std::max(1e-12, 0.1 * std::abs(max));
    min -= air * extent;
    max += air * extent;
  }
  double pixel(double v) const { return from + (to - from) * (unit(v) - unit(min)) / (unit(max) - unit(min)); }
  std::vector<Tick> ticks(int wanted) const {
    return log ? log_ticks(min, max, wanted) : linear_ticks(min, max, wanted);
  }
};

// The dash pattern of a series.
std::vector<double> dashes_of(const Series& s) {
  static const std::vector<double> patterns[] = {{}, {7, 4}, {2, 3}, {9, 3, 2, 3}, {14, 5}, {5, 3, 1, 3, 1, 3}};
  return patterns[s.dashes == 0 && s.dashed ? 1 : std::clamp(s.dashes, 0, 5)];
}

Color color_of(const Plot& plot, std::size_t k) {
  const int chosen = plot.series[k].color;
  return series_color(chosen < 0 ? static_cast<int>(k) : chosen);
}

bool point_shows(const Axis& x, const Axis& y, const Series& s, std::size_t i) {
  return x.shows(s.x[i]) && y.shows(s.y[i]);
}

void draw_series(const Series& s, const Color& color, const Axis& x, const Axis& y, Canvas& canvas) {
  std::vector<Vec<2>> run;
  const auto flush = [&] {
    if (s.line && run.size() > 1) canvas.polyline(run, false, {color, 1.8, 1, dashes_of(s)});
    if (s.points || !s.line || run.size() == 1)
      for (const Vec<2>& p : run) canvas.disc(p, s.point_radius, color);
    run.clear();
  };
  for (std::size_t i = 0; i < s.x.size(); ++i) {
    if (point_shows(x, y, s, i)) run.push_back({x.pixel(s.x[i]), y.pixel(s.y[i])});
    else flush();
  }
  flush();
}

// Draws the legend to the right of the plot, where it covers no line.
void draw_legend(const Plot& plot, double left, double top, Canvas& canvas) {
  double y = top + 10;
  for (std::size_t k = 0; k < plot.series.size(); ++k) {
    const Series& s = plot.series[k];
    if (s.name.empty()) continue;
    const Color color = color_of(plot, k);
    if (s.line)
      canvas.polyline(std::array{Vec<2>(left, y), Vec<2>(left + 26, y)}, false, {color, 2.4, 1, dashes_of(s)});
    if (s.points || !s.line) canvas.disc({left + 13, y}, 3.2, color);
    canvas.text(s.name, {left + 34, y}, {.size = font, .color = axis_grey, .anchor_y = 0.5});
    y += 1.6 * font;
  }
}

}  // namespace

void draw_plot(const Plot& plot, Canvas& canvas) {
  Axis x{.log = plot.log_x}, y{.log = plot.log_y};
  double legend = 0;
  for (const Series& s : plot.series) {
    SHELLMATCH_CHECK(s.x.size() == s.y.size(), "a series has as many x as y");
    if (!s.name.empty()) legend = std::max(legend, 58 + canvas.text_width(s.name, {.size = font}));
    for (std::size_t i = 0; i < s.x.size(); ++i)
      if (point_shows(x, y, s, i)) {
        x.add(s.x[i]);
        y.add(s.y[i]);
      }
  }
  double names = 0;
  for (const std::string& row : plot.rows) names = std::max(names, canvas.text_width(row, {.size = font}));
  const double left = std::max(84.0, names + 24), right = canvas.width() - 24 - legend,
               top = plot.title.empty() ? 22 : 50, bottom = canvas.height() - 62;
  canvas.text(plot.title, {0.5 * (left + right), 26},
              {.size = 1.25 * font, .bold = true, .anchor_x = 0.5, .anchor_y = 0.5});
  if (x.min > x.max) {
    canvas.text("no values to show", {0.5 * (left + right), 0.5 * (top + bottom)},
                {.size = font, .color = axis_grey, .anchor_x = 0.5});
    return;
  }
  x.finish(0.02);
  y.finish(0.05);
  if (!plot.rows.empty()) {
    y.min = -0.6;
    y.max = static_cast<double>(plot.rows.size()) - 0.4;
  }
  x.from = left;
  x.to = right;
  y.from = bottom;
  y.to = top;
  std::vector<Tick> y_ticks;
  if (plot.rows.empty()) {
    y_ticks = y.ticks(6);
  } else {
    std::swap(y.from, y.to);  // the first on top
    for (std::size_t k = 0; k < plot.rows.size(); ++k) y_ticks.push_back({static_cast<double>(k), plot.rows[k]});
  }

  for (const Tick& t : x.ticks(8)) {
    const double p = x.pixel(t.value);
    canvas.polyline(std::array{Vec<2>(p, top), Vec<2>(p, bottom)}, false,
                    {t.label.empty() ? faint : light_grey, 1, 1, {}});
    canvas.text(t.label, {p, bottom + 10}, {.size = font, .color = axis_grey, .anchor_x = 0.5, .anchor_y = 1});
  }
  for (const Tick& t : y_ticks) {
    const double p = y.pixel(t.value);
    canvas.polyline(std::array{Vec<2>(left, p), Vec<2>(right, p)}, false,
                    {t.label.empty() ? faint : light_grey, 1, 1, {}});
    canvas.text(t.label, {left - 8, p}, {.size = font, .color = axis_grey, .anchor_x = 1, .anchor_y = 0.5});
  }
  canvas.clip({left, top}, {right - left, bottom - top});
  for (const double m : plot.marks)
    if (x.shows(m))
      canvas.polyline(std::array{Vec<2>(x.pixel(m), top), Vec<2>(x.pixel(m), bottom)}, false,
                      {axis_grey, 1, 0.6, {2, 4}});
  for (std::size_t k = 0; k < plot.series.size(); ++k) draw_series(plot.series[k], color_of(plot, k), x, y, canvas);
  canvas.unclip();
  canvas.polyline(std::array{Vec<2>(left, top), Vec<2>(left, bottom), Vec<2>(right, bottom), Vec<2>(right, top)}, true,
                  {axis_grey, 1, 1, {}});
  canvas.text(plot.x_label, {0.5 * (left + right), canvas.height() - 18}, {.size = font, .anchor_x = 0.5});
  canvas.text(plot.y_label, {22, 0.5 * (top + bottom)}, {.size = font, .anchor_x = 0.5, .turn = 90});
  draw_legend(plot, right + 16, top, canvas);
}

void write_plot(const Plot& plot, const std::string& path) {
  const bool svg = path.size() > 4 && path.substr(path.size() - 4) == ".svg";
  Canvas canvas(plot.width, plot.height, svg ? CanvasKind::svg : CanvasKind::raster);
  draw_plot(plot, canvas);
  canvas.write(path);
}

}  // namespace shellmatch
