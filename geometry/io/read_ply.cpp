// Polygon file format (Stanford): text and both binary forms, with every scalar vertex property.
// http://paulbourke.net/dataformats/ply/
#include "geometry/mesh_text/read_mesh_formats.h"
#include "geometry/io/read_ply_header.h"
#include "geometry/surface/mesh_details.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>

namespace shellmatch {
namespace {

// Reads the values of the body one by one, in text or binary form.
class PlyBody {
 public:
  PlyBody(const PlyHeader& header, LineReader& lines) : form_(header.form), lines_(lines), bytes_(lines.rest()) {}

  void begin_item(const PlyElement& element, std::size_t item) {
    element_ = &element;
    item_ = item;
    stop_check_();
    if (form_ != PlyForm::text) return;
    if (!lines_.next()) ends_early();
    rest_ = lines_.line();
  }

  double value(ValueType type) {
    if (form_ == PlyForm::text) return lines_.number_of(rest_, "a value of the " + element_->name);
    const std::size_t n = bytes_of(type);
    if (bytes_.size() < n) ends_early();
    const double number = value_of(bytes_.data(), type, form_ == PlyForm::big_endian);
    bytes_.remove_prefix(n);
    return number;
  }

  // A count or an index: an integer in range.
  std::int64_t integer(ValueType type, const char* what) {
    const double v = value(type);
    if (!(std::abs(v) < 1e15) || v != std::floor(v))
      throw_input_error("{}: {} is {}, which is not a whole number", place().text(), what, v);
    return static_cast<std::int64_t>(v);
  }

  std::int64_t list_length(const PlyProperty& property) {
    const std::int64_t n = integer(property.count_type, "the length of a list");
    if (n < 0) throw_input_error("{}: the length of a list is negative ({})", place().text(), n);
    return n;
  }

  // An item in text form is one line. More values than declared indicate a wrong header.
  void end_item() {
    if (form_ == PlyForm::text && rest_.find_first_not_of(" \t") != rest_.npos)
      lines_.fail("more values than the header declares for a {}", element_->name);
  }

  FilePosition place() const {
    if (form_ == PlyForm::text) return {lines_.path(), "line", lines_.number()};
    return {lines_.path(), element_->name, item_};
  }

  const std::string& path() const { return lines_.path(); }

  // Handles data after the last element.
  void end(const PlyHeader& header, std::vector<std::string>& notes) {
    if (form_ != PlyForm::text && !bytes_.empty())
      notes.push_back(counted(bytes_.size(), "byte", "bytes") + " after the last element ignored");
    if (form_ == PlyForm::text && lines_.next())
      lines_.fail("the header declares {}, but the file goes on; correct the header", describe_counts(header));
  }

 private:
  [[noreturn]] void ends_early() const {
    throw_input_error("{}: cut off: the header declares {} elements of kind '{}', the file ends in number {}",
                      lines_.path(), element_->n_items, element_->name, item_ + 1);
  }

  PlyForm form_;
  LineReader& lines_;
  std::string_view bytes_, rest_;
  const PlyElement* element_ = nullptr;
  std::size_t item_ = 0;
  StopCheck stop_check_;
};

void read_vertices(const PlyElement& element, PlyBody& body, MeshFile& mesh) {
  // Use of each property: a coordinate, a column of an attribute, or none.
  enum class Use { x, y, z, keep, drop };
  std::vector<Use> uses;
  std::vector<VertexAttribute> attributes;
  std::vector<std::string> lists;
  std::array<int, 3> n_of_axis{};
  bool normals = false;
  for (const PlyProperty& p : element.properties) {
    Use use = Use::keep;
    if (p.is_list) {
      lists.push_back(p.name);
      use = Use::drop;
    } else if (p.name == "x" || p.name == "y" || p.name == "z") {
      use = p.name == "x" ? Use::x : p.name == "y" ? Use::y : Use::z;
      ++n_of_axis[static_cast<std::size_t>(use)];
    } else if (p.name == "nx" || p.name == "ny" || p.name == "nz") {
      normals = true;
      use = Use::drop;
    }
    if (use == Use::keep) attributes.push_back({p.name, std::string(column_type(p.type)), {}});
    uses.push_back(use);
  }
  if (n_of_axis != std::array{1, 1, 1})
    throw_input_error("{}: the vertices need the properties x, y and z, each once", body.path());
  for (std::size_t i = 0; i < element.n_items; ++i) {
    body.begin_item(element, i);
    Vec<3> x = Vec<3>::Zero();
    std::size_t column = 0;
    for (std::size_t k = 0; k < uses.size(); ++k) {
      const PlyProperty& p = element.properties[k];
      for (std::int64_t n = p.is_list ? body.list_length(p) : 1; n > 0; --n) {
        const double v = body.value(p.type);
        if (uses[k] == Use::keep) attributes[column++].values.push_back(v);
        if (uses[k] <= Use::z) x[static_cast<int>(uses[k])] = v;
      }
    }
    body.end_item();
    add_vertex(body.place(), x, mesh.shape);
  }
  mesh.shape.attributes = std::move(attributes);
  if (normals) mesh.notes.push_back("vertex normals dropped: they would be wrong after a deformation");
  for (const std::string& name : lists) mesh.notes.push_back("vertex lists '" + name + "' dropped");
}

DetailColumn column_of(const PlyProperty& p) {
  return {p.name, std::string(column_type(p.type)), p.is_list ? std::string(column_type(p.count_type)) : std::string()};
}

// Reads the values of a property of one item.
void read_values(const PlyProperty& p, PlyBody& body, DetailColumn& column) {
  for (std::int64_t n = p.is_list ? body.list_length(p) : 1; n > 0; --n) column.values.push_back(body.value(p.type));
  if (p.is_list) column.ends.push_back(column.values.size());
}

// Takes the last item away.
void drop_last(DetailColumn& column) {
  if (column.count_type.empty()) {
    column.values.pop_back();
    return;
  }
  column.ends.pop_back();
  column.values.resize(column.ends.empty() ? 0 : column.ends.back());
}

void read_faces(const PlyElement& element, std::size_t n_vertices, PlyBody& body, MeshFile& mesh,
                std::vector<DetailColumn>& columns) {
  const auto is_corners = [](const PlyProperty& p) {
    return p.is_list && (p.name == "vertex_indices" || p.name == "vertex_index");
  };
  if (element.n_items > 0 && std::none_of(element.properties.begin(), element.properties.end(), is_corners))
    throw_input_error("{}: the faces need the property vertex_indices", body.path());
  for (const PlyProperty& p : element.properties)
    if (!is_corners(p)) columns.push_back(column_of(p));
  std::size_t n_ignored = 0;
  for (std::size_t f = 0; f < element.n_items; ++f) {
    body.begin_item(element, f);
    std::vector<Index> polygon;
    std::size_t column = 0;
    for (const PlyProperty& p : element.properties) {
      if (!is_corners(p)) {
        read_values(p, body, columns[column++]);
        continue;
      }
      for (std::int64_t n = body.list_length(p); n > 0; --n)
        add_corner(body.place(), body.integer(p.type, "a corner of a face"), n_vertices, polygon);
    }
    body.end_item();
    const std::size_t n_before = mesh.shape.polygons.size();
    add_polygon(std::move(polygon), mesh.shape, n_ignored);
    if (mesh.shape.polygons.size() == n_before) std::for_each(columns.begin(), columns.end(), drop_last);
  }
  note_ignored_polygons(n_ignored, mesh.notes);
}

DetailTable read_element(const PlyElement& element, PlyBody& body) {
  DetailTable table{element.name, element.n_items};
  for (const PlyProperty& p : element.properties) table.columns.push_back(column_of(p));
  for (std::size_t i = 0; i < element.n_items && !element.properties.empty(); ++i) {
    body.begin_item(element, i);
    for (std::size_t k = 0; k < element.properties.size(); ++k)
      read_values(element.properties[k], body, table.columns[k]);
    body.end_item();
  }
  return table;
}

}  // namespace

MeshFile read_ply(const std::string& path, std::string_view bytes) {
  MeshFile mesh;
  LineReader lines(path, bytes, '\0');
  const PlyHeader header = read_ply_header(lines);
  PlyBody body(header, lines);
  auto details = std::make_shared<MeshDetails>();
  std::size_t n_vertices = 0;
  for (const PlyElement& element : header.elements)
    if (element.name == "vertex") n_vertices = element.n_items;
  for (const PlyElement& element : header.elements) {
    if (element.name == "vertex") {
      read_vertices(element, body, mesh);
    } else if (element.name == "face") {
      read_faces(element, n_vertices, body, mesh, details->ply_faces);
    } else if (element.name == "tristrips") {
      throw_input_error("{}: triangle strips are not supported; save the mesh with faces", path);
    } else {
      details->ply_elements.push_back(read_element(element, body));
    }
  }
  body.end(header, mesh.notes);
  details->ply_comments = header.comments;
  mesh.shape.details = std::move(details);
  return mesh;
}

}  // namespace shellmatch
