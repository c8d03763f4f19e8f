#pragma once
/// \file
/// Writing of shapes. Every file is written under a temporary name and then renamed (base/replace_file.h), so that an
/// existing file is always complete. Meshes name the frame of their coordinates in a comment, where it is known. All
/// functions throw EnvironmentError where the file cannot be written, and remove the temporary file. Where an existing
/// file is to be kept they throw InputError if there is one, also if it came into being during the writing.

#include "base/replace_file.h"
#include "geometry/surface/surface.h"

#include <string>
#include <string_view>
#include <vector>

namespace shellmatch {

/// Binary little endian PLY: vertices as double, attributes with their own types (values of integer types are
/// rounded and clamped to the type's range), polygons not triangulated, comments, properties of faces and further
/// elements as they were read from PLY. Columns have their ply_names(); those of text are left out. Points without
/// polygons have no faces.
void write_ply(const std::string& path, const OriginalShape<3>& shape, Existing existing = Existing::is_replaced);

/// The names of the columns in a PLY, which are single words: all different, and none that of a coordinate or of a
/// normal's component. Where need be a number is added: "x_2".
std::vector<std::string> ply_names(const OriginalShape<3>& shape);

/// Text with a line of names, "x,y" and the attributes, one point per line, a blank line after every ring. Columns that
/// were read from a table with names keep these and their order.
void write_outline_csv(const std::string& path, const OriginalShape<2>& shape,
                       Existing existing = Existing::is_replaced);

/// Text as above with "x,y,z", without polygons.
void write_points_csv(const std::string& path, const OriginalShape<3>& shape,
                      Existing existing = Existing::is_replaced);

/// A line of comment that names the frame of coordinates as 3D Slicer does, "# SPACE=LPS\n"; empty where it is unsaid.
std::string space_comment(std::string_view begin, Space space);

/// What of the shape a file of that name cannot hold, in words: "the columns quality, label"; nothing where nothing is
/// lost.
std::vector<std::string> left_out(const std::string& path, const OriginalShape<3>& shape);

/// Writes the format of the file name's extension: .ply and .csv as above; .obj, with colours if there are
/// any, and with all that stood in a file of OBJ; .off; .stl (binary, single precision, polygons triangulated); .vtk
/// and .vtp with all attributes (geometry/polydata/write_polydata.h). .obj, .off and .stl omit other attributes.
/// \throws InputError for other extensions, and for STL without faces.
void write_shape(const std::string& path, const OriginalShape<3>& shape, Existing existing = Existing::is_replaced);

}  // namespace shellmatch
