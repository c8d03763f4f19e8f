// Everything in the file is checked: it may have been written, or changed, by anybody.
#include "base/error.h"
#include "geometry/io/input_file.h"
#include "geometry/vtk_xml/xml_file.h"
#include "grid/octree/rebuild_grid.h"
#include "matching/map_file/deformation_file.h"
#include "matching/output/checksum.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <limits>
#include <memory>
#include <optional>
#include <utility>

namespace shellmatch {

namespace {

// Numbers of VTK's cells: squares and cubes along the axes.
constexpr std::uint8_t vtk_pixel = 8, vtk_voxel = 11;

std::string file_in(const std::string& path) {
  std::error_code error;  // as of a name that is too long: the file cannot be opened then
  return std::filesystem::is_directory(path, error) ? (std::filesystem::path(path) / deformation_file_name).string()
                                                    : path;
}

// The bytes of a file that is whole.
std::string checked_bytes(const std::string& path) {
  const FileChecksum checksum = verify_checksum(path);
  if (checksum == FileChecksum::earlier)
    throw_input_error(
        "{}: written by an earlier version of this program, whose checksums this one does not verify; match the shapes "
        "again",
        path);
  if (checksum != FileChecksum::matches)
    throw_input_error(
        "{}: damaged, cut off, or no deformation that this program wrote (the checksum at its end is missing or "
        "wrong); give the deformation.vtu of an output folder, or the folder",
        path);
  return InputFile(path).read();
}

constexpr XmlExpectation of_a_map{"UnstructuredGrid", "deformation that this program wrote", "a map is of another",
                                  "; give the deformation.vtu of an output folder, or the folder"};

/// The arrays of one grid, each of the type that this program writes.
class MapFile {
 public:
  /// \pre both outlive this object
  MapFile(const std::string& path, std::string_view bytes) try : file_(path, bytes, of_a_map) {
    if (file_.pieces().size() != 1) file_.damaged("it is not of one piece");
    n_points_ = file_.number(piece().tag, "NumberOfPoints", 0);
    n_cells_ = file_.number(piece().tag, "NumberOfCells", 0);
  } catch (const DamagedXmlFile&) {
    throw;
  } catch (const InputError& other) {
    throw_input_error("{}: damaged, cut off, or no {} ({}){}", path, of_a_map.what, other.what(), of_a_map.instead);
  }

  std::size_t n_points() const { return n_points_; }
  std::size_t n_cells() const { return n_cells_; }
  bool has_fact(std::string_view name) const { return VtkXmlFile::find(file_.facts(), "FieldData", name) != nullptr; }

  /// All components of one tuple after the other. \throws InputError where the array is missing, of another type or
  /// size, damaged, not finite, or not whole in one of whole numbers
  std::vector<double> values(std::string_view section, std::string_view name, ValueType type, std::size_t n_components,
                             std::size_t n_tuples) const {
    const XmlArray* array = VtkXmlFile::find(section == "FieldData" ? file_.facts() : piece(), section, name);
    if (array == nullptr || array->type != type || array->n_components != n_components) damaged(name);
    std::vector<double> found;
    try {
      found = file_.values(*array, n_components * n_tuples);
    } catch (const InputError&) {
      damaged(name);
    }
    const bool are_whole = type != ValueType::float64;
    const auto may_be = [&](double x) { return std::isfinite(x) && (!are_whole || x == std::floor(x)); };
    if (!std::ranges::all_of(found, may_be)) damaged(name);
    return found;
  }
  std::vector<double> facts(std::string_view name, std::size_t n) const {
    return values("FieldData", name, ValueType::float64, n, 1);
  }

  [[noreturn]] void damaged(std::string_view why) const { file_.damaged(why); }

 private:
  const XmlPiece& piece() const { return file_.pieces().front(); }

  VtkXmlFile file_;
  std::size_t n_points_ = 0, n_cells_ = 0;
};

int dimension_of(const MapFile& file) {
  const double value = file.values("FieldData", "dimension", ValueType::int32, 1, 1)[0];
  if (value != 2 && value != 3) file.damaged("the dimension is neither 2 nor 3");
  return static_cast<int>(value);
}

// Level and lower corner of the cells in the file, checked to lie on the lattice.
template <int Dim>
std::vector<LeafPlace<Dim>> places_of(const MapFile& file, const std::vector<double>& positions) {
  const std::size_t n = file.n_cells();
  if (n == 0) file.damaged("it has no cells");
  const auto levels = file.values("CellData", "level", ValueType::int32, 1, n);
  const auto types = file.values("Cells", "types", ValueType::uint8, 1, n);
  const auto ends = file.values("Cells", "offsets", ValueType::int64, 1, n);
  const auto corners = file.values("Cells", "connectivity", ValueType::int64, 1, n * n_corners<Dim>);
  std::vector<LeafPlace<Dim>> places(n);
  for (std::size_t i = 0; i < places.size(); ++i) {
    if (types[i] != (Dim == 2 ? vtk_pixel : vtk_voxel) || ends[i] != static_cast<double>((i + 1) * n_corners<Dim>))
      file.damaged("a cell is neither a square nor a cube");
    for (std::size_t c = 0; c < n_corners<Dim>; ++c)
      if (const double point = corners[i * n_corners<Dim> + c];
          point < 0 || point >= static_cast<double>(file.n_points()))
        file.damaged("a cell without points");
    LeafPlace<Dim>& place = places[i];
    place.level = static_cast<int>(levels[i]);
    if (place.level < 0 || place.level > Octree<Dim>::max_level) file.damaged("a cell's level is out of range");
    for (int k = 0; k < Dim; ++k) {
      const double corner =
          std::ldexp(positions[3 * static_cast<std::size_t>(corners[i * n_corners<Dim>]) + k], place.level);
      if (!(corner >= 0 && corner < std::ldexp(1.0, place.level) && corner == std::floor(corner)))
        file.damaged("a cell is off the lattice");
      place.corner[k] = static_cast<std::int32_t>(corner);
    }
  }
  return places;
}

// The identity where the file has none.
template <int Dim>
Similarity<Dim> pose_of(const MapFile& file) {
  Similarity<Dim> pose;
  if (!file.has_fact("pose_scale")) return pose;
  pose.scale = file.facts("pose_scale", 1)[0];
  const std::vector<double> rotation = file.facts("pose_rotation", Dim * Dim), offset = file.facts("pose_offset", Dim);
  for (int i = 0; i < Dim; ++i) {
    pose.offset[i] = offset[i];
    for (int j = 0; j < Dim; ++j) pose.rotation(i, j) = rotation[i * Dim + j];
  }
  const double error = (pose.rotation.transpose() * pose.rotation - Mat<Dim>::Identity()).norm();
  if (!(pose.scale > 0 && error < 1e-9)) file.damaged("the pose");
  return pose;
}

// Null where the file has none.
template <int Dim>
std::shared_ptr<const SurfaceBend<Dim>> bend_of(const MapFile& file) {
  if (std::ranges::none_of(std::array{"bend_sizes", "bend_vertices", "bend_facets"},
                           [&](const char* name) { return file.has_fact(name); }))
    return nullptr;
  if (Dim == 2) file.damaged("a bend in the plane");
  const std::vector<double> sizes = file.facts("bend_sizes", 2);
  for (const double size : sizes)
    if (!(size >= 1 && size <= std::numeric_limits<Index>::max() && size == std::floor(size)))
      file.damaged("bend_sizes");
  const auto n = static_cast<std::size_t>(sizes[0]), n_facets = static_cast<std::size_t>(sizes[1]);
  const auto vertices = file.values("FieldData", "bend_vertices", ValueType::float64, 2 * Dim, n);
  const auto corners = file.values("FieldData", "bend_facets", ValueType::int32, Dim, n_facets);
  Surface<Dim> surface;
  std::vector<Vec<Dim>> bent;
  for (std::size_t v = 0; v < n; ++v) {
    surface.vertices.push_back(Eigen::Map<const Vec<Dim>>(&vertices[2 * Dim * v]));
    bent.push_back(Eigen::Map<const Vec<Dim>>(&vertices[2 * Dim * v + Dim]));
  }
  for (std::size_t f = 0; f < n_facets; ++f) {
    auto& facet = surface.facets.emplace_back();
    for (std::size_t k = 0; k < Dim; ++k) {
      const double corner = corners[Dim * f + k];
      if (corner < 0 || corner >= sizes[0]) file.damaged("bend_facets");
      facet[k] = static_cast<Index>(corner);
    }
  }
  return std::make_shared<const SurfaceBend<Dim>>(std::move(surface), std::move(bent));
}

}  // namespace

template <int Dim>
Deformation<Dim> parse_deformation(const std::string& path, const std::string& bytes) {
  const MapFile file(path, bytes);
  if (const int found = dimension_of(file); found != Dim)
    throw_input_error("{}: a deformation of dimension {}, but one of dimension {} is needed", path, found, Dim);
  const std::size_t n = file.n_points();
  const std::vector<double> positions = file.values("Points", "Points", ValueType::float64, 3, n);
  const std::vector<double> phi = file.values("PointData", "phi", ValueType::float64, 3, n);
  const double scale = file.facts("placement_scale", 1)[0];
  const std::vector<double> offset = file.facts("placement_offset", Dim);
  if (!(scale > 0)) file.damaged("placement_scale");
  const Similarity<Dim> pose = pose_of<Dim>(file);
  const bool is_backward = file.has_fact("is_backward");
  if (is_backward && file.facts("is_backward", 1)[0] != 1) file.damaged("is_backward");

  const double space = file.has_fact("space") ? file.facts("space", 1)[0] : 0;
  if (space != 0 && space != 1 && space != 2) file.damaged("space");

  std::optional<Octree<Dim>> grid = rebuild_grid<Dim>(places_of<Dim>(file, positions));
  if (!grid) file.damaged("the cells are no balanced tree");
  if (n != static_cast<std::size_t>(grid->n_nodes())) file.damaged("the number of nodes");
  Deformation<Dim> result{{}, std::move(*grid), std::vector<Vec<Dim>>(n)};
  std::vector<char> is_set(n, 0);
  for (std::size_t i = 0; i < n; ++i) {
    typename Octree<Dim>::Coord coord;
    for (int k = 0; k < Dim; ++k) {
      const double x = std::ldexp(positions[3 * i + k], Octree<Dim>::max_level);
      if (!(x >= 0 && x <= std::ldexp(1.0, Octree<Dim>::max_level) && x == std::floor(x)))
        file.damaged("a node is off the lattice");
      coord[k] = static_cast<std::int32_t>(x);
    }
    const Index node = result.grid.find_node(coord);
    if (node == no_index || is_set[node]) file.damaged("a node is nobody's corner, or is there twice");
    is_set[node] = 1;
    for (int k = 0; k < Dim; ++k) result.phi[node][k] = phi[3 * i + k];
  }
  result.placement.scale = scale;
  for (int k = 0; k < Dim; ++k) result.placement.offset[k] = offset[k];
  result.pose = pose;
  result.is_backward = is_backward;
  result.space = static_cast<Space>(static_cast<int>(space));
  result.bend = bend_of<Dim>(file);
  if (result.bend && is_backward) file.damaged("a bend of a map that is backward");
  return result;
}

template <int Dim>
Deformation<Dim> read_deformation(const std::string& path_or_folder) {
  const std::string path = file_in(path_or_folder);
  return parse_deformation<Dim>(path, checked_bytes(path));
}

int deformation_dimension(const std::string& path_or_folder) {
  const std::string path = file_in(path_or_folder);
  const std::string bytes = checked_bytes(path);
  return dimension_of(MapFile(path, bytes));
}

SHELLMATCH_2D_3D(parse_deformation);
SHELLMATCH_2D_3D(read_deformation);

}  // namespace shellmatch
