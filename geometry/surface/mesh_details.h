#pragma once
/// \file
/// What a file of a mesh holds besides vertices, their columns and polygons, so that writing the same format gives it
/// back.

#include <cstddef>
#include <string>
#include <vector>

namespace shellmatch {

/// A property of the items of an element of a PLY file.
struct DetailColumn {
  std::string name, type;              ///< the type in PLY's words
  std::string count_type = {};         ///< of the length of a list; empty of a single value
  std::vector<double> values = {};     ///< one for each item, or those of all lists
  std::vector<std::size_t> ends = {};  ///< of a list: where in `values` that of each item ends
};

/// An element of a PLY file: its items and their properties.
struct DetailTable {
  std::string name;
  std::size_t n_items = 0;
  std::vector<DetailColumn> columns = {};
};

struct MeshDetails {
  /// OBJ: all statements and comments in their order, without normals. A line of a vertex has in place of its
  /// coordinates none: "v", or "v 0.1 0.2 0.3" with a colour.
  std::string obj_text;
  /// PLY: lines of comment, with their first word; properties of the faces, one for each polygon; elements besides
  /// vertices and faces.
  std::vector<std::string> ply_comments;
  std::vector<DetailColumn> ply_faces;
  std::vector<DetailTable> ply_elements;
  /// A table of points: the names of its columns in their order, and which of them hold x, y and z. Empty of a table
  /// without names.
  std::vector<std::string> table_columns;
  std::vector<std::size_t> table_coordinates;
};

}  // namespace shellmatch
