#include "apps/apply_points.h"

#include "apps/output_file.h"
#include "apps/terminal/words.h"
#include "base/error.h"
#include "base/text.h"
#include "geometry/mesh_text/read_text.h"
#include "geometry/io/write_shape.h"
#include "geometry/surface/mesh_details.h"
#include "matching/pairs/point_frame.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <memory>
#include <vector>

namespace shellmatch {

namespace {

bool is_of_slicer(PointFormat format) { return format == PointFormat::fcsv || format == PointFormat::markups; }

// As a table: names, and coordinates.
template <int Dim>
OriginalShape<Dim> table_of(const PointSet<Dim>& set, Space space) {
  OriginalShape<Dim> shape;
  shape.space = space;
  VertexAttribute names{"name", "text", {}, {}};
  for (std::size_t i = 0; i < set.points.size(); ++i) {
    if (!set.points[i]) continue;
    shape.vertices.push_back(*set.points[i]);
    names.texts.push_back(set.names[i]);
  }
  shape.attributes.push_back(std::move(names));
  auto details = std::make_shared<MeshDetails>();
  details->table_columns = {"name", "x", "y", "z"};
  for (std::size_t k = 1; k <= Dim; ++k) details->table_coordinates.push_back(k);
  details->table_columns.resize(Dim + 1);
  shape.details = std::move(details);
  return shape;
}

}  // namespace

void check_points_output(const std::string& path, int dimension, bool force) {
  const PointFormat format = point_format(path);
  if (format == PointFormat::none) return check_output_file(path, dimension, force);
  if (dimension == 2 && is_of_slicer(format))
    throw_input_error(
        "{}: holds points of space, but this deformation is one of the plane; give a name ending in .csv, .tps or .txt",
        path);
  check_report_file(path, force);
}

template <int Dim>
PointSet<Dim> named_vertices(const OriginalShape<Dim>& shape) {
  PointSet<Dim> set;
  const auto column = std::ranges::find_if(shape.attributes, [](const VertexAttribute& a) {
    return equals_ignoring_case(a.name, "name") || equals_ignoring_case(a.name, "label");
  });
  for (std::size_t i = 0; i < shape.vertices.size(); ++i) {
    set.points.push_back(shape.vertices[i]);
    if (column == shape.attributes.end()) set.names.push_back(fmt::format("{}", i + 1));
    else set.names.push_back(column->type == "text" ? column->texts[i] : fmt::format("{}", column->values[i]));
  }
  return set;
}

template <int Dim>
void write_points(const ApplyCommand& command, PointSet<Dim> set, Space space) {
  const std::string& path = command.output;
  const PointFormat format = point_format(path);
  set.individual = std::filesystem::path(path).stem().string();
  const auto n_unknown = static_cast<std::size_t>(std::ranges::count_if(set.points, [](const auto& x) { return !x; }));
  if (format == PointFormat::none) {
    if (n_unknown == set.points.size()) throw_input_error("{}: none of its points has a position", command.file);
    if (n_unknown > 0)
      say_line(fmt::format("{}: {} without position left out", path, counted(n_unknown, "point", "points")));
    const OriginalShape<Dim> shape = table_of(set, space);
    if constexpr (Dim == 3)
      if (!left_out(path, shape).empty())
        say_line(fmt::format("{}: without the names of points, which this format does not hold", path));
    return write_output_file(path, shape, command.force);
  }
  if (is_of_slicer(format) && space == Space::unsaid) {
    space = slicer_default_space;
    say_line(fmt::format("{}: written as {}, in which 3D Slicer takes shapes that name no frame to be", path,
                         space_name(space)));
  }
  if (!is_of_slicer(format))
    say_line(fmt::format("{}: without the names of points, which this format does not hold", path));
  write_report_file(path, point_sets_text<Dim>(format, {std::move(set)}, space), command.force);
}

template PointSet<2> named_vertices<2>(const OriginalShape<2>&);
template PointSet<3> named_vertices<3>(const OriginalShape<3>&);
template void write_points<2>(const ApplyCommand&, PointSet<2>, Space);
template void write_points<3>(const ApplyCommand&, PointSet<3>, Space);

}  // namespace shellmatch
