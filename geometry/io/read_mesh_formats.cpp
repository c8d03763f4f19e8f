#include "geometry/io/read_mesh_formats.h"

namespace shellmatch {

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
  if (polygon.size() < 3)
    ++n_ignored;
  else
    shape.polygons.push_back(std::move(polygon));
}

void note_ignored_polygons(std::size_t n_ignored, std::vector<std::string>& notes) {
  if (n_ignored > 0)
    notes.push_back(counted(n_ignored, "face", "faces") + " with fewer than three corners ignored");
}

}  // namespace shellmatch
