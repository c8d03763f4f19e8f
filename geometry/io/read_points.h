#pragma once
/// \file
/// Tables of points as text: one point per line, columns separated by comma, semicolon, tab or blanks, an
/// optional line of column names, comments from '#'. In the plane, blank lines separate rings. A line of names with
/// commas is one of CSV: names may hold blanks and, in quotes, commas.

#include "geometry/surface/surface.h"

#include <string>
#include <string_view>

namespace shellmatch {

/// Reads a table. The coordinates are the columns named x, y (and z), or the first ones; further columns
/// need names and become attributes of type double; those
/// named name, label, description or desc may hold texts, in quotes where there are commas in them, and are of type
/// text then. In the plane every block of lines is a polygon; with `closed`, a last point that repeats the first of its
/// block is dropped. \throws InputError naming the line where the number of columns changes or a value is not a finite
/// number.
template <int Dim>
OriginalShape<Dim> read_points(const std::string& path, std::string_view bytes, bool closed);

}  // namespace shellmatch
