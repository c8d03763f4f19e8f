#pragma once
/// \file
/// VTK's formats of polygonal data, written by VTK.

#include "geometry/surface/surface.h"

#include <string>

namespace shellmatch {

enum class PolyDataFormat { legacy, xml };

/// The bytes of a file: points in double precision, polygons not triangulated, columns as point data with their types.
/// Columns NAME_0, NAME_1, ... of one type that follow each other are one array, and so are red, green, blue (and
/// alpha) of bytes, "RGB" ("RGBA"): arrays that were read come out again. Columns of text are left out. A frame that is
/// known is named in the title and in the data field SPACE, as 3D Slicer does. \throws EnvironmentError where VTK fails
std::string polydata_bytes(const OriginalShape<3>& shape, PolyDataFormat format);

}  // namespace shellmatch
