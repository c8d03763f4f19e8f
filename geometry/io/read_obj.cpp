// Wavefront OBJ: "v x y z [red green blue]" and "f i j k ..." with indices from 1, or relative to the end if
// negative.
#include "geometry/io/read_mesh_formats.h"

#include <array>

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

}  // namespace

MeshFile read_obj(const std::string& path, std::string_view bytes) {
  MeshFile mesh;
  LineReader lines(path, bytes);
  std::array<std::vector<double>, 3> colours;
  std::vector<std::pair<std::size_t, std::size_t>> far_corners;  // polygon and line of indices beyond the vertices so far
  std::size_t n_ignored = 0;
  std::string joined;
  while (lines.next()) {
    const std::size_t number = lines.number();
    std::string_view rest = statement(lines, joined);
    const std::string_view keyword = next_word(rest);
    if (keyword == "v") {
      Vec<3> x;
      for (int k = 0; k < 3; ++k) x[k] = lines.number_of(rest, "a coordinate of a vertex");
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
          lines.fail("a corner of a face should be a vertex number from 1, or a negative one, not '{}'",
                     word);
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
  return mesh;
}

}  // namespace shellmatch
