#pragma once
/// \file
/// Writing of shapes. Every file is written beside its final name (path + ".part") and renamed, so that what
/// is there is whole. \throws EnvironmentError, in all functions, where the file cannot be written; nothing
/// is left.

#include "geometry/surface/surface.h"

#include <string>
#include <string_view>

namespace shellmatch {

/// Binary little endian PLY: vertices as double, attributes with their own types (values of integer types are
/// rounded and clamped to the type's range), polygons unsplit. Points without polygons have no faces.
void write_ply(const std::string& path, const OriginalShape<3>& shape);

/// Text with a line of names, "x,y" and the attributes, one point in a line, a blank line after every ring.
void write_outline_csv(const std::string& path, const OriginalShape<2>& shape);

/// Text as above with "x,y,z": the points alone.
void write_points_csv(const std::string& path, const OriginalShape<3>& shape);

/// By the ending of the name: .ply and .csv as above; .obj, with colours where there are any; .off; .stl
/// (binary, single precision, polygons split). Other attributes are lost in these. \throws InputError for
/// other endings, and for STL without faces.
void write_shape(const std::string& path, const OriginalShape<3>& shape);

/// Writes `bytes` beside and renames.
void replace_file(const std::string& path, std::string_view bytes);

}  // namespace shellmatch
