#include "matching/report/report.h"

#include "base/error.h"
#include "base/stop.h"
#include "matching/output/write_file.h"
#include "matching/report/description.h"
#include "matching/report/grid_outline.h"
#include "matching/report/packed_arrays.h"
#include "matching/report/page.h"
#include "matching/report/report_page.h"
#include "matching/report/surface_figures.h"

#include <utility>

namespace shellmatch {

namespace {

constexpr std::size_t most_grid_corners = 60000;

// A point of the unit domain in the coordinates of the template, where all three shapes are shown.
template <int Dim>
Vec<Dim> shown(const MapFrame<Dim>& frame, const Vec<Dim>& x) {
  return frame.from_reference_pose(frame.placement.inverse(x));
}

template <int Dim>
std::vector<Vec<Dim>> shown(const MapFrame<Dim>& frame, std::vector<Vec<Dim>> points) {
  for (Vec<Dim>& x : points) x = shown(frame, x);
  return points;
}

template <int Dim>
void add_surface(PackedArrays& arrays, const std::string& name, const Surface<Dim>& surface,
                 const MapFrame<Dim>& frame) {
  arrays.add_points<Dim>(name, shown(frame, surface.vertices));
  std::vector<Index> corners;
  corners.reserve(Dim * surface.facets.size());
  for (const auto& facet : surface.facets) corners.insert(corners.end(), facet.begin(), facet.end());
  arrays.add_indices(name + ".facets", Dim, corners);
}

void add_history(PackedArrays& arrays, const History& history) {
  const auto column = [&](const std::string& name, auto&& value) {
    std::vector<double> values;
    for (const HistoryRow& row : history.rows) values.push_back(static_cast<double>(value(row)));
    arrays.add_numbers("history." + name, values);
  };
  column("level", [](const HistoryRow& r) { return r.level; });
  column("substep", [](const HistoryRow& r) { return r.substep; });
  column("energy", [](const HistoryRow& r) { return r.record.value; });
  column("seconds", [](const HistoryRow& r) { return r.record.seconds; });
  for (std::size_t t = 0; t < history.term_names.size(); ++t)
    column(history.term_names[t], [t](const HistoryRow& r) { return r.record.terms[t]; });
}

template <int Dim>
ReportFrame add_grid(PackedArrays& arrays, const Deformation<Dim>& map) {
  const GridOutline<Dim> outline = grid_outline(map.grid, most_grid_corners);
  arrays.add_bytes("grid.levels", outline.levels);
  std::vector<Vec<Dim>> images;
  images.reserve(outline.corners.size());
  for (const Index node : outline.corners) images.push_back(shown<Dim>(map, map.phi[static_cast<std::size_t>(node)]));
  arrays.add_points<Dim>("grid.images", images);
  ReportFrame frame;
  frame.grid_level = outline.finest_level;
  frame.is_backward = map.is_backward;
  frame.domain_side = unit_of_template<Dim>(map);
  for (int k = -1; k < Dim; ++k) {
    const Vec<Dim> image = shown<Dim>(map, k < 0 ? Vec<Dim>(Vec<Dim>::Zero()) : Vec<Dim>(Vec<Dim>::Unit(k)));
    frame.domain.push_back({});
    for (int i = 0; i < Dim; ++i) frame.domain.back()[static_cast<std::size_t>(i)] = image[i];
  }
  return frame;
}

// A view of the template and the result.
PageView first_view(const MatchedSurfaces<3>& surfaces, const MapFrame<3>& frame) {
  Surface<3> deformed = surfaces.deformed, template_shape = surfaces.template_shape;
  for (Surface<3>* s : {&deformed, &template_shape}) s->vertices = shown(frame, std::move(s->vertices));
  const Surface<3>* both[] = {&deformed, &template_shape};
  return page_view(both);
}

}  // namespace

template <int Dim>
std::string report_html(const MatchResult<Dim>& result, const ExperimentOptions& options, std::string_view picture) {
  Activity making("writing the page", 5);
  making.next();
  const MapFrame<Dim>& map_frame = result.map;
  PackedArrays arrays;
  add_surface(arrays, "reference", result.surfaces.reference, map_frame);
  add_surface(arrays, "template", result.surfaces.template_shape, map_frame);
  arrays.add_points<Dim>("deformed", shown(map_frame, result.surfaces.deformed.vertices));
  for (const LevelVertices<Dim>& level : result.levels)
    arrays.add_points<Dim>(fmt::format("deformed.{}", level.level), shown(map_frame, level.vertices));
  making.next(2);
  const SurfaceFigures figures = surface_figures(result);
  arrays.add_numbers("distance_to_template", figures.distance_to_template);
  arrays.add_numbers("measure_ratio", figures.measure_ratio);
  if (!figures.angle_change.empty()) arrays.add_numbers("angle_change", figures.angle_change);
  arrays.add_numbers("curvature_change", figures.curvature_change);
  arrays.add_numbers("distance_to_deformed", figures.distance_to_deformed);
  making.next();
  add_history(arrays, result.history);
  ReportFrame frame = add_grid(arrays, result.map);
  if constexpr (Dim == 3) frame.view = first_view(result.surfaces, map_frame);
  for (const LevelVertices<Dim>& level : result.levels) frame.levels.push_back(level.level);
  frame.term_names = result.history.term_names;
  frame.picture = base64(picture);
  making.next();
  return filled_page(report_page, report_json(result.summary, options, frame, arrays.arrays()),
                     base64(arrays.compressed()));
}

template <int Dim>
void write_report(const MatchResult<Dim>& result, const ExperimentOptions& options, std::string_view picture,
                  const std::string& path) {
  write_file(path, report_html(result, options, picture));
}

SHELLMATCH_2D_3D(report_html);
SHELLMATCH_2D_3D(write_report);

}  // namespace shellmatch
