#include "matching/pictures/result_shapes.h"

#include "base/error.h"
#include "geometry/io/read_shape.h"
#include "geometry/repair/repair_steps.h"
#include "matching/experiment/yaml_options.h"
#include "matching/input/shape_source.h"
#include "matching/map_file/deformation_file.h"
#include "matching/output/summary.h"

#include <algorithm>
#include <filesystem>
#include <limits>
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

// Of some vertices; files of results have single precision.
template <int Dim>
bool goes_to(const Deformation<Dim>& map, const std::vector<Vec<Dim>>& from, const std::vector<Vec<Dim>>& to) {
  const PointMap<Dim> moved(map, Toward::template_shape);
  const double tolerance = 1e-4 * bounding_box(to).diagonal();
  for (std::size_t v = 0; v < from.size(); v += 1 + from.size() / 100)
    if (const std::optional<Vec<Dim>> y = moved(from[v]); y && !((*y - to[v]).norm() <= tolerance)) return false;
  return true;
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
    if (shape.space == Space::unsaid && map.space != Space::unsaid && !goes_to(map, shape.vertices, deformed.vertices))
      change_space(shape.vertices, Space::ras, Space::lps);
  }
  for (std::vector<double>* values : {&shapes.distance_to_template, &shapes.measure_ratio})
    leave_out(*values, values_of(deformed, "template_observed"));
  leave_out(shapes.distance_to_deformed, values_of(template_shape, "deformed_observed"));
  if (!goes_to(map, reference->original.vertices, deformed.vertices))
    throw_input_error("{}: has changed since {} was made: its vertices do not go to those of the deformed reference",
                      options.input.reference, folder);
  for (std::size_t v = 0; v < deformed.vertices.size(); ++v)
    shapes.reference.vertices[v] = map.from_reference_pose(reference->original.vertices[v]);
  return shapes;
}

template ResultShapes<2> read_result_shapes<2>(const std::string&);
template ResultShapes<3> read_result_shapes<3>(const std::string&);

}  // namespace shellmatch
