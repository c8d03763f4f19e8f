#pragma once
/// \file
/// Reading of shapes: what a file name stands for, and a closed surface out of it.
///
/// In space: meshes .obj, .off, .ply, .stl, .vtk, .vtp, .gii, .glb, .gltf, .3mf, .dae, and surfaces of FreeSurfer's,
/// which are known by their first bytes. In the plane: outlines .csv, .txt, .xy, .dat (two columns, rings separated by
/// blank lines), drawings .tps, .roi, .zip of ROIs, .geojson, .svg (geometry/outline/drawing.h), of which
/// "rois.zip:NAME" chooses an area, and masks .png, .pgm, .tif, .jpg, .bmp (geometry/picture/picture_shape.h), of which
/// "mask.png:3" chooses a label.

#include "geometry/repair/repair.h"
#include "geometry/surface/surface.h"

#include <string>
#include <variant>
#include <vector>

namespace shellmatch {

using AnyShape = std::variant<Shape<2>, Shape<3>>;

/// Reads and mends a mesh (geometry/repair/repair.h says how).
/// \throws InputError in one sentence that names the file, the line or element, what is wrong and what to do.
Shape<3> read_mesh(const std::string& path);

/// Reads an outline or the border of a mask, whose coordinates are pixels with y upward
/// (geometry/picture/read_mask.h), or a drawing's areas. A last point that repeats the first of its ring is dropped.
/// \throws InputError as above.
Shape<2> read_outline(const std::string& path);

/// A mesh as it stands in the file, its polygons divided into triangles: nothing is welded, dropped or turned; points
/// have no triangles. \throws InputError where it cannot be read.
Surface<3> read_triangles(const std::string& path);

/// An outline or a mesh, by the ending of the file name.
/// \param closing of a mesh that is not closed
AnyShape read_shape(const std::string& path, Closing closing = Closing::never);

/// 2 or 3 by the ending of the file name; 0 where it is neither's.
int dimension_of_file(const std::string& path);

/// Something to be moved by a deformation: any mesh, open or not, or points as text (.csv, .txt, .xyz) with
/// three columns. `notes`, if given, takes what was dropped. \throws InputError where it cannot be read.
OriginalShape<3> read_points_or_mesh_3d(const std::string& path, std::vector<std::string>* notes = nullptr);

/// The same in the plane: points or outlines with two columns, as they stand in the file; or a mask.
OriginalShape<2> read_points_or_outline_2d(const std::string& path, std::vector<std::string>* notes = nullptr);

}  // namespace shellmatch
