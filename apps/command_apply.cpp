// `apply`: moves a mesh, a contour or points by the deformation of a run.

#include "apps/apply_volume.h"
#include "apps/commands.h"
#include "apps/output_file.h"
#include "apps/process/interrupt.h"
#include "apps/terminal/words.h"
#include "base/error.h"
#include "base/parallel.h"
#include "base/text.h"
#include "geometry/io/read_shape.h"
#include "geometry/io/write_shape.h"
#include "geometry/label/volume_shape.h"
#include "geometry/mesh_text/read_text.h"
#include "geometry/surface/mesh_details.h"
#include "geometry/surface/surface.h"
#include "matching/map_file/deformation_file.h"
#include "matching/map_file/user_map.h"
#include "matching/pairs/point_formats.h"
#include "matching/pairs/point_frame.h"
#include "matching/pairs/slicer_points.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
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

// Checks before any work is done that points can be written there: as named points (matching/pairs/point_formats.h) or
// as a shape. \throws InputError
void check_points_output(const std::string& path, int dimension, bool force) {
  const PointFormat format = point_format(path);
  if (format == PointFormat::none) return check_output_file(path, dimension, force);
  if (dimension == 2 && is_of_slicer(format))
    throw_input_error(
        "{}: holds points of space, but this deformation is one of the plane; give a name ending in .csv, .tps or .txt",
        path);
  check_report_file(path, force);
}

// The vertices of a shape by the names of its column `name` or `label`, otherwise by their numbers from 1.
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

// Names that are more than the numbers from 1.
template <int Dim>
bool has_names(const PointSet<Dim>& set) {
  for (std::size_t i = 0; i < set.names.size(); ++i)
    if (set.names[i] != fmt::format("{}", i + 1)) return true;
  return false;
}

// Writes them in the format of the name's ending; a line says what that does not hold. Points that are not known are
// left out of formats of shapes.
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
      if (has_names(set) && !left_out(path, shape).empty())
        say_line(fmt::format("{}: without the names of points, which this format does not hold", path));
    return write_output_file(path, shape, command.force);
  }
  if (is_of_slicer(format) && space == Space::unsaid) {
    space = slicer_default_space;
    say_line(fmt::format("{}: written as {}, in which 3D Slicer takes shapes that name no frame to be", path,
                         space_name(space)));
  }
  if (!is_of_slicer(format) && has_names(set))
    say_line(fmt::format("{}: without the names of points, which this format does not hold", path));
  write_report_file(path, point_sets_text<Dim>(format, {std::move(set)}, space), command.force);
}

OriginalShape<2> read(const std::string& path, std::vector<std::string>& notes, Space, std::integral_constant<int, 2>) {
  return read_points_or_outline_2d(path, &notes);
}

OriginalShape<3> read(const std::string& path, std::vector<std::string>& notes, Space space,
                      std::integral_constant<int, 3>) {
  if (const auto volume = parse_volume_name(path)) {
    Shape<3> shape = volume_shape(*volume, path, space);
    for (const std::string& note : shape.notes) notes.push_back(path + ": " + note);
    return std::move(shape.original);
  }
  return read_points_or_mesh_3d(path, &notes);
}

template <int Dim>
void move(const Deformation<Dim>& deformation, std::vector<Vec<Dim>>& points) {
  std::size_t n_outside = 0;
  for (const Vec<Dim>& x : points) {
    const Vec<Dim> y = deformation.to_unit_domain(x);
    n_outside += (y.array() < 0).any() || (y.array() > 1).any();
  }
  if (n_outside > 0)
    fmt::print(stderr, "{} of {} points lie outside the domain; they move with its nearest point\n", n_outside,
               points.size());
  parallel_for(points.size(), [&](std::size_t v) { points[v] = deformation.apply(points[v]); });
}

template <int Dim>
void move_back(const PointMap<Dim>& map, const std::string& file, std::vector<Vec<Dim>>& points) {
  std::vector<char> is_lost(points.size());
  parallel_for(points.size(), [&](std::size_t v) {
    if (const auto x = map(points[v])) points[v] = *x;
    else is_lost[v] = 1;
  });
  const auto first = std::find(is_lost.begin(), is_lost.end(), 1);
  if (first != is_lost.end())
    throw_input_error(
        "{}: {} of {} points are the image of none, the first of them {}, counted from 0: they lie beyond what the "
        "deformed domain covers; "
        "leave them out",
        file, std::count(first, is_lost.end(), 1), points.size(), first - is_lost.begin());
}

/// Moves points, in the user's coordinates, as the command says.
template <int Dim>
void carry(const Deformation<Dim>& deformation, const ApplyCommand& command, std::vector<Vec<Dim>>& points) {
  if (command.keep_pose && deformation.pose.is_identity())
    std::fputs("no motion was taken out before this matching: --keep-pose changes nothing\n", stderr);
  if (command.keep_pose && command.inverse)
    for (Vec<Dim>& x : points) x = deformation.from_reference_pose(x);
  const PointMap<Dim> map(deformation, command.inverse ? Toward::reference : Toward::template_shape);
  if (map.is_inverse()) move_back(map, command.file, points);
  else move(deformation, points);
  if (command.keep_pose && !command.inverse)
    for (Vec<Dim>& x : points) x = deformation.to_reference_pose(x);
}

// The frame of a map whose shapes name none: that in which what is moved lies on them, or that of 3D Slicer. \pre own
// is said
Space space_of_map(const Deformation<3>& deformation, const ApplyCommand& command, const std::vector<Vec<3>>& points,
                   Space own) {
  namespace fs = std::filesystem;
  if (deformation.space != Space::unsaid) return deformation.space;
  const fs::path place = command.deformation,
                 file = (fs::is_directory(place) ? place : place.parent_path()) / "deformed.ply";
  Space found = Space::unsaid;
  if (fs::exists(file)) {
    const PointMap<3> map(deformation, Toward::template_shape);
    // Where a point of either shape is on the template.
    found = frame_of_points(read_triangles(file.string()), points, own, [&](const Vec<3>& x) -> std::optional<Vec<3>> {
      if (command.inverse) return command.keep_pose ? deformation.from_reference_pose(x) : x;
      const Vec<3> y = deformation.to_unit_domain(x);
      return (y.array() < 0).any() || (y.array() > 1).any() ? std::nullopt : map(x);
    });
  }
  const bool is_told = found != Space::unsaid;
  if (!is_told) found = slicer_default_space;
  say_line(fmt::format("{}: names no frame; taken to be {}, {}", command.deformation, space_name(found),
                       is_told ? fmt::format("in which {} lies on its shapes", command.file) : "as 3D Slicer does"));
  return found;
}

template <int Dim>
void apply(const ApplyCommand& command) {
  const Deformation<Dim> deformation = read_deformation<Dim>(command.deformation);
  std::vector<std::string> notes;
  OriginalShape<Dim> shape =
      read(command.file, notes, or_default(deformation.space), std::integral_constant<int, Dim>());
  for (const std::string& note : notes) say_line(note);
  if constexpr (Dim == 3) {
    const Space own = shape.space,
                common = own == Space::unsaid ? own : space_of_map(deformation, command, shape.vertices, own);
    if (change_space(shape.vertices, own, common))
      say_line(fmt::format("{}: from {} to {}, the frame of the map, and back: x and y change their sign", command.file,
                           space_name(own), space_name(common)));
    carry(deformation, command, shape.vertices);
    change_space(shape.vertices, common, own);
  } else {
    carry(deformation, command, shape.vertices);
  }
  if (point_format(command.output) != PointFormat::none) {
    return write_points(command, named_vertices(shape), shape.space == Space::unsaid ? deformation.space : shape.space);
  }
  if constexpr (Dim == 3) say_what_is_left_out(command.output, shape);
  write_output_file(command.output, shape, command.force);
}

// Control points go out as they came in, in their own frame; in other formats those of other programs than Slicer are
// in that of the map.
void apply_to_slicer_points(const ApplyCommand& command) {
  const Deformation<3> deformation = read_deformation<3>(command.deformation);
  const SlicerPoints file = read_slicer_points(command.file);
  const Space space =
      space_of_map(deformation, command, positions_in(slicer_default_space, file), slicer_default_space);
  const PointFormat format = point_format(command.output);
  const bool is_same = format == point_format(command.file),
             keeps_frame = is_same || format == PointFormat::fcsv || format == PointFormat::markups;
  if (const std::string note = space_note(file, space); !note.empty())
    say_line(note + (keeps_frame ? "; they are written in their own frame" : ""));
  std::vector<Vec<3>> points;
  for (const SlicerPoint& p : file.points)
    if (p.has_position) points.push_back(in_space(p.position, p.space, space));
  if (points.size() < file.points.size())
    say_line(fmt::format("{}: {} without position not moved", command.file,
                         counted(file.points.size() - points.size(), "point", "points")));
  carry(deformation, command, points);
  if (!is_same) {
    const Space out = keeps_frame ? file.points.front().space : space;
    PointSet<3> set;
    std::size_t next = 0;
    for (const SlicerPoint& p : file.points) {
      set.names.push_back(p.name);
      set.points.push_back(p.has_position ? std::optional(in_space(points[next++], space, out)) : std::nullopt);
    }
    return write_points(command, std::move(set), out);
  }
  std::vector<Vec<3>> positions;
  for (std::size_t i = 0, next = 0; i < file.points.size(); ++i) {
    const SlicerPoint& p = file.points[i];
    positions.push_back(p.has_position ? in_space(points[next++], space, p.space) : p.position);
  }
  write_report_file(command.output, with_positions(file, positions), command.force);
}

}  // namespace

void execute(const ApplyCommand& command) {
  catch_interrupts();
  if (is_about_volumes(command)) return apply_to_volumes(command);
  if (!command.like.empty() || !command.sampling.empty())
    throw_input_error(
        "apply: --like and --sampling are for volumes: give a volume, as {}, to move, and one to write (-o)",
        volume_endings);
  const int dimension = deformation_dimension(command.deformation);
  if (is_slicer_file(command.file)) {
    if (dimension == 2)
      throw_input_error("{}: holds points of space, but this deformation is one of the plane", command.file);
    check_points_output(command.output, dimension, command.force);
    return apply_to_slicer_points(command);
  }
  check_points_output(command.output, dimension, command.force);
  if (dimension == 2) apply<2>(command);
  else apply<3>(command);
}

}  // namespace shellmatch
