#pragma once
/// \file
/// Readers of mesh file formats, from the bytes of a file to the shape as read. CGAL's readers are not used,
/// because they do not report the line of an error, allocate whatever a damaged header declares, and drop
/// attributes.
///
/// All readers check declared counts against the data, indices against the number of vertices, and that
/// coordinates are finite, and throw InputError with the file and the line or element. A shape may be open or
/// have no faces.

#include "geometry/mesh_text/read_text.h"
#include "geometry/surface/surface.h"

#include <string>
#include <string_view>
#include <vector>

namespace shellmatch {

/// A mesh as read from a file, and notes on what the reader ignored.
struct MeshFile {
  OriginalShape<3> shape;
  std::vector<std::string> notes;
  std::string unit = {};  ///< of the coordinates, where the format says it: "mm"
};

MeshFile read_obj(const std::string& path, std::string_view bytes);
MeshFile read_off(const std::string& path, std::string_view bytes);
MeshFile read_ply(const std::string& path, std::string_view bytes);
/// Merges corners with equal coordinates into one vertex.
MeshFile read_stl(const std::string& path, std::string_view bytes);

/// The frame that the comments at the head of a mesh name (geometry/surface/space.h): of OBJ, OFF and PLY lines of
/// comment, of STL the first line or the header of 80 bytes.
Space space_of_mesh(std::string_view bytes);

/// A position in a file, for messages: "hand.off, line 12".
struct FilePosition {
  const std::string& path;
  std::string_view unit;  ///< "line", or the element of a binary file: "face"
  std::size_t number;
  std::string text() const { return fmt::format("{}, {} {}", path, unit, number); }
};

/// Adds a vertex. \throws InputError naming the place and the vertex (counted from 0) where it is not finite.
void add_vertex(const FilePosition& place, const Vec<3>& x, OriginalShape<3>& shape);

/// Checks a corner of a polygon against the number of vertices and adds it.
void add_corner(const FilePosition& place, std::int64_t index, std::size_t n_vertices, std::vector<Index>& polygon);

/// Adds `polygon` if it has at least three corners; otherwise increments `n_ignored`.
void add_polygon(std::vector<Index> polygon, OriginalShape<3>& shape, std::size_t& n_ignored);
void note_ignored_polygons(std::size_t n_ignored, std::vector<std::string>& notes);

}  // namespace shellmatch
