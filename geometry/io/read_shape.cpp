#include "geometry/io/read_shape.h"

#include "geometry/io/read_mask.h"
#include "geometry/io/read_mesh_formats.h"
#include "geometry/io/read_points.h"
#include "geometry/repair/repair.h"

#include <algorithm>
#include <initializer_list>

namespace shellmatch {
namespace {

enum class FileKind { mesh, outline, mask, points, unknown };

FileKind kind_of(const std::string& path) {
  const std::string extension = file_extension(path);
  const auto is_one_of = [&](std::initializer_list<std::string_view> list) {
    return std::find(list.begin(), list.end(), extension) != list.end();
  };
  if (is_one_of({".obj", ".off", ".ply", ".stl"})) return FileKind::mesh;
  if (is_one_of({".csv", ".txt", ".xy", ".dat"})) return FileKind::outline;
  if (is_one_of({".png", ".pgm"})) return FileKind::mask;
  if (extension == ".xyz") return FileKind::points;
  return FileKind::unknown;
}

constexpr std::string_view mesh_list = "meshes .obj .off .ply .stl";
constexpr std::string_view outline_list = "outlines .csv .txt .xy .dat, masks .png .pgm";

[[noreturn]] void unsupported(const std::string& path) {
  const std::string extension = file_extension(path);
  throw_input_error("{}: {}; supported are {}, {}", path,
                    extension.empty() ? "the name has no ending that tells the format"
                                      : "the format '" + extension + "' is not supported",
                    mesh_list, outline_list);
}

MeshFile read_mesh_file(const std::string& path) {
  const std::string bytes = read_file_bytes(path), extension = file_extension(path);
  if (extension == ".obj") return read_obj(path, bytes);
  if (extension == ".off") return read_off(path, bytes);
  if (extension == ".ply") return read_ply(path, bytes);
  return read_stl(path, bytes);
}

OriginalShape<2> read_mask(const std::string& path, std::vector<std::string>& notes) {
  const std::string bytes = read_file_bytes(path);
  return mask_rings(file_extension(path) == ".png" ? read_png(path, bytes) : read_pgm(path, bytes), path,
                    notes);
}

}  // namespace

int dimension_of_file(const std::string& path) {
  switch (kind_of(path)) {
    case FileKind::mesh:
      return 3;
    case FileKind::outline:
    case FileKind::mask:
      return 2;
    default:
      return 0;
  }
}

Shape<3> read_mesh(const std::string& path) {
  require_file(path);
  if (dimension_of_file(path) == 2)
    throw_input_error(
        "{}: an outline or mask is a shape of the plane, but a shape of space is wanted here: {}", path,
        mesh_list);
  if (dimension_of_file(path) != 3) unsupported(path);
  MeshFile file = read_mesh_file(path);
  Shape<3> shape{path, std::move(file.shape), {}, std::move(file.notes)};
  shape.surface = mend_surface(shape.original, path, shape.notes);
  return shape;
}

Shape<2> read_outline(const std::string& path) {
  require_file(path);
  if (dimension_of_file(path) == 3)
    throw_input_error("{}: a mesh is a shape of space, but a shape of the plane is wanted here: {}", path,
                      outline_list);
  if (dimension_of_file(path) != 2) unsupported(path);
  Shape<2> shape{path, {}, {}, {}};
  shape.original = kind_of(path) == FileKind::mask ? read_mask(path, shape.notes)
                                                   : read_points<2>(path, read_file_bytes(path), true);
  shape.surface = mend_outline(shape.original, path, shape.notes);
  return shape;
}

AnyShape read_shape(const std::string& path) {
  if (dimension_of_file(path) == 2) return read_outline(path);
  return read_mesh(path);
}

OriginalShape<3> read_points_or_mesh_3d(const std::string& path, std::vector<std::string>* notes) {
  require_file(path);
  switch (kind_of(path)) {
    case FileKind::mesh: {
      MeshFile file = read_mesh_file(path);
      if (file.shape.vertices.empty()) throw_input_error("{}: no vertices in it", path);
      if (notes) notes->insert(notes->end(), file.notes.begin(), file.notes.end());
      return std::move(file.shape);
    }
    case FileKind::outline:
    case FileKind::points:
      return read_points<3>(path, read_file_bytes(path), false);
    case FileKind::mask:
      throw_input_error("{}: a mask is a shape of the plane, but this deformation is one of space", path);
    default:
      unsupported(path);
  }
}

OriginalShape<2> read_points_or_outline_2d(const std::string& path, std::vector<std::string>* notes) {
  require_file(path);
  std::vector<std::string> own_notes;
  switch (kind_of(path)) {
    case FileKind::mask:
      return read_mask(path, notes ? *notes : own_notes);
    case FileKind::outline:
    case FileKind::points:
      return read_points<2>(path, read_file_bytes(path), false);
    case FileKind::mesh:
      throw_input_error("{}: a mesh is a shape of space, but this deformation is one of the plane", path);
    default:
      unsupported(path);
  }
}

}  // namespace shellmatch
