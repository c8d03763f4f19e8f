#pragma once
/// \file
/// The mesh file formats, each from the bytes of a file to the shape as it stands there. Written here, not
/// taken from CGAL's readers: those give no line for an error, allocate what a damaged header asks for and
/// drop attributes.
///
/// All of them check declared counts against the data, indices against the number of vertices and coordinates
/// for being finite, and throw InputError with the file and the line or element. A shape may be open or have
/// no faces.

#include "geometry/io/read_text.h"
#include "geometry/surface/surface.h"

#include <string>
#include <string_view>
#include <vector>

namespace shellmatch {

/// A mesh as it stands in a file, and what the reader left out, in words.
struct MeshFile {
  OriginalShape<3> shape;
  std::vector<std::string> notes;
};

MeshFile read_obj(const std::string& path, std::string_view bytes);
MeshFile read_off(const std::string& path, std::string_view bytes);
MeshFile read_ply(const std::string& path, std::string_view bytes);
/// Triangles become a mesh: corners with equal coordinates are one vertex.
MeshFile read_stl(const std::string& path, std::string_view bytes);

/// A position in a file, for messages: "hand.off, line 12".
struct FilePosition {
  const std::string& path;
  std::string_view unit;  ///< "line", or what a binary file counts: "face"
  std::size_t number;
  std::string text() const { return fmt::format("{}, {} {}", path, unit, number); }
};

/// Adds a vertex. \throws InputError naming the place and the vertex (counted from 0) where it is not finite.
void add_vertex(const FilePosition& place, const Vec<3>& x, OriginalShape<3>& shape);

/// Checks a corner of a polygon against the number of vertices and adds it.
void add_corner(const FilePosition& place, std::int64_t index, std::size_t n_vertices, std::vector<Index>& polygon);

/// Adds `polygon` unless it has fewer than three corners; counts in `n_ignored` where it has.
void add_polygon(std::vector<Index> polygon, OriginalShape<3>& shape, std::size_t& n_ignored);
void note_ignored_polygons(std::size_t n_ignored, std::vector<std::string>& notes);

}  // namespace shellmatch
