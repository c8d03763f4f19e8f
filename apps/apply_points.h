#pragma once
/// \file
/// Points that `apply` has moved, as files of other programs.

#include "apps/commands.h"
#include "geometry/surface/surface.h"
#include "matching/pairs/point_formats.h"

#include <string>

namespace shellmatch {

/// Checks before any work is done that points can be written there: as named points (matching/pairs/point_formats.h) or
/// as a shape. \throws InputError
void check_points_output(const std::string& path, int dimension, bool force);

/// The vertices of a shape by the names of its column `name` or `label`, otherwise by their numbers from 1.
template <int Dim>
PointSet<Dim> named_vertices(const OriginalShape<Dim>& shape);

/// Writes them in the format of the name's ending; a line says what that does not hold. Points that are not known are
/// left out of formats of shapes.
template <int Dim>
void write_points(const ApplyCommand& command, PointSet<Dim> set, Space space);

}  // namespace shellmatch
