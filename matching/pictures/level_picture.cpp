#include "matching/pictures/level_picture.h"

#include "base/error.h"
#include "base/stop.h"
#include "matching/render/canvas/contours.h"
#include "matching/render/canvas/panel.h"
#include "matching/render/surfaces/surfaces.h"

#include <algorithm>
#include <cmath>

namespace shellmatch {

namespace {

const Color template_color = color_from_oklch(0.66, 0.10, 255), deformed_color = color_from_oklch(0.74, 0.13, 55);

// A quantile of the values, as an upper end of a colour bar that a few outliers do not determine.
double quantile(std::vector<double> values, double share) {
  std::erase_if(values, [](double v) { return !std::isfinite(v); });
  if (values.empty()) return 0;
  const auto k = static_cast<std::ptrdiff_t>(share * static_cast<double>(values.size() - 1));
  std::nth_element(values.begin(), values.begin() + k, values.end());
  return values[static_cast<std::size_t>(k)];
}

// A panel that colours the vertices by a scalar, in either dimension.
struct ScalarPanel {
  std::string caption;
  std::vector<double> values;
  ColorBar bar;
};

template <int Dim>
std::vector<ScalarPanel> scalar_panels(const LevelPicture<Dim>& picture) {
  std::vector<ScalarPanel> panels;
  if (!picture.distance.empty()) {
    double top = picture.distance_max > 0 ? picture.distance_max : quantile(picture.distance, 0.98);
    if (!(top > 0)) top = 1e-12;
    panels.push_back({"deviation", picture.distance, {ColorMap::sequential, 0, top, picture.distance_label}});
  }
  if (!picture.area_ratio.empty()) {
    std::vector<double> logs(picture.area_ratio.size()), sizes(logs.size());
    for (std::size_t i = 0; i < logs.size(); ++i) {
      logs[i] = std::log2(picture.area_ratio[i]);
      sizes[i] = std::abs(logs[i]);
    }
    const double end = std::max(0.05, quantile(sizes, 0.98));
    panels.push_back(
        {"area distortion",
         std::move(logs),
         {ColorMap::diverging, -end, end, Dim == 2 ? "log2 of the length ratio" : "log2 of the area ratio"}});
  }
  return panels;
}

std::vector<Panel> draw_panels(const LevelPicture<3>& picture) {
  const int size = picture.panel_size > 0 ? picture.panel_size : 440;
  // All levels are seen from one place; what is between the two lies within the wider margin.
  const Surface<3>* both[] = {picture.reference, picture.template_shape};
  const Camera camera = fit_camera(both, 1, {.margin = 0.08});
  const RenderOptions options{
      .width = size, .height = size, .samples = picture.draft ? 2 : 3, .ambient_occlusion = !picture.draft};
  Activity drawing("drawing", 9);
  const auto draw = [&](std::vector<RenderSurface> surfaces) {
    drawing.next();
    return render_surfaces(surfaces, camera, options);
  };

  RenderSurface reference{.surface = picture.reference, .paint = Paint::checker};
  RenderSurface deformed{.surface = picture.deformed, .paint = Paint::checker, .origins = picture.reference->vertices};
  RenderSurface template_shape{.surface = picture.template_shape};
  if (options.ambient_occlusion)
    for (RenderSurface* s : {&reference, &deformed, &template_shape}) {
      drawing.next();
      s->openness = surface_openness(*s->surface);
    }
  std::vector<Panel> panels;
  panels.push_back({draw({reference}), "reference", {}});
  panels.push_back({draw({template_shape}), "template", {}});
  std::vector<std::vector<RenderSurface>> looks{{deformed}};  // of the deformed reference alone
  template_shape.color = template_color;
  template_shape.opacity = 0.4;
  deformed.paint = Paint::uniform;
  deformed.color = deformed_color;
  const Image overlay = draw({deformed, template_shape});
  deformed.paint = Paint::scalar;
  std::vector<ScalarPanel> scalars = scalar_panels(picture);
  for (ScalarPanel& scalar : scalars) {
    deformed.scalars = std::move(scalar.values);
    deformed.color_map = scalar.bar.map;
    deformed.scalar_min = scalar.bar.min;
    deformed.scalar_max = scalar.bar.max;
    looks.push_back({deformed});
  }
  const std::vector<Image> images = render_looks(looks, camera, options);
  panels.push_back({images[0], "deformed reference", {}});
  panels.push_back({overlay, "deformed reference (orange) and template (blue)", {}});
  for (std::size_t i = 0; i < scalars.size(); ++i)
    panels.push_back({images[1 + i], scalars[i].caption, scalars[i].bar});
  return panels;
}

// Edges of all leaves that are wide enough to be seen, at the positions phi of the nodes.
RenderLines grid_lines(const Octree<2>& grid, const std::vector<Vec<2>>* phi, double least_side) {
  RenderLines lines;
  static constexpr int sides[4][2] = {{0, 1}, {1, 3}, {3, 2}, {2, 0}};
  const auto position = [&](Index node) { return phi ? (*phi)[node] : grid.node_position(node); };
  for (const Index leaf : grid.leaves()) {
    const auto& cell = grid.cell(leaf);
    if (cell.side() < least_side) continue;
    for (const auto& [a, b] : sides) lines.segments.push_back({position(cell.nodes[a]), position(cell.nodes[b])});
  }
  return lines;
}

std::vector<Panel> draw_panels(const LevelPicture<2>& picture) {
  const int size = picture.panel_size > 0 ? picture.panel_size : 460;
  const Surface<2>* all[] = {picture.reference, picture.template_shape, picture.deformed};
  const Frame frame = fit_frame(all);
  const std::vector<Color> colors =
      position_colors(picture.reference->vertices, bounding_box(picture.reference->vertices));
  const auto draw = [&](std::vector<RenderContour> contours, std::vector<RenderLines> lines = {}) {
    return render_contours(contours, frame, size, size, lines);
  };

  RenderContour reference{.contour = picture.reference, .fill_alpha = 1, .line_width = 3.5, .vertex_colors = colors};
  RenderContour deformed{.contour = picture.deformed, .fill_alpha = 1, .line_width = 3.5, .vertex_colors = colors};
  RenderContour template_shape{.contour = picture.template_shape, .fill_alpha = 1, .line_width = 1.8};
  std::vector<Panel> panels;
  panels.push_back({draw({reference}), "reference", {}});
  panels.push_back({draw({template_shape}), "template", {}});
  panels.push_back({draw({deformed}), "deformed reference", {}});
  template_shape.fill_alpha = 0.35;
  template_shape.fill = template_color;
  template_shape.line = color_from_oklch(0.80, 0.09, 255);
  // A wide line below and dashes on it: where the two lie on each other, both are seen.
  template_shape.line_width = 6;
  const RenderContour dashed{
      .contour = picture.deformed, .line = color_from_oklch(0.58, 0.19, 42), .line_width = 2.2, .dashes = {8, 6}};
  panels.push_back({draw({template_shape, dashed}), "deformed reference (orange dashes) and template (blue)", {}});
  for (const ScalarPanel& scalar : scalar_panels(picture)) {
    RenderContour c{.contour = picture.deformed, .line_width = 4};
    for (const double v : scalar.values)
      c.vertex_colors.push_back(map_color(scalar.bar.map, (v - scalar.bar.min) / (scalar.bar.max - scalar.bar.min)));
    panels.push_back({draw({c}), scalar.caption, scalar.bar});
  }
  if (picture.grid) {
    Box<2> box{Vec<2>::Zero(), Vec<2>::Ones()};
    if (picture.phi)
      for (const Vec<2>& x : *picture.phi) box.add(x);
    const Frame domain{box.min.array() - 0.03, box.max.array() + 0.03};
    const double least_side = 3.0 / size;  // edges of finer cells would merge into a grey area
    const RenderContour before{.contour = picture.reference, .line_width = 1.4};
    const RenderContour after{.contour = picture.deformed, .line_width = 1.4};
    const auto draw_grid = [&](const RenderContour& c, const std::vector<Vec<2>>* phi) {
      return render_contours(std::span(&c, 1), domain, size, size,
                             std::vector{grid_lines(*picture.grid, phi, least_side)});
    };
    panels.push_back({draw_grid(before, nullptr), "grid", {}});
    if (picture.phi) panels.push_back({draw_grid(after, picture.phi), "deformed grid", {}});
  }
  return panels;
}

}  // namespace

template <int Dim>
void add_distances(LevelPicture<Dim>& picture, std::vector<double> distance, const MatchSummary& summary) {
  const double diagonal = bounding_box(picture.template_shape->vertices).diagonal();
  const double scale = summary.template_diagonal.value_or(diagonal) / diagonal;
  for (double& d : distance) d *= scale;
  const bool has_gaps = std::ranges::any_of(distance, [](double d) { return std::isnan(d); });
  picture.distance = std::move(distance);
  picture.distance_label = fmt::format("distance to template ({}){}",
                                       summary.unit.value_or("").empty() ? "unit of the files" : *summary.unit,
                                       has_gaps ? "; grey: no data" : "");
}

template <int Dim>
void write_level_picture(const LevelPicture<Dim>& picture, const std::string& path) {
  SHELLMATCH_CHECK(picture.reference && picture.template_shape && picture.deformed, "a picture needs three shapes");
  SHELLMATCH_CHECK(picture.reference->vertices.size() == picture.deformed->vertices.size(),
                   "the deformed shape has the reference's vertices");
  const std::vector<Panel> panels = draw_panels(picture);
  // More than five panels are drawn in two rows.
  const int columns = panels.size() > 5 ? static_cast<int>(panels.size() + 1) / 2 : 0;
  write_png(compose_panels(panels, picture.title, columns), path);
}

std::string level_picture_name(int level) { return fmt::format("pictures/level_{:02d}.png", level); }

SHELLMATCH_2D_3D(add_distances);
SHELLMATCH_2D_3D(write_level_picture);

}  // namespace shellmatch
