#include "geometry/io/read_shape.h"

#include "base/error.h"
#include "base/stop.h"
#include "geometry/io/input_file.h"
#include "geometry/io/picture_height.h"
#include "geometry/io/read_points.h"
#include "geometry/mesh_text/read_mesh_formats.h"
#include "geometry/outline/drawing.h"
#include "geometry/outline/tps_file.h"
#include "geometry/picture/picture_shape.h"
#include "geometry/picture/read_mask.h"
#include "geometry/polydata/polydata.h"
#include "geometry/repair/make_shape.h"
#include "geometry/repair/repair_steps.h"
#include "geometry/scene/brain_surface.h"
#include "geometry/scene/scene_shape.h"

#include <optional>
#include <utility>

namespace shellmatch {
namespace {

constexpr std::string_view mesh_list =
    "meshes .obj .off .ply .stl .vtk .vtp .gii .glb .gltf .3mf .dae and FreeSurfer's surfaces";
constexpr std::string_view volume_list = "volumes .nii .nii.gz .nrrd .nhdr .mha .mhd .vti";
constexpr std::string_view outline_list =
    "outlines .csv .txt .xy .dat .tps .roi .zip .geojson .json .svg, masks .png .pgm .tif .tiff .jpg .jpeg .bmp";

[[noreturn]] void unsupported(const InputFile& file) {
  const std::string extension = file_extension(file.path());
  throw_input_error("{}: {}; supported are {}, {}, {}", file.path(),
                    extension.empty() ? "the name has no ending that tells the format"
                                      : "the format '" + extension + "' is not supported",
                    mesh_list, volume_list, outline_list);
}

// The shape as it stands in the file. \pre the format is that of a mesh
MeshFile parse_mesh(const InputFile& file) {
  const std::string bytes = file.read();
  MeshFile mesh;
  switch (file.format()) {
    case FileFormat::obj: mesh = read_obj(file.path(), bytes); break;
    case FileFormat::off: mesh = read_off(file.path(), bytes); break;
    case FileFormat::ply: mesh = read_ply(file.path(), bytes); break;
    case FileFormat::vtk: mesh.shape = read_legacy_vtk(file.path(), bytes, mesh.notes); return mesh;
    case FileFormat::vtp: mesh.shape = read_vtp(file.path(), bytes, mesh.notes); return mesh;
    case FileFormat::gifti: return read_gifti(file.path(), bytes);
    case FileFormat::freesurfer: return read_freesurfer(file.path(), bytes);
    case FileFormat::gltf: return read_gltf(file.path(), bytes);
    case FileFormat::collada: return read_collada(file.path(), bytes);
    case FileFormat::three_mf: return read_three_mf(file.path(), bytes);
    default: mesh = read_stl(file.path(), bytes);
  }
  if (mesh.shape.space == Space::unsaid) mesh.shape.space = space_of_mesh(bytes);
  return mesh;
}

std::optional<Picture> parse_picture(const InputFile& file) {
  switch (file.format()) {
    case FileFormat::png: return read_png(file.path(), file.read());
    case FileFormat::pgm: return read_pgm(file.path(), file.read());
    case FileFormat::tiff: return read_tiff(file.path(), file.read());
    case FileFormat::jpeg: return read_jpeg(file.path(), file.read());
    case FileFormat::bmp: return read_bmp(file.path(), file.read());
    default: return std::nullopt;
  }
}

std::optional<Drawing> parse_drawing(const InputFile& file, const std::string& part) {
  switch (file.format()) {
    case FileFormat::tps: return read_tps_outline(file.path(), file.read(), part);
    case FileFormat::roi: return read_roi(file.path(), file.read());
    case FileFormat::roi_set: return read_roi_set(file.path(), file.read());
    case FileFormat::geojson: return read_geojson(file.path(), file.read());
    case FileFormat::svg: return read_svg(file.path(), file.read());
    default: return std::nullopt;
  }
}

// The shape of an outline or a mask. \param closed as of read_points
DrawnOutline parse_outline(const InputFile& file, const std::string& part, bool closed) {
  const std::string source = part.empty() ? file.path() : file.path() + ":" + part;
  if (const std::optional<Picture> picture = parse_picture(file)) {
    DrawnOutline outline;
    const auto choice = part.empty() ? std::nullopt : std::optional(parse_choice(part, source, "mask.png"));
    outline.shape = mask_rings(shape_of_picture(*picture, choice, source, outline.notes), source, outline.notes);
    return outline;
  }
  if (std::optional<Drawing> drawing = parse_drawing(file, part))
    return outline_of_drawing(std::move(*drawing), source, part);
  return {read_points<2>(file.path(), file.read(), closed), {}, {}, {}};
}

// Landmarks alone, as a table of points.
template <int Dim>
OriginalShape<Dim> points_of_tps(const std::vector<TpsSpecimen>& specimens, const TpsSpecimen& specimen,
                                 const std::string& path, std::vector<std::string>& notes) {
  OriginalShape<Dim> shape;
  shape.space = Dim == 3 ? specimen.space : Space::unsaid;
  VertexAttribute names{"name", "text", {}, {}};
  const std::vector<std::optional<Vec<Dim>>> points = scaled_landmarks<Dim>(specimen, path);
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (!points[i]) continue;
    shape.vertices.push_back(*points[i]);
    names.texts.push_back(fmt::format("{}", i + 1));
  }
  if (shape.vertices.empty()) throw_input_error("{}: none of its landmarks has a position", path);
  if (const std::size_t n = points.size() - shape.vertices.size(); n > 0)
    notes.push_back(counted(n, "landmark", "landmarks") + " without position left out");
  if (std::string note = scale_note(specimens, specimen); !note.empty()) notes.push_back(std::move(note));
  if (Dim == 2) {
    shape.polygons.emplace_back();
    for (std::size_t v = 0; v < shape.vertices.size(); ++v) shape.polygons[0].push_back(static_cast<Index>(v));
  }
  shape.attributes.push_back(std::move(names));
  return shape;
}

Shape<3> mesh_of(const InputFile& file, Closing closing = Closing::never) {
  Activity reading("reading", 10);
  reading.next(4);
  MeshFile mesh = parse_mesh(file);
  reading.next(6);
  Shape<3> shape = make_shape(std::move(mesh.shape), file.path(), std::move(mesh.notes), closing);
  shape.unit = std::move(mesh.unit);
  return shape;
}

Shape<2> outline_of(const InputFile& file, const std::string& part, const std::string& source) {
  DrawnOutline outline = parse_outline(file, part, true);
  try {
    Shape<2> shape = make_shape(std::move(outline.shape), source, std::move(outline.notes));
    shape.unit = std::move(outline.unit);
    return shape;
  } catch (const InputError& error) {
    if (outline.choices.empty()) throw;
    throw_input_error("{}; several areas are taken together: choose one, as in \"{}:NAME\", of {}", error.what(),
                      file.path(), outline.choices);
  }
}

}  // namespace

double picture_height(const std::string& source) {
  const PartName name = split_part(source);
  if (!is_picture(format_of(name.file))) return 0;
  return parse_picture(InputFile(name.file))->brightness.height;
}

PlaneFrame frame_of_drawing(const std::string& source) {
  const FileFormat format = format_of(split_part(source).file);
  return has_parts(format) && !is_picture(format) ? read_points_or_outline_2d(source).frame : PlaneFrame();
}

int dimension_of_file(const std::string& path) { return dimension_of(format_of(split_part(path).file)); }

Shape<3> read_mesh(const std::string& path) {
  const InputFile file(path);
  const int dimension = dimension_of(file.format());
  if (dimension == 2)
    throw_input_error("{}: an outline or mask is a shape of the plane, but a shape of space is wanted here: {}", path,
                      mesh_list);
  if (dimension != 3) unsupported(file);
  return mesh_of(file);
}

Shape<2> read_outline(const std::string& path) {
  const PartName name = split_part(path);
  const InputFile file(name.file);
  const int dimension = dimension_of(file.format());
  if (dimension == 3)
    throw_input_error("{}: a mesh is a shape of space, but a shape of the plane is wanted here: {}", path,
                      outline_list);
  if (dimension != 2) unsupported(file);
  return outline_of(file, name.part, path);
}

AnyShape read_shape(const std::string& path, Closing closing) {
  const PartName name = split_part(path);
  const InputFile file(name.file);
  switch (dimension_of(file.format())) {
    case 2: return outline_of(file, name.part, path);
    case 3: return mesh_of(file, closing);
    default: unsupported(file);
  }
}

OriginalShape<3> read_points_or_mesh_3d(const std::string& path, std::vector<std::string>* notes) {
  const PartName name = split_part(path);
  const InputFile file(name.file);
  switch (file.format()) {
    case FileFormat::table:
    case FileFormat::points: return read_points<3>(path, file.read(), false);
    case FileFormat::tps: {
      std::vector<std::string> own_notes;
      const std::vector<TpsSpecimen> specimens = parse_tps(name.file, file.read());
      return points_of_tps<3>(specimens, chosen_specimen(specimens, name.file, name.part), path,
                              notes ? *notes : own_notes);
    }
    case FileFormat::png:
    case FileFormat::pgm:
    case FileFormat::tiff:
    case FileFormat::jpeg:
    case FileFormat::bmp:
    case FileFormat::roi:
    case FileFormat::roi_set:
    case FileFormat::geojson:
    case FileFormat::svg:
      throw_input_error("{}: {} is a shape of the plane, but this deformation is one of space", path,
                        is_picture(file.format()) ? "a mask" : "a drawing");
    case FileFormat::unknown: unsupported(file);
    default: {
      MeshFile mesh = parse_mesh(file);
      if (mesh.shape.vertices.empty()) throw_input_error("{}: no vertices in it", path);
      if (notes) notes->insert(notes->end(), mesh.notes.begin(), mesh.notes.end());
      return std::move(mesh.shape);
    }
  }
}

Surface<3> read_triangles(const std::string& path) {
  OriginalShape<3> original = read_points_or_mesh_3d(path);
  Triangles triangles = triangulate(original);
  return {std::move(original.vertices), std::move(triangles)};
}

OriginalShape<2> read_points_or_outline_2d(const std::string& path, std::vector<std::string>* notes) {
  const PartName name = split_part(path);
  const InputFile file(name.file);
  if (file.format() == FileFormat::unknown) unsupported(file);
  if (dimension_of(file.format()) == 3)
    throw_input_error("{}: a mesh is a shape of space, but this deformation is one of the plane", path);
  std::vector<std::string> own_notes;
  if (!notes) notes = &own_notes;
  if (file.format() == FileFormat::tps) {
    const std::vector<TpsSpecimen> specimens = parse_tps(name.file, file.read());
    const TpsSpecimen& specimen = chosen_specimen(specimens, name.file, name.part);
    if (specimen.curves.empty()) return points_of_tps<2>(specimens, specimen, path, *notes);
  }
  DrawnOutline outline = parse_outline(file, name.part, false);
  notes->insert(notes->end(), outline.notes.begin(), outline.notes.end());
  return std::move(outline.shape);
}

}  // namespace shellmatch
