#include "geometry/polydata/polydata.h"

#include "base/error.h"
#include "base/printable.h"
#include "base/text.h"

#include <algorithm>
#include <cmath>

namespace shellmatch {

namespace {

constexpr const char* colour_names[] = {"red", "green", "blue", "alpha"};

std::string column_name(const std::string& name, std::string_view type, std::size_t component,
                        std::size_t n_components) {
  if (n_components == 1) return name;
  const bool is_colour =
      type == "uchar" && ((name == "RGB" && n_components == 3) || (name == "RGBA" && n_components == 4));
  return is_colour ? colour_names[component] : fmt::format("{}_{}", name, component);
}

}  // namespace

void PolyData::add_points(const std::vector<double>& coordinates) {
  for (std::size_t i = 0; i + 2 < coordinates.size(); i += 3) {
    const Vec<3> x(coordinates[i], coordinates[i + 1], coordinates[i + 2]);
    if (!x.allFinite())
      throw_input_error(
          "{}: vertex {} (counted from 0) has a coordinate that is not finite ({}, {}, {}); remove the vertex or give "
          "it a position",
          path_, shape_.vertices.size(), x.x(), x.y(), x.z());
    if (shape_.vertices.size() == static_cast<std::size_t>(std::numeric_limits<Index>::max()))
      throw_input_error("{}: more than {} vertices; simplify the mesh", path_, shape_.vertices.size());
    shape_.vertices.push_back(x);
  }
}

void PolyData::add_cells(CellKind kind, const std::vector<double>& ends, const std::vector<double>& corners,
                         std::size_t first_point) {
  const double n_points = static_cast<double>(shape_.vertices.size() - first_point);
  const auto corner = [&](std::size_t at) {
    const double value = corners[at];
    if (!(value >= 0 && value < n_points) || value != std::floor(value))
      throw_input_error(
          "{}: a face names vertex {} (counted from 0), but there are {} vertices; the file is damaged or was cut off",
          path_, value, n_points);
    return static_cast<Index>(first_point + static_cast<std::size_t>(value));
  };
  std::size_t begin = 0;
  for (const double raw : ends) {
    if (!(raw >= static_cast<double>(begin) && raw <= static_cast<double>(corners.size())) || raw != std::floor(raw))
      throw_input_error("{}: a cell ends at {} of {} corners; the file is damaged or was cut off", path_, raw,
                        corners.size());
    const auto end = static_cast<std::size_t>(raw);
    std::vector<Index> cell;
    for (std::size_t k = begin; k < end; ++k) cell.push_back(corner(k));
    begin = end;
    if (kind == CellKind::vertices) ++n_vertices_;
    else if (kind == CellKind::lines) ++n_lines_;
    else if (cell.size() < 3) ++n_ignored_;
    else if (kind == CellKind::polygons) shape_.polygons.push_back(std::move(cell));
    else
      for (std::size_t k = 0; k + 2 < cell.size(); ++k)
        shape_.polygons.push_back(k % 2 == 0 ? std::vector{cell[k], cell[k + 1], cell[k + 2]}
                                             : std::vector{cell[k + 1], cell[k], cell[k + 2]});
  }
}

void PolyData::add_point_array(const std::string& name, std::string_view type, std::size_t n_components,
                               const std::vector<double>& values) {
  SHELLMATCH_CHECK(values.size() == n_components * n_points(), "an array has a tuple for each point");
  if (n_components == 3 && (name == "Normals" || name == "normals"))
    return add_dropped("vertex normals dropped: they would be wrong after a deformation");
  if (shape_.attributes.size() + n_components > max_columns)
    throw_input_error("{}: more than {} columns of point data; leave some out", path_, max_columns);
  for (std::size_t c = 0; c < n_components; ++c) {
    VertexAttribute column{column_name(name.empty() ? "unnamed" : name, type, c, n_components), std::string(type), {}};
    // Two arrays of one name would be one after writing.
    if (std::ranges::any_of(shape_.attributes, [&](const VertexAttribute& a) { return a.name == column.name; })) {
      add_dropped(fmt::format("a second array of point data '{}' dropped", printable(name)));
      return;
    }
    column.values.reserve(n_points());
    for (std::size_t i = 0; i < n_points(); ++i) column.values.push_back(values[i * n_components + c]);
    shape_.attributes.push_back(std::move(column));
  }
}

void PolyData::add_dropped(const std::string& what) {
  constexpr std::size_t most = 20;
  if (dropped_.size() < most) dropped_.push_back(what);
}

OriginalShape<3> PolyData::finish(std::vector<std::string>& notes) {
  const auto ignored = [&](std::size_t n, std::string_view singular, std::string_view plural) {
    if (n > 0) notes.push_back(counted(n, singular, plural) + " ignored");
  };
  ignored(n_vertices_, "cell of points", "cells of points");
  ignored(n_lines_, "line", "lines");
  ignored(n_ignored_, "face with fewer than three corners", "faces with fewer than three corners");
  notes.insert(notes.end(), dropped_.begin(), dropped_.end());
  return std::move(shape_);
}

}  // namespace shellmatch
