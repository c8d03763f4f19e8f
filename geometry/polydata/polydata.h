#pragma once
/// \file
/// What VTK's files hold of polygons, on its way to a shape: every number is checked, because nobody else does. VTK's
/// own readers take whatever memory a count asks for and follow indices wherever they lead.

#include "geometry/surface/surface.h"

#include <string>
#include <string_view>
#include <vector>

namespace shellmatch {

/// Kinds of cells; others are of volumes, which no surface is made of.
enum class CellKind { vertices, lines, polygons, strips };

class PolyData {
 public:
  explicit PolyData(std::string path) : path_(std::move(path)) {}

  /// Points: three coordinates each, after those that are there. \throws InputError where one is not finite
  void add_points(const std::vector<double>& coordinates);

  /// Cells: cell i has the corners from ends[i - 1] (0) to ends[i], points counted from `first_point`. Strips become
  /// triangles. Call it when all points of the cells are there. \throws InputError where a number is out of range
  void add_cells(CellKind kind, const std::vector<double>& ends, const std::vector<double>& corners,
                 std::size_t first_point);

  /// An array of point data as columns: one of n components is NAME_0, NAME_1, ...; "RGB" and "RGBA" of bytes are red,
  /// green, blue, alpha. Normals are dropped. \param values one tuple after the other, of all points \throws InputError
  /// as add_points
  void add_point_array(const std::string& name, std::string_view type, std::size_t n_components,
                       const std::vector<double>& values);

  /// Says that something has been left out.
  void add_dropped(const std::string& what);

  OriginalShape<3>& shape() { return shape_; }
  std::size_t n_points() const { return shape_.vertices.size(); }

  /// The shape, when all is read; `notes` takes what was left out.
  OriginalShape<3> finish(std::vector<std::string>& notes);

 private:
  std::string path_;
  OriginalShape<3> shape_;
  std::size_t n_ignored_ = 0, n_lines_ = 0, n_vertices_ = 0;
  std::vector<std::string> dropped_;
};

/// Most columns of point data that a shape can have.
inline constexpr std::size_t max_columns = 1000;

/// Reads VTK's legacy format (.vtk): polygonal data, and unstructured grids of polygons, in text or binary form.
/// https://docs.vtk.org/en/latest/design_documents/VTKFileFormats.html \throws InputError with file and line or byte
OriginalShape<3> read_legacy_vtk(const std::string& path, std::string_view bytes, std::vector<std::string>& notes);

/// Reads VTK's XML format of polygonal data (.vtp): arrays as text, base64 or raw, compressed by zlib or not.
OriginalShape<3> read_vtp(const std::string& path, std::string_view bytes, std::vector<std::string>& notes);

}  // namespace shellmatch
