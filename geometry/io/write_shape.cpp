#include "geometry/io/write_shape.h"

#include "base/error.h"
#include "base/printable.h"
#include "base/replace_file.h"
#include "base/text.h"
#include "geometry/io/input_file.h"
#include "geometry/mesh_text/read_text.h"
#include "geometry/polydata/write_polydata.h"
#include "geometry/repair/repair_steps.h"
#include "geometry/surface/mesh_details.h"
#include "geometry/surface/pseudonormals.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <iterator>
#include <string_view>

namespace shellmatch {
namespace {

// Checks that all columns have one value for each vertex.
template <int Dim>
void check_attributes(const OriginalShape<Dim>& shape) {
  for (const VertexAttribute& attribute : shape.attributes)
    SHELLMATCH_CHECK(
        (attribute.type == "text" ? attribute.texts.size() : attribute.values.size()) == shape.vertices.size(),
        "an attribute has one value for each vertex");
}

/// A column of CSV: a coordinate or an attribute.
struct CsvColumn {
  std::string name;
  int axis = -1;
  const VertexAttribute* attribute = nullptr;
};

/// In the order of the table that was read, and then what has come since.
template <int Dim>
std::vector<CsvColumn> csv_columns(const OriginalShape<Dim>& shape) {
  std::vector<CsvColumn> columns;
  std::vector<bool> taken(shape.attributes.size(), false);
  const auto add_attribute = [&](std::size_t k) {
    columns.push_back(
        {shape.attributes[k].name.empty() ? "unnamed" : shape.attributes[k].name, -1, &shape.attributes[k]});
    taken[k] = true;
  };
  if (shape.details && shape.details->table_coordinates.size() == Dim) {
    const MeshDetails& table = *shape.details;
    for (std::size_t c = 0; c < table.table_columns.size(); ++c) {
      const auto axis = std::ranges::find(table.table_coordinates, c);
      if (axis != table.table_coordinates.end()) {
        columns.push_back({table.table_columns[c], static_cast<int>(axis - table.table_coordinates.begin())});
        continue;
      }
      for (std::size_t k = 0; k < taken.size(); ++k) {
        if (taken[k] || shape.attributes[k].name != table.table_columns[c]) continue;
        add_attribute(k);
        break;
      }
    }
  } else {
    for (int axis = 0; axis < Dim; ++axis) columns.push_back({std::string(1, "xyz"[axis]), axis});
  }
  for (std::size_t k = 0; k < taken.size(); ++k)
    if (!taken[k]) add_attribute(k);
  return columns;
}

template <int Dim>
void append_point_line(std::string& text, const OriginalShape<Dim>& shape, const std::vector<CsvColumn>& columns,
                       std::size_t v) {
  for (const CsvColumn& column : columns) {
    if (&column != columns.data()) text.push_back(',');
    if (column.axis >= 0) fmt::format_to(std::back_inserter(text), "{}", shape.vertices[v][column.axis]);
    else if (column.attribute->type == "text") text += csv_field(column.attribute->texts[v]);
    else fmt::format_to(std::back_inserter(text), "{}", column.attribute->values[v]);
  }
  text.push_back('\n');
}

template <int Dim>
void write_csv(const std::string& path, const OriginalShape<Dim>& shape, Existing existing) {
  check_attributes(shape);
  std::string text;
  const std::vector<CsvColumn> columns = csv_columns(shape);
  for (const CsvColumn& column : columns) text += (text.empty() ? "" : ",") + csv_field(column.name);
  text.push_back('\n');
  // True for the last point of each ring.
  std::vector<bool> last(shape.vertices.size(), false);
  if (Dim == 2)
    for (const std::vector<Index>& ring : shape.polygons)
      if (!ring.empty()) last[*std::max_element(ring.begin(), ring.end())] = true;
  for (std::size_t v = 0; v < shape.vertices.size(); ++v) {
    append_point_line(text, shape, columns, v);
    if (last[v] && v + 1 < shape.vertices.size()) text.push_back('\n');
  }
  publish_file(path, existing, text);
}

const VertexAttribute* attribute_named(const OriginalShape<3>& shape, std::string_view name) {
  for (const VertexAttribute& a : shape.attributes)
    if (a.name == name) return &a;
  return nullptr;
}

// The file that was read, with other coordinates.
std::string obj_as_read(const OriginalShape<3>& shape) {
  std::string text = space_comment("# ", shape.space);
  std::string_view rest = shape.details->obj_text;
  std::size_t v = 0;
  while (!rest.empty()) {
    const std::size_t end = rest.find('\n');
    std::string_view line = rest.substr(0, end);
    rest.remove_prefix(std::min(end, rest.size() - 1) + 1);
    if (line.starts_with("v") && (line.size() == 1 || line[1] == ' ' || line[1] == '\t')) {
      SHELLMATCH_CHECK(v < shape.vertices.size(), "the text of a shape has a line for each of its vertices");
      text += fmt::format("v {} {} {}", shape.vertices[v].x(), shape.vertices[v].y(), shape.vertices[v].z());
      ++v;
      line.remove_prefix(1);
    }
    text.append(line).push_back('\n');
  }
  SHELLMATCH_CHECK(v == shape.vertices.size(), "the text of a shape has a line for each of its vertices");
  return text;
}

void write_obj(const std::string& path, const OriginalShape<3>& shape, Existing existing) {
  if (shape.details && !shape.details->obj_text.empty()) return publish_file(path, existing, obj_as_read(shape));
  std::string text = space_comment("# ", shape.space);
  const VertexAttribute* const colours[] = {attribute_named(shape, "red"), attribute_named(shape, "green"),
                                            attribute_named(shape, "blue")};
  const bool coloured = colours[0] && colours[1] && colours[2];
  for (std::size_t v = 0; v < shape.vertices.size(); ++v) {
    const Vec<3>& x = shape.vertices[v];
    text += fmt::format("v {} {} {}", x.x(), x.y(), x.z());
    if (coloured)
      for (const VertexAttribute* c : colours)
        text += fmt::format(" {}", c->type == "uchar" ? c->values[v] / 255 : c->values[v]);
    text.push_back('\n');
  }
  for (const std::vector<Index>& polygon : shape.polygons) {
    text.push_back('f');
    for (const Index v : polygon) text += fmt::format(" {}", v + 1);
    text.push_back('\n');
  }
  publish_file(path, existing, text);
}

void write_off(const std::string& path, const OriginalShape<3>& shape, Existing existing) {
  std::string text =
      fmt::format("OFF\n{}{} {} 0\n", space_comment("# ", shape.space), shape.vertices.size(), shape.polygons.size());
  for (const Vec<3>& x : shape.vertices) text += fmt::format("{} {} {}\n", x.x(), x.y(), x.z());
  for (const std::vector<Index>& polygon : shape.polygons) {
    text += fmt::format("{}", polygon.size());
    for (const Index v : polygon) text += fmt::format(" {}", v);
    text.push_back('\n');
  }
  publish_file(path, existing, text);
}

void write_stl(const std::string& path, const OriginalShape<3>& shape, Existing existing) {
  if (shape.polygons.empty())
    throw_input_error("{}: points without faces cannot be written as STL; use .ply or .csv", path);
  const Triangles triangles = triangulate(shape);
  std::string bytes = space_comment("", shape.space);
  if (!bytes.empty()) bytes.back() = ' ';
  bytes.resize(80, ' ');
  const auto append = [&](const auto& value) { bytes.append(reinterpret_cast<const char*>(&value), sizeof value); };
  append(static_cast<std::uint32_t>(triangles.size()));
  for (const auto& [a, b, c] : triangles) {
    const Vec<3>&xa = shape.vertices[a], &xb = shape.vertices[b], &xc = shape.vertices[c];
    const Vec<3> normal = unit_or_zero<3>((xb - xa).cross(xc - xa));
    for (const Vec<3>& x : {normal, xa, xb, xc})
      for (int k = 0; k < 3; ++k) append(static_cast<float>(x[k]));
    append(std::uint16_t{0});
  }
  publish_file(path, existing, bytes);
}

}  // namespace

void write_outline_csv(const std::string& path, const OriginalShape<2>& shape, Existing existing) {
  write_csv(path, shape, existing);
}
void write_points_csv(const std::string& path, const OriginalShape<3>& shape, Existing existing) {
  write_csv(path, shape, existing);
}

std::vector<std::string> left_out(const std::string& path, const OriginalShape<3>& shape) {
  const std::string extension = file_extension(path);
  const bool has_columns = extension == ".ply" || extension == ".vtk" || extension == ".vtp" || extension == ".csv";
  std::vector<std::string> lost, names;
  for (const VertexAttribute& a : shape.attributes) {
    const bool is_colour = extension == ".obj" && (a.name == "red" || a.name == "green" || a.name == "blue");
    if (a.type == "text" ? extension != ".csv" : !has_columns && !is_colour) names.push_back(a.name);
  }
  if (!names.empty()) lost.push_back(fmt::format("the columns {}", fmt::join(names, ", ")));
  if (extension == ".ply") {
    const std::vector<std::string> words = ply_names(shape);
    for (std::size_t k = 0; k < words.size(); ++k)
      if (const VertexAttribute& a = shape.attributes[k]; a.type != "text" && a.name != words[k])
        lost.push_back(fmt::format("the name of the column '{}' ('{}' instead)", printable(a.name, 60), words[k]));
  }
  if (extension == ".csv" && !shape.polygons.empty()) lost.emplace_back("faces");
  if (!shape.details) return lost;
  const MeshDetails& d = *shape.details;
  const auto has_statement = [&](std::string_view word) {
    return d.obj_text.starts_with(word) || d.obj_text.find("\n" + std::string(word)) != std::string::npos;
  };
  if (extension != ".obj")
    for (const auto& [word, what] : {std::pair{"vt ", "texture coordinates"},
                                     {"g ", "groups"},
                                     {"o ", "objects"},
                                     {"usemtl ", "materials"},
                                     {"l ", "lines"}})
      if (has_statement(word)) lost.emplace_back(what);
  if (extension == ".ply") return lost;
  for (const DetailColumn& c : d.ply_faces) lost.push_back(fmt::format("the property {} of the faces", c.name));
  for (const DetailTable& t : d.ply_elements) lost.push_back(fmt::format("the elements {}", t.name));
  return lost;
}

void write_shape(const std::string& path, const OriginalShape<3>& shape, Existing existing) {
  check_attributes(shape);
  const std::string extension = file_extension(path);
  if (extension == ".ply") return write_ply(path, shape, existing);
  if (extension == ".csv") return write_points_csv(path, shape, existing);
  if (extension == ".obj") return write_obj(path, shape, existing);
  if (extension == ".off") return write_off(path, shape, existing);
  if (extension == ".stl") return write_stl(path, shape, existing);
  if (extension == ".vtk") return publish_file(path, existing, polydata_bytes(shape, PolyDataFormat::legacy));
  if (extension == ".vtp") return publish_file(path, existing, polydata_bytes(shape, PolyDataFormat::xml));
  throw_input_error("{}: shapes are written as .ply, .obj, .off, .stl, .vtk, .vtp or .csv, not as '{}'", path,
                    extension);
}

}  // namespace shellmatch
