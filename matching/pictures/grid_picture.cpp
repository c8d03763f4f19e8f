#include "matching/pictures/grid_picture.h"

#include "matching/render/canvas/contours.h"
#include "matching/render/canvas/panel.h"

#include <fmt/core.h>

namespace shellmatch {

namespace {

// The two axes within a plane across `axis`, in their order.
std::array<int, 2> axes_of_plane(int axis) { return {axis == 0 ? 1 : 0, axis == 2 ? 1 : 2}; }

Vec<2> in_plane(const Vec<3>& x, int axis) {
  const auto [a, b] = axes_of_plane(axis);
  return {x[a], x[b]};
}

}  // namespace

SliceLines slice_grid(const Octree<3>& grid, int axis, double place) {
  SliceLines lines;
  for (const Index leaf : grid.leaves()) {
    const auto& cell = grid.cell(leaf);
    const Vec<3> low = grid.node_position(cell.nodes[0]);
    const double side = cell.side();
    if (place < low[axis] || place >= low[axis] + side) continue;
    const Vec<2> a = in_plane(low, axis), b = a + Vec<2>(side, 0), c = a + Vec<2>(side, side), d = a + Vec<2>(0, side);
    for (const auto& line : {std::array{a, b}, std::array{b, c}, std::array{c, d}, std::array{d, a}})
      lines.push_back(line);
  }
  return lines;
}

SliceLines slice_surface(const Surface<3>& surface, int axis, double place) {
  SliceLines lines;
  for (const auto& facet : surface.facets) {
    std::array<Vec<2>, 3> cuts;
    int n = 0;
    for (int k = 0; k < 3; ++k) {
      const Vec<3>& a = surface.vertices[facet[k]];
      const Vec<3>& b = surface.vertices[facet[(k + 1) % 3]];
      const double from = a[axis] - place, to = b[axis] - place;
      // A vertex on the plane counts as above it, so that the plane cuts an edge once or not at all.
      if ((from < 0) == (to < 0)) continue;
      cuts[n++] = in_plane(a + from / (from - to) * (b - a), axis);
    }
    if (n == 2) lines.push_back({cuts[0], cuts[1]});
  }
  return lines;
}

void write_grid_picture(const Octree<3>& grid, const Surface<3>& reference, const Surface<3>& template_shape,
                        const std::string& title, const std::string& path) {
  static constexpr int size = 620;
  static constexpr std::array<const char*, 3> names = {"x", "y", "z"};
  Box<3> box;
  for (const Surface<3>* s : {&reference, &template_shape})
    for (const Vec<3>& v : s->vertices) box.add(v);
  const Vec<3> middle = (0.5 * (box.min + box.max)).cwiseMax(0.0).cwiseMin(1 - 1e-9);
  std::vector<Panel> panels;
  for (int axis = 0; axis < 3; ++axis) {
    const std::vector<RenderLines> lines = {
        {.segments = slice_grid(grid, axis, middle[axis]), .color = color_from_oklch(0.72, 0.01, 255), .width = 0.5},
        {.segments = slice_surface(reference, axis, middle[axis]),
         .color = color_from_oklch(0.55, 0.16, 45),
         .width = 1.6},
        {.segments = slice_surface(template_shape, axis, middle[axis]),
         .color = color_from_oklch(0.5, 0.14, 255),
         .width = 1.6}};
    const Frame frame{Vec<2>::Constant(-0.01), Vec<2>::Constant(1.01)};
    const auto [a, b] = axes_of_plane(axis);
    panels.push_back(
        {render_contours({}, frame, size, size, lines),
         fmt::format("{} = {:.2f}, {} to the right, {} upwards", names[axis], middle[axis], names[a], names[b]),
         {}});
  }
  write_png(compose_panels(panels, title), path);
}

}  // namespace shellmatch
