#include "geometry/mesh_text/read_mesh_formats.h"

#include <algorithm>

namespace shellmatch {

Space space_of_mesh(std::string_view bytes) {
  // Comments follow the first line at once, or stand before it; a header of STL has no ends of line.
  constexpr std::size_t longest_head = 2000;
  std::string_view head = bytes.substr(0, longest_head);
  for (std::size_t n = 0; !head.empty(); ++n) {
    const std::size_t end = std::min(head.find_first_of("\r\n"), head.size());
    const std::string_view line = head.substr(0, end);
    const bool is_comment = line.starts_with('#') || line.starts_with("comment") || line.starts_with("obj_info") ||
                            line.starts_with("format");
    if (n > 0 && !line.empty() && !is_comment) return Space::unsaid;
    if (const Space space = space_in_comment(n == 0 && !is_comment ? line.substr(0, 80) : line); space != Space::unsaid)
      return space;
    head.remove_prefix(std::min(end + 1, head.size()));
  }
  return Space::unsaid;
}

void add_vertex(const FilePosition& place, const Vec<3>& x, OriginalShape<3>& shape) {
  if (!x.allFinite())
    throw_input_error(
        "{}: vertex {} (counted from 0) has a coordinate that is not finite ({}, {}, {}); "
        "remove the vertex or give it a position",
        place.text(), shape.vertices.size(), x.x(), x.y(), x.z());
  if (shape.vertices.size() == static_cast<std::size_t>(std::numeric_limits<Index>::max()))
    throw_input_error("{}: more than {} vertices; simplify the mesh", place.text(), shape.vertices.size());
  shape.vertices.push_back(x);
}

void add_corner(const FilePosition& place, std::int64_t index, std::size_t n_vertices, std::vector<Index>& polygon) {
  if (index < 0 || index >= static_cast<std::int64_t>(n_vertices))
    throw_input_error(
        "{}: a face names vertex {} (counted from 0), but there are {} vertices; "
        "the file is damaged or was cut off",
        place.text(), index, n_vertices);
  polygon.push_back(static_cast<Index>(index));
}

void add_polygon(std::vector<Index> polygon, OriginalShape<3>& shape, std::size_t& n_ignored) {
  if (polygon.size() < 3) ++n_ignored;
  else shape.polygons.push_back(std::move(polygon));
}

void note_ignored_polygons(std::size_t n_ignored, std::vector<std::string>& notes) {
  if (n_ignored > 0) notes.push_back(counted(n_ignored, "face", "faces") + " with fewer than three corners ignored");
}

}  // namespace shellmatch
