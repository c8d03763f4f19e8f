#include "base/error.h"
#include "base/replace_file.h"
#include "base/stop.h"
#include "geometry/io/read_ply_header.h"
#include "geometry/mesh_text/read_text.h"
#include "geometry/io/write_shape.h"
#include "geometry/surface/mesh_details.h"

#include <algorithm>
#include <bit>

namespace shellmatch {
namespace {

static_assert(std::endian::native == std::endian::little);

template <class T>
void append(std::string& bytes, T value) {
  bytes.append(reinterpret_cast<const char*>(&value), sizeof value);
}

// PLY names are single words.
std::string word_of(std::string name) {
  std::replace_if(
      name.begin(), name.end(), [](char c) { return c == ' ' || c == '\t' || c == '\n' || c == '\r'; }, '_');
  return name.empty() ? "unnamed" : name;
}

bool is_of_ply(const std::string& word) {
  const std::string_view axis = word.starts_with('n') ? std::string_view(word).substr(1) : word;
  return axis == "x" || axis == "y" || axis == "z";
}

void declare(const std::vector<DetailColumn>& columns, std::string& header) {
  for (const DetailColumn& c : columns)
    header += c.count_type.empty() ? fmt::format("property {} {}\n", c.type, c.name)
                                   : fmt::format("property list {} {} {}\n", c.count_type, c.type, c.name);
}

ValueType type_named(const std::string& name) { return ply_type(name).value_or(ValueType::float64); }

// The values of item i, in the order of the columns.
void append_item(std::string& bytes, const std::vector<DetailColumn>& columns, std::size_t i) {
  for (const DetailColumn& c : columns) {
    const bool is_list = !c.count_type.empty();
    const std::size_t begin = !is_list ? i : i == 0 ? 0 : c.ends[i - 1], end = is_list ? c.ends[i] : i + 1;
    if (is_list) append_value(bytes, type_named(c.count_type), static_cast<double>(end - begin));
    for (std::size_t k = begin; k < end; ++k) append_value(bytes, type_named(c.type), c.values[k]);
  }
}

}  // namespace

std::string space_comment(std::string_view begin, Space space) {
  return space == Space::unsaid ? "" : fmt::format("{}SPACE={}\n", begin, space_name(space));
}

std::vector<std::string> ply_names(const OriginalShape<3>& shape) {
  std::vector<std::string> names;
  for (const VertexAttribute& a : shape.attributes) {
    const std::string word = word_of(a.name);
    std::string name = word;
    for (int n = 2; is_of_ply(name) || std::ranges::find(names, name) != names.end(); ++n)
      name = fmt::format("{}_{}", word, n);
    names.push_back(name);
  }
  return names;
}

void write_ply(const std::string& path, const OriginalShape<3>& shape, Existing existing) {
  static const MeshDetails no_details;
  const MeshDetails& details = shape.details ? *shape.details : no_details;
  std::size_t n_corners = 0, longest = 0;
  for (const auto& polygon : shape.polygons) {
    n_corners += polygon.size();
    longest = std::max(longest, polygon.size());
  }
  const ValueType count_type = longest < 256 ? ValueType::uint8 : ValueType::uint32;
  std::string bytes = "ply\nformat binary_little_endian 1.0\n" + space_comment("comment ", shape.space);
  for (const std::string& comment : details.ply_comments) bytes += comment + "\n";
  bytes += fmt::format("element vertex {}\nproperty double x\nproperty double y\nproperty double z\n",
                       shape.vertices.size());
  const std::vector<std::string> names = ply_names(shape);
  std::vector<ValueType> types;
  std::vector<const VertexAttribute*> columns;
  for (std::size_t k = 0; k < names.size(); ++k) {
    const VertexAttribute& a = shape.attributes[k];
    if (a.type == "text") continue;
    SHELLMATCH_CHECK(a.values.size() == shape.vertices.size(), "an attribute has one value for each vertex");
    // PLY has no integers of 64 bits.
    types.push_back(ply_type(a.type).value_or(ValueType::float64));
    columns.push_back(&a);
    bytes += fmt::format("property {} {}\n", column_type(types.back()), names[k]);
  }
  if (!shape.polygons.empty()) {
    bytes += fmt::format("element face {}\nproperty list {} int vertex_indices\n", shape.polygons.size(),
                         column_type(count_type));
    declare(details.ply_faces, bytes);
  }
  for (const DetailTable& table : details.ply_elements) {
    bytes += fmt::format("element {} {}\n", table.name, table.n_items);
    declare(table.columns, bytes);
  }
  bytes += "end_header\n";
  bytes.reserve(bytes.size() + shape.vertices.size() * 8 * (3 + types.size()) +
                4 * (n_corners + shape.polygons.size()));
  StopCheck stop_check;
  for (std::size_t v = 0; v < shape.vertices.size(); ++v) {
    stop_check();
    for (int k = 0; k < 3; ++k) append(bytes, shape.vertices[v][k]);
    for (std::size_t a = 0; a < types.size(); ++a) append_value(bytes, types[a], columns[a]->values[v]);
  }
  for (std::size_t f = 0; f < shape.polygons.size(); ++f) {
    stop_check();
    append_value(bytes, count_type, static_cast<double>(shape.polygons[f].size()));
    for (const Index v : shape.polygons[f]) append(bytes, static_cast<std::int32_t>(v));
    append_item(bytes, details.ply_faces, f);
  }
  for (const DetailTable& table : details.ply_elements)
    for (std::size_t i = 0; i < table.n_items; ++i) append_item(bytes, table.columns, i);
  publish_file(path, existing, bytes);
}

}  // namespace shellmatch
