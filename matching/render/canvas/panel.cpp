#include "matching/render/canvas/panel.h"

#include "base/error.h"
#include "matching/render/canvas/ticks.h"

#include <algorithm>
#include <vector>

namespace shellmatch {

namespace {

constexpr int gap = 12, title_height = 44, caption_height = 34, bar_height = 58;

// The bar uses the rectangle at (left, top) of width `width` and height bar_height.
void draw_bar(const ColorBar& bar, double left, double top, double width, Canvas& canvas) {
  const double length = 0.72 * width, x0 = left + 0.5 * (width - length), thickness = 11;
  const int n_steps = static_cast<int>(length);
  for (int i = 0; i < n_steps; ++i)
    canvas.rectangle({x0 + i * length / n_steps, top}, {length / n_steps + 0.5, thickness},
                     map_color(bar.map, (i + 0.5) / n_steps));
  const double range = bar.max - bar.min;
  if (range > 0)
    for (const Tick& t : linear_ticks(bar.min, bar.max, 4)) {
      const double x = x0 + length * (t.value - bar.min) / range;
      canvas.polyline(std::array{Vec<2>(x, top + thickness), Vec<2>(x, top + thickness + 4)}, false,
                      {axis_grey, 1, 1, {}});
      canvas.text(t.label, {x, top + thickness + 8}, {.size = 11, .color = axis_grey, .anchor_x = 0.5, .anchor_y = 1});
    }
  canvas.text(bar.label, {left + 0.5 * width, top + thickness + 37}, {.size = 12, .color = axis_grey, .anchor_x = 0.5});
}

}  // namespace

Image compose_panels(std::span<const Panel> panels, const std::string& title, int columns) {
  return draw_panels(panels, title, columns, CanvasKind::raster).to_image();
}

Canvas draw_panels(std::span<const Panel> panels, const std::string& title, int columns, CanvasKind kind) {
  SHELLMATCH_CHECK(!panels.empty(), "a figure needs a panel");
  const int n = static_cast<int>(panels.size());
  if (columns <= 0) columns = n;
  columns = std::min(columns, n);
  const int n_rows = (n + columns - 1) / columns;
  int width = 0, height = 0;
  bool captions = false;
  std::vector<char> has_bar(static_cast<std::size_t>(n_rows), 0);  // by row
  for (int i = 0; i < n; ++i) {
    const Panel& p = panels[i];
    width = std::max(width, p.image.width);
    height = std::max(height, p.image.height);
    captions |= !p.caption.empty();
    if (p.bar) has_bar[i / columns] = 1;
  }
  const int top = title.empty() ? gap : title_height;
  std::vector<int> row_top{top};
  for (const char bar : has_bar)
    row_top.push_back(row_top.back() + height + (captions ? caption_height : 0) + (bar ? bar_height : 0) + gap);
  Canvas canvas(columns * width + (columns + 1) * gap, row_top.back(), kind);
  canvas.text(title, {0.5 * canvas.width(), 0.5 * title_height},
              {.size = 18, .bold = true, .anchor_x = 0.5, .anchor_y = 0.5});
  for (int i = 0; i < n; ++i) {
    const Panel& p = panels[i];
    const int x = gap + (i % columns) * (width + gap), y = row_top[i / columns];
    canvas.image(p.image, x + (width - p.image.width) / 2, y + (height - p.image.height) / 2);
    canvas.text(p.caption, {x + 0.5 * width, y + height + 0.5 * caption_height},
                {.size = 15, .anchor_x = 0.5, .anchor_y = 0.5});
    if (p.bar) draw_bar(*p.bar, x, y + height + (captions ? caption_height : 4), width, canvas);
  }
  return canvas;
}

}  // namespace shellmatch
