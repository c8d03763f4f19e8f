// Wavefront OBJ: "v x y z [red green blue]" and "f i j k ..." with indices from 1, or relative to the end if
// negative.
#include "geometry/mesh_text/read_mesh_formats.h"
#include "geometry/surface/mesh_details.h"

#include <algorithm>
#include <array>
#include <memory>

namespace shellmatch {
namespace {

// One statement; lines that end in a backslash continue on the next line.
std::string_view statement(LineReader& lines, std::string& joined) {
  std::string_view line = lines.line();
  if (!line.ends_with('\\')) return line;
  joined.clear();
  do {
    joined.append(line.substr(0, line.size() - 1)).push_back(' ');
    if (!lines.next_line()) break;
    line = lines.line();
  } while (line.ends_with('\\'));
  return joined.append(line);
}

// Has a corner of a face a third number?
bool has_normal(std::string_view corners) {
  for (std::string_view word = next_word(corners); !word.empty(); word = next_word(corners))
    if (std::count(word.begin(), word.end(), '/') > 1) return true;
  return false;
}

// A statement of a face without the numbers of normals: "f 1/2/3 4//5" is "f 1/2 4".
std::string without_normals(std::string_view line) {
  std::string text(next_word(line));
  for (std::string_view word = next_word(line); !word.empty(); word = next_word(line)) {
    const std::size_t first = word.find('/'), second = first == word.npos ? first : word.find('/', first + 1);
    text.append(" ").append(second == first + 1 ? word.substr(0, first) : word.substr(0, second));
  }
  return text;
}

}  // namespace

MeshFile read_obj(const std::string& path, std::string_view bytes) {
  MeshFile mesh;
  auto details = std::make_shared<MeshDetails>();
  bool has_normals = false;
  LineReader lines(path, bytes);
  std::array<std::vector<double>, 3> colours;
  std::vector<std::pair<std::size_t, std::size_t>>
      far_corners;  // polygon and line of indices beyond the vertices so far
  std::size_t n_ignored = 0;
  std::string joined;
  for (;;) {
    const char* const begin = lines.rest().data();
    if (!lines.next_line()) break;
    const std::size_t number = lines.number();
    std::string_view rest = statement(lines, joined);
    const std::string_view whole = rest, keyword = next_word(rest);
    // As it stands in the file, with comments.
    std::string_view raw(begin, static_cast<std::size_t>(lines.rest().data() - begin));
    raw = raw.substr(0, raw.find_last_not_of("\r\n") + 1);
    if (keyword == "vn") {
      has_normals = true;
      continue;
    }
    const bool is_frame = keyword.empty() && space_in_comment(raw) != Space::unsaid;
    if (keyword == "f" && has_normal(rest)) details->obj_text.append(without_normals(whole)).push_back('\n');
    else if (keyword != "v" && !is_frame)
      details->obj_text.append(raw.find_first_of("\r\n") == raw.npos ? raw : whole).push_back('\n');
    if (keyword == "v") {
      Vec<3> x;
      for (int k = 0; k < 3; ++k) x[k] = lines.number_of(rest, "a coordinate of a vertex");
      details->obj_text.append("v").append(rest).push_back('\n');
      std::vector<double> extra;
      while (rest.find_first_not_of(" \t") != std::string_view::npos)
        extra.push_back(lines.number_of(rest, "a value after the coordinates"));
      add_vertex({path, "line", number}, x, mesh.shape);
      // Four numbers are x y z w; six and seven are x y z and a colour.
      if (extra.size() == 3 || extra.size() == 4)
        for (int k = 0; k < 3; ++k) colours[k].push_back(extra[k]);
    } else if (keyword == "f") {
      std::vector<Index> polygon;
      for (std::string_view word = next_word(rest); !word.empty(); word = next_word(rest)) {
        const std::optional<std::int64_t> index = to_integer(word.substr(0, word.find('/')));
        if (!index || *index == 0)
          lines.fail("a corner of a face should be a vertex number from 1, or a negative one, not '{}'", word);
        const auto n = static_cast<std::int64_t>(mesh.shape.vertices.size());
        const std::int64_t corner = *index > 0 ? *index - 1 : n + *index;
        if (corner < 0 || corner >= std::numeric_limits<Index>::max())
          lines.fail("a face names vertex {}, but there are {} vertices so far", *index, n);
        // Vertices may follow the faces that refer to them.
        if (corner >= n && (far_corners.empty() || far_corners.back().second != number))
          far_corners.emplace_back(mesh.shape.polygons.size(), number);
        polygon.push_back(static_cast<Index>(corner));
      }
      add_polygon(std::move(polygon), mesh.shape, n_ignored);
    }
  }
  const std::size_t n_vertices = mesh.shape.vertices.size();
  if (n_vertices == 0) throw_input_error("{}: no vertices ('v' lines) found; is it an OBJ file?", path);
  for (const auto& [polygon, line] : far_corners) {
    if (polygon == mesh.shape.polygons.size()) continue;
    std::vector<Index> checked;
    for (const Index corner : mesh.shape.polygons[polygon])
      add_corner({path, "line", line}, corner, n_vertices, checked);
  }
  if (!colours[0].empty() && colours[0].size() == n_vertices) {
    const char* const names[] = {"red", "green", "blue"};
    for (int k = 0; k < 3; ++k) mesh.shape.attributes.push_back({names[k], "float", std::move(colours[k])});
  } else if (!colours[0].empty()) {
    mesh.notes.push_back("vertex colours dropped: not every vertex has one");
  }
  note_ignored_polygons(n_ignored, mesh.notes);
  if (has_normals) mesh.notes.push_back("vertex normals dropped: they would be wrong after a deformation");
  mesh.shape.details = std::move(details);
  return mesh;
}

}  // namespace shellmatch
