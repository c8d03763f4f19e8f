// Object file format (Geomview), text form: OFF, COFF, NOFF, STOFF and their combinations.
// http://www.geomview.org/docs/html/OFF.html
#include "geometry/mesh_text/read_mesh_formats.h"

#include <algorithm>

namespace shellmatch {
namespace {

struct Header {
  bool texture = false, colour = false, normal = false;
  std::size_t n_vertices = 0, n_faces = 0;
};

Header read_header(LineReader& lines) {
  Header header;
  if (!lines.next()) throw_input_error("{}: nothing but comments; is it an OFF file?", lines.path());
  std::string_view rest = lines.line();
  // The keyword may be missing or may be joined to the first count.
  const std::size_t off = rest.find("OFF");
  if (off != rest.npos && off <= 5) {
    const std::string_view keyword = rest.substr(0, off + 3);
    rest.remove_prefix(keyword.size());
    std::string_view prefix = keyword.substr(0, off);
    const auto has = [&](std::string_view letters) {
      const bool found = prefix.starts_with(letters);
      if (found) prefix.remove_prefix(letters.size());
      return found;
    };
    header.texture = has("ST");
    header.colour = has("C");
    header.normal = has("N");
    if (!prefix.empty())
      lines.fail("'{}' is not supported; only vertices with three coordinates are (OFF, COFF, NOFF, STOFF)", keyword);
  } else if (!to_integer(next_word(rest))) {
    lines.fail("an OFF file starts with the word OFF and the numbers of vertices and faces");
  } else {
    rest = lines.line();
  }
  std::int64_t counts[2];
  for (int k = 0; k < 2; ++k) {
    while (rest.find_first_not_of(" \t") == rest.npos) {
      if (!lines.next()) throw_input_error("{}: ends before the numbers of vertices and faces", lines.path());
      rest = lines.line();
    }
    std::string_view look_ahead = rest;
    if (next_word(look_ahead) == "BINARY")
      lines.fail("binary OFF is not supported; save the mesh as binary PLY or as text");
    counts[k] = lines.integer_of(rest, k == 0 ? "the number of vertices" : "the number of faces");
    if (counts[k] < 0) lines.fail("the number of {} is negative", k == 0 ? "vertices" : "faces");
  }
  header.n_vertices = static_cast<std::size_t>(counts[0]);
  header.n_faces = static_cast<std::size_t>(counts[1]);
  return header;
}

// The values after the coordinates are normal, colour and texture coordinates, in this order.
void keep_attributes(const Header& header, std::vector<std::vector<double>> columns, MeshFile& mesh) {
  std::size_t next = 0;
  const bool known = header.normal || header.colour || header.texture;
  if (!columns.empty() && !known)
    mesh.notes.push_back(fmt::format("{} per vertex dropped: the header does not say what they are",
                                     counted(columns.size(), "value", "values")));
  if (header.normal && columns.size() >= 3) {
    next = 3;
    mesh.notes.push_back("vertex normals dropped: they would be wrong after a deformation");
  }
  const std::size_t n_texture = header.texture ? 2 : 0;
  const std::size_t n_colour = columns.size() - std::min(columns.size(), next + n_texture);
  if (header.colour && (n_colour == 3 || n_colour == 4)) {
    const char* const names[] = {"red", "green", "blue", "alpha"};
    bool bytes = true;
    for (std::size_t k = 0; k < n_colour; ++k)
      for (const double v : columns[next + k]) bytes = bytes && v >= 0 && v <= 255 && v == static_cast<int>(v);
    for (std::size_t k = 0; k < n_colour; ++k)
      mesh.shape.attributes.push_back({names[k], bytes ? "uchar" : "float", std::move(columns[next + k])});
  }
  if (header.texture && columns.size() >= next + 2)
    for (std::size_t k = 0; k < 2; ++k)
      mesh.shape.attributes.push_back({k == 0 ? "s" : "t", "float", std::move(columns[columns.size() - 2 + k])});
}

}  // namespace

MeshFile read_off(const std::string& path, std::string_view bytes) {
  MeshFile mesh;
  LineReader lines(path, bytes);
  const Header header = read_header(lines);
  const auto ends_early = [&](std::size_t done, std::size_t declared, std::string_view what) {
    throw_input_error("{}: cut off: the header declares {} {}, the file ends after {} (line {})", path, declared, what,
                      done, lines.number());
  };
  std::vector<std::vector<double>> columns;
  for (std::size_t i = 0; i < header.n_vertices; ++i) {
    if (!lines.next()) ends_early(i, header.n_vertices, "vertices");
    std::string_view rest = lines.line();
    Vec<3> x;
    for (int k = 0; k < 3; ++k) x[k] = lines.number_of(rest, "a coordinate of a vertex");
    add_vertex({path, "line", lines.number()}, x, mesh.shape);
    for (std::size_t k = 0; rest.find_first_not_of(" \t") != rest.npos; ++k) {
      const double value = lines.number_of(rest, "a value after the coordinates");
      if (i == 0) columns.emplace_back();
      if (k >= columns.size()) lines.fail("more values than in the line of the first vertex");
      columns[k].push_back(value);
    }
    for (const std::vector<double>& column : columns)
      if (column.size() != i + 1) lines.fail("fewer values than in the line of the first vertex");
  }
  std::size_t n_ignored = 0, n_with_more = 0;
  for (std::size_t f = 0; f < header.n_faces; ++f) {
    if (!lines.next()) ends_early(f, header.n_faces, "faces");
    std::string_view rest = lines.line();
    const std::int64_t n_corners = lines.integer_of(rest, "the number of corners of a face");
    if (n_corners < 0) lines.fail("the number of corners of a face is negative");
    std::vector<Index> polygon;
    for (std::int64_t k = 0; k < n_corners; ++k)
      add_corner({path, "line", lines.number()}, lines.integer_of(rest, "a corner of a face"), header.n_vertices,
                 polygon);
    add_polygon(std::move(polygon), mesh.shape, n_ignored);
    n_with_more += rest.find_first_not_of(" \t") != rest.npos;
  }
  if (n_with_more > 0) mesh.notes.emplace_back("colours of faces dropped");
  if (lines.next())
    lines.fail("the header declares {} vertices and {} faces, but the file goes on; correct the header",
               header.n_vertices, header.n_faces);
  keep_attributes(header, std::move(columns), mesh);
  note_ignored_polygons(n_ignored, mesh.notes);
  return mesh;
}

}  // namespace shellmatch
