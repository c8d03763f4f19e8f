#include "matching/pictures/result_picture.h"

#include "base/error.h"
#include "geometry/distance/surface_distance.h"
#include "geometry/io/read_shape.h"
#include "geometry/repair/repair_steps.h"
#include "matching/experiment/yaml_options.h"
#include "matching/input/shape_source.h"
#include "matching/map_file/deformation_file.h"
#include "matching/output/summary.h"
#include "matching/render/canvas/contours.h"
#include "matching/render/canvas/panel.h"
#include "matching/render/surfaces/surfaces.h"

#include <Eigen/Geometry>
#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <limits>
#include <numbers>
#include <utility>
#include <variant>

namespace shellmatch {

namespace {

Surface<3> surface_of(const OriginalShape<3>& shape) { return {shape.vertices, triangulate(shape)}; }
Surface<2> surface_of(const OriginalShape<2>& shape) {
  Surface<2> curve{shape.vertices, {}};
  for (const auto& ring : shape.polygons)
    for (std::size_t k = 0; k < ring.size(); ++k) curve.facets.push_back({ring[k], ring[(k + 1) % ring.size()]});
  return curve;
}

template <int Dim>
OriginalShape<Dim> read_written(const std::filesystem::path& folder, const std::string& name) {
  if constexpr (Dim == 3) return read_points_or_mesh_3d((folder / (name + ".ply")).string());
  else return read_points_or_outline_2d((folder / (name + ".csv")).string());
}

template <int Dim>
std::vector<double> values_of(const OriginalShape<Dim>& shape, const std::string& name) {
  const auto found = std::ranges::find(shape.attributes, name, &VertexAttribute::name);
  return found == shape.attributes.end() ? std::vector<double>() : found->values;
}

// Of some vertices; files of results have single precision. In space up to a third may have been laid on their own
// limbs (matching/result/own_limb.h), which are near.
template <int Dim>
bool goes_to(const Deformation<Dim>& map, const std::vector<Vec<Dim>>& from, const OriginalShape<Dim>& to) {
  const PointMap<Dim> moved(map, Toward::template_shape);
  const double exact = 1e-4 * bounding_box(to.vertices).diagonal(),
               near = Dim == 2 ? exact : 0.1 * std::sqrt(surface_measure(surface_of(to)));
  std::size_t n = 0, n_exact = 0;
  for (std::size_t v = 0; v < from.size(); v += 1 + from.size() / 100) {
    const std::optional<Vec<Dim>> y = moved(from[v]);
    if (!y) continue;
    const double distance = (*y - to.vertices[v]).norm();
    if (!(distance <= near)) return false;
    ++n;
    n_exact += distance <= exact;
  }
  return 2 * n_exact >= n;
}

// Where the other shape has no data nothing is measured.
void leave_out(std::vector<double>& distances, const std::vector<double>& is_observed) {
  for (std::size_t v = 0; v < std::min(distances.size(), is_observed.size()); ++v)
    if (is_observed[v] == 0) distances[v] = std::numeric_limits<double>::quiet_NaN();
}

}  // namespace

template <int Dim>
ResultShapes<Dim> read_result_shapes(const std::string& folder) {
  const std::filesystem::path place = folder;
  const ExperimentOptions options = read_experiment((place / "config.yaml").string());
  const OriginalShape<Dim> deformed = read_written<Dim>(place, "deformed"),
                           template_shape = read_written<Dim>(place, "template");
  const Deformation<Dim> map = read_deformation<Dim>(folder);
  if (options.input.reference.empty())
    throw_input_error(
        "{}: its config.yaml names no reference, as it was an array in Python; report.html shows the result", folder);
  AnyShape read =
      open_shape(options.input.reference, options.input.close, map.space == Space::unsaid ? default_space : map.space);
  auto* reference = std::get_if<Shape<Dim>>(&read);
  if (reference == nullptr || reference->original.vertices.size() != deformed.vertices.size())
    throw_input_error("{}: is no longer the reference of {}, which has {} vertices", options.input.reference, folder,
                      deformed.vertices.size());
  ResultShapes<Dim> shapes{.reference = surface_of(deformed),
                           .deformed = surface_of(deformed),
                           .template_shape = surface_of(template_shape),
                           .distance_to_template = values_of(deformed, "distance_to_template"),
                           .measure_ratio = values_of(deformed, Dim == 3 ? "area_ratio" : "length_ratio"),
                           .distance_to_deformed = values_of(template_shape, "distance_to_deformed"),
                           .unit = read_summary((place / "summary.json").string()).unit.value_or("")};
  // The run has brought it into the frame of the template.
  if constexpr (Dim == 3) {
    OriginalShape<3>& shape = reference->original;
    change_space(shape.vertices, shape.space, map.space);
    // Points may have told that the frame is the other one.
    if (shape.space == Space::unsaid && map.space != Space::unsaid && !goes_to(map, shape.vertices, deformed))
      change_space(shape.vertices, Space::ras, Space::lps);
  }
  for (std::vector<double>* values : {&shapes.distance_to_template, &shapes.measure_ratio})
    leave_out(*values, values_of(deformed, "template_observed"));
  leave_out(shapes.distance_to_deformed, values_of(template_shape, "deformed_observed"));
  if (!goes_to(map, reference->original.vertices, deformed))
    throw_input_error("{}: has changed since {} was made: its vertices do not go to those of the deformed reference",
                      options.input.reference, folder);
  for (std::size_t v = 0; v < deformed.vertices.size(); ++v)
    shapes.reference.vertices[v] = map.from_reference_pose(reference->original.vertices[v]);
  return shapes;
}

SHELLMATCH_2D_3D(read_result_shapes);

namespace {

const Color color_of_template = color_from_oklch(0.66, 0.10, 255), color_of_result = color_from_oklch(0.74, 0.13, 55);

// What is drawn into a panel: a shape, where its pattern comes from, and the values that colour it.
template <int Dim>
struct Drawn {
  Surface<Dim> surface;
  const std::vector<Vec<Dim>>* origins = nullptr;  // null: no pattern
  std::vector<double> values;                      // empty: a colour
  Color color;
  std::string caption;
};

std::optional<ColorBar> bar_of(const ResultView& view, const std::string& unit, int dimension,
                               const std::vector<double>& all) {
  std::vector<double> sizes;
  for (const double v : all)
    if (std::isfinite(v)) sizes.push_back(std::abs(v));
  if (sizes.empty()) return std::nullopt;
  const double end = std::max(quantile(sizes, 0.98), 1e-12);
  if (view.colors == ShownColors::distance)
    return ColorBar{ColorMap::sequential, 0, end,
                    fmt::format("distance ({})", unit.empty() ? "unit of the files" : unit)};
  return ColorBar{ColorMap::diverging, -end, end,
                  dimension == 3 ? "log2 of the area ratio" : "log2 of the length ratio"};
}

Camera camera_for(const ResultShapes<3>& shapes, const ResultView& view) {
  const Surface<3>* all[] = {&shapes.reference, &shapes.deformed, &shapes.template_shape};
  Camera camera = fit_camera(all, 1, {.azimuth = view.azimuth, .elevation = view.elevation});
  if (!view.turns) return camera;
  double reach = 0;
  for (const Surface<3>* s : all)
    for (const Vec<3>& v : s->vertices) reach = std::max(reach, (v - camera.target).norm());
  const double wider = std::max(1.0, 1.15 * reach / camera.half_height);
  camera.half_height *= wider;
  camera.distance *= wider;
  const Eigen::AngleAxisd turn(view.turn * std::numbers::pi / 180, camera.up);
  camera.right = turn * camera.right;
  camera.backward = turn * camera.backward;
  return camera;
}

Image draw_shapes(const ResultShapes<3>& shapes, const std::vector<const Drawn<3>*>& drawn, const ResultView& view,
                  const std::optional<ColorBar>& bar) {
  std::vector<RenderSurface> surfaces;
  for (const Drawn<3>* d : drawn) {
    RenderSurface s{.surface = &d->surface, .color = d->color};
    if (d->origins != nullptr) {
      s.paint = Paint::checker;
      s.origins = *d->origins;
    }
    if (!d->values.empty() && bar)
      s.paint = Paint::scalar, s.scalars = d->values, s.color_map = bar->map, s.scalar_min = bar->min,
      s.scalar_max = bar->max;
    if (d != drawn.front()) s.opacity = 0.4;
    surfaces.push_back(std::move(s));
  }
  return render_surfaces(surfaces, camera_for(shapes, view), {.width = view.size, .height = view.size, .samples = 3});
}

Image draw_shapes(const ResultShapes<2>& shapes, const std::vector<const Drawn<2>*>& drawn, const ResultView& view,
                  const std::optional<ColorBar>& bar) {
  const Surface<2>* all[] = {&shapes.reference, &shapes.deformed, &shapes.template_shape};
  std::vector<RenderContour> contours;
  for (const Drawn<2>* d : drawn) {
    RenderContour c{.contour = &d->surface, .line = d->color, .line_width = view.size / 200.0};
    if (d->origins != nullptr) c.vertex_colors = position_colors(*d->origins, bounding_box(*d->origins));
    if (!d->values.empty() && bar)
      for (const double v : d->values)
        c.vertex_colors.push_back(map_color(bar->map, (v - bar->min) / (bar->max - bar->min)));
    if (d != drawn.front()) {
      c.fill = d->color;
      c.fill_alpha = 0.35;
    }
    if (drawn.size() > 1 && d == drawn.front()) c.line_width /= 2;  // over the other one's line
    contours.insert(contours.begin(), std::move(c));
  }
  return render_contours(contours, fit_frame(all), view.size, view.size);
}

}  // namespace

template <int Dim>
Canvas draw_result(const ResultShapes<Dim>& shapes, const ResultView& view, CanvasKind kind) {
  const bool by_values = view.colors == ShownColors::distance || view.colors == ShownColors::distortion;
  std::vector<double> values, template_values;
  if (view.colors == ShownColors::distance) {
    values = shapes.distance_to_template;
    template_values = shapes.distance_to_deformed;
  }
  if (view.colors == ShownColors::distortion)
    for (const double ratio : shapes.measure_ratio) values.push_back(std::log2(ratio));
  const auto* pattern = view.colors == ShownColors::checker ? &shapes.reference.vertices : nullptr;
  Drawn<Dim> reference{shapes.reference, pattern, {}, color_of_result, "reference"};
  Drawn<Dim> result{shapes.deformed, pattern, values, color_of_result,
                    view.time == 1 ? "deformed reference" : fmt::format("deformed reference, t = {:.2f}", view.time)};
  Drawn<Dim> template_shape{shapes.template_shape, nullptr, template_values, color_of_template, "template"};
  for (std::size_t v = 0; v < result.surface.vertices.size(); ++v)
    result.surface.vertices[v] =
        (1 - view.time) * shapes.reference.vertices[v] + view.time * shapes.deformed.vertices[v];

  std::vector<double> all = values;
  all.insert(all.end(), template_values.begin(), template_values.end());
  const std::optional<ColorBar> bar = by_values ? bar_of(view, shapes.unit, Dim, all) : std::nullopt;
  std::vector<Panel> panels;
  const auto add = [&](const std::vector<const Drawn<Dim>*>& drawn, const std::string& caption) {
    const bool has_scale = bar && std::ranges::any_of(drawn, [](const auto* d) { return !d->values.empty(); });
    panels.push_back({draw_shapes(shapes, drawn, view, bar), caption, has_scale ? bar : std::nullopt});
  };
  const bool is_all = view.show == ShownShapes::all;
  if (is_all || view.show == ShownShapes::reference) add({&reference}, reference.caption);
  if (is_all || view.show == ShownShapes::template_shape) add({&template_shape}, template_shape.caption);
  if (is_all || view.show == ShownShapes::result) add({&result}, result.caption);
  if (view.show == ShownShapes::overlay) {
    template_shape.values.clear();
    add({&result, &template_shape}, result.caption + ", template (blue)");
  }
  return draw_panels(panels, "", 0, kind);
}

SHELLMATCH_2D_3D(draw_result);

}  // namespace shellmatch
