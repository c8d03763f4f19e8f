#include "matching/render/canvas/contours.h"

#include "base/error.h"
#include "matching/render/canvas/canvas.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace shellmatch {

namespace {

// Map from the plane to pixels, with the same scale along both axes.
struct PixelMap {
  double scale;
  Vec<2> centre, middle;
  PixelMap(const Frame& frame, int width, int height)
      : scale(std::min(width / (frame.max.x() - frame.min.x()), height / (frame.max.y() - frame.min.y()))),
        centre(0.5 * (frame.min + frame.max)),
        middle(0.5 * width, 0.5 * height) {}
  Vec<2> operator()(const Vec<2>& x) const {
    return {middle.x() + scale * (x.x() - centre.x()), middle.y() - scale * (x.y() - centre.y())};
  }
};

}  // namespace

Frame fit_frame(std::span<const Surface<2>* const> contours, double margin) {
  Box<2> box;
  for (const Surface<2>* c : contours)
    for (const Vec<2>& v : c->vertices) box.add(v);
  SHELLMATCH_CHECK((box.min.array() <= box.max.array()).all(), "a frame needs points");
  const double border = std::max(1e-12, margin * (box.max - box.min).maxCoeff());
  return {box.min.array() - border, box.max.array() + border};
}

std::vector<std::vector<Vec<2>>> rings_of(const Surface<2>& contour) {
  std::vector<Index> next(contour.vertices.size(), no_index);
  for (const auto& [a, b] : contour.facets) next[a] = b;
  std::vector<char> done(contour.vertices.size(), 0);
  std::vector<std::vector<Vec<2>>> rings;
  for (const auto& [start, unused] : contour.facets) {
    std::vector<Vec<2>> ring;
    for (Index v = start; v != no_index && !done[v]; v = next[v]) {
      done[v] = 1;
      ring.push_back(contour.vertices[v]);
    }
    if (ring.size() > 1) rings.push_back(std::move(ring));
  }
  return rings;
}

Image render_contours(std::span<const RenderContour> contours, const Frame& frame, int width, int height,
                      std::span<const RenderLines> lines) {
  const PixelMap to_pixels(frame, width, height);
  Canvas canvas(width, height);
  for (const RenderLines& grid : lines)
    for (const auto& [a, b] : grid.segments)
      canvas.polyline(std::array{to_pixels(a), to_pixels(b)}, false, {grid.color, grid.width, 1, {}});

  for (const RenderContour& c : contours) {
    SHELLMATCH_CHECK(c.vertex_colors.empty() || c.vertex_colors.size() == c.contour->vertices.size(),
                     "one colour for each vertex");
    std::vector<std::vector<Vec<2>>> rings = rings_of(*c.contour);
    for (auto& ring : rings)
      for (Vec<2>& p : ring) p = to_pixels(p);
    if (c.fill_alpha > 0) canvas.fill(rings, c.fill, c.fill_alpha);
    if (c.line_width > 0) {
      if (c.vertex_colors.empty()) {
        for (const auto& ring : rings) canvas.polyline(ring, true, {c.line, c.line_width, c.line_alpha, c.dashes});
      } else {
        for (const auto& [a, b] : c.contour->facets)
          canvas.polyline(std::array{to_pixels(c.contour->vertices[a]), to_pixels(c.contour->vertices[b])}, false,
                          {mix(c.vertex_colors[a], c.vertex_colors[b], 0.5), c.line_width, c.line_alpha, {}});
      }
    }
    if (c.point_radius > 0)
      for (std::size_t i = 0; i < c.contour->vertices.size(); ++i)
        canvas.disc(to_pixels(c.contour->vertices[i]), c.point_radius,
                    c.vertex_colors.empty() ? c.line : c.vertex_colors[i], c.line_alpha);
  }
  return canvas.to_image();
}

std::vector<Color> position_colors(const std::vector<Vec<2>>& points, const Box<2>& box) {
  const Vec<2> centre = 0.5 * (box.min + box.max);
  std::vector<Color> colors;
  colors.reserve(points.size());
  // The hue is the direction from the middle, so opposite sides have opposite hues.
  for (const Vec<2>& p : points) {
    const Vec<2> d = p - centre;
    colors.push_back(color_from_oklch(0.66, 0.15, std::atan2(d.y(), d.x()) * 180 / std::numbers::pi));
  }
  return colors;
}

}  // namespace shellmatch
