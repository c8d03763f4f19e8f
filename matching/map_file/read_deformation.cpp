#include "base/error.h"
#include "grid/octree/rebuild_grid.h"
#include "matching/map_file/deformation_file.h"
#include "matching/map_file/vtk_messages.h"
#include "matching/output/file_checksum.h"

#include <vtkCellData.h>
#include <vtkCellType.h>
#include <vtkDoubleArray.h>
#include <vtkErrorCode.h>
#include <vtkFieldData.h>
#include <vtkIntArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkUnstructuredGrid.h>
#include <vtkXMLUnstructuredGridReader.h>

#include <cmath>
#include <filesystem>
#include <optional>
#include <utility>

namespace shellmatch {

namespace {

constexpr const char* what_to_give = "give the deformation.vtu of an output folder, or the folder";

std::string file_in(const std::string& path) {
  return std::filesystem::is_directory(path) ? (std::filesystem::path(path) / deformation_file_name).string()
                                             : path;
}

[[noreturn]] void damaged(const std::string& path, const char* why) {
  throw_input_error("{}: damaged, cut off, or no deformation that this program wrote ({}); {}", path, why,
                    what_to_give);
}

// Refuses files that are cut off, changed or not written by this program before VTK reads them, as VTK does not check.
vtkNew<vtkUnstructuredGrid> read_grid(const std::string& path) {
  const FileChecksum checksum = verify_checksum(path);
  if (checksum == FileChecksum::earlier)
    throw_input_error("{}: written by an earlier version of this program, whose checksums this one does not verify; match the shapes again", path);
  if (checksum != FileChecksum::matches) damaged(path, "the checksum at its end is missing or wrong");
  const VtkMessages messages;
  vtkNew<vtkXMLUnstructuredGridReader> reader;
  reader->SetFileName(path.c_str());
  reader->Update();
  if (messages.any() || reader->GetErrorCode() != vtkErrorCode::NoError)
    damaged(path, "it cannot be decoded");
  vtkNew<vtkUnstructuredGrid> data;
  data->ShallowCopy(reader->GetOutput());
  return data;
}

int dimension_of(vtkUnstructuredGrid& data, const std::string& path) {
  auto* dimension = vtkIntArray::SafeDownCast(data.GetFieldData()->GetAbstractArray("dimension"));
  if (!dimension || dimension->GetNumberOfValues() != 1) damaged(path, "no field data named dimension");
  const int value = dimension->GetValue(0);
  if (value != 2 && value != 3) damaged(path, "the dimension is neither 2 nor 3");
  return value;
}

vtkDoubleArray& doubles(vtkFieldData& data, const char* name, int n_components, vtkIdType n,
                        const std::string& path) {
  auto* array = vtkDoubleArray::SafeDownCast(data.GetAbstractArray(name));
  if (!array || array->GetNumberOfComponents() != n_components || array->GetNumberOfTuples() != n)
    damaged(path, name);
  for (vtkIdType i = 0; i < array->GetNumberOfValues(); ++i)
    if (!std::isfinite(array->GetValue(i))) damaged(path, name);
  return *array;
}

// Level and lower corner of the cells in the file, checked to lie on the lattice.
template <int Dim>
std::vector<LeafPlace<Dim>> places_of(vtkUnstructuredGrid& data, const std::string& path) {
  auto* levels = vtkIntArray::SafeDownCast(data.GetCellData()->GetArray("level"));
  const vtkIdType n = data.GetNumberOfCells();
  if (!levels || levels->GetNumberOfValues() != n || n == 0) damaged(path, "cell data level");
  std::vector<LeafPlace<Dim>> places(static_cast<std::size_t>(n));
  for (vtkIdType i = 0; i < n; ++i) {
    vtkIdType n_points;
    const vtkIdType* points;
    data.GetCellPoints(i, n_points, points);
    if (data.GetCellType(i) != (Dim == 2 ? VTK_PIXEL : VTK_VOXEL) || n_points != n_corners<Dim>)
      damaged(path, "a cell is neither a square nor a cube");
    if (points[0] < 0 || points[0] >= data.GetNumberOfPoints()) damaged(path, "a cell without points");
    LeafPlace<Dim>& place = places[static_cast<std::size_t>(i)];
    place.level = levels->GetValue(i);
    if (place.level < 0 || place.level > Octree<Dim>::max_level)
      damaged(path, "a cell's level is out of range");
    double position[3];
    data.GetPoint(points[0], position);
    for (int k = 0; k < Dim; ++k) {
      const double corner = std::ldexp(position[k], place.level);
      if (!(corner >= 0 && corner < std::ldexp(1.0, place.level) && corner == std::floor(corner)))
        damaged(path, "a cell is off the lattice");
      place.corner[k] = static_cast<std::int32_t>(corner);
    }
  }
  return places;
}

// The identity where the file has none.
template <int Dim>
Similarity<Dim> pose_of(vtkUnstructuredGrid& data, const std::string& path) {
  Similarity<Dim> pose;
  if (!data.GetFieldData()->HasArray("pose_scale")) return pose;
  vtkDoubleArray& scale = doubles(*data.GetFieldData(), "pose_scale", 1, 1, path);
  vtkDoubleArray& rotation = doubles(*data.GetFieldData(), "pose_rotation", Dim * Dim, 1, path);
  vtkDoubleArray& offset = doubles(*data.GetFieldData(), "pose_offset", Dim, 1, path);
  pose.scale = scale.GetValue(0);
  for (int i = 0; i < Dim; ++i) {
    pose.offset[i] = offset.GetTypedComponent(0, i);
    for (int j = 0; j < Dim; ++j) pose.rotation(i, j) = rotation.GetTypedComponent(0, i * Dim + j);
  }
  const double error = (pose.rotation.transpose() * pose.rotation - Mat<Dim>::Identity()).norm();
  if (!(pose.scale > 0 && std::isfinite(pose.scale) && pose.offset.allFinite() && error < 1e-9)) damaged(path, "the pose");
  return pose;
}

}  // namespace

template <int Dim>
Deformation<Dim> read_deformation(const std::string& path_or_folder) {
  const std::string path = file_in(path_or_folder);
  const vtkNew<vtkUnstructuredGrid> data = read_grid(path);
  if (const int found = dimension_of(*data, path); found != Dim)
    throw_input_error("{}: a deformation of dimension {}, but one of dimension {} is needed", path, found,
                      Dim);
  const vtkIdType n = data->GetNumberOfPoints();
  vtkDoubleArray& phi = doubles(*data->GetPointData(), "phi", 3, n, path);
  vtkDoubleArray& scale = doubles(*data->GetFieldData(), "placement_scale", 1, 1, path);
  vtkDoubleArray& offset = doubles(*data->GetFieldData(), "placement_offset", Dim, 1, path);
  if (!(scale.GetValue(0) > 0)) damaged(path, "placement_scale");
  const Similarity<Dim> pose = pose_of<Dim>(*data, path);

  std::optional<Octree<Dim>> grid = rebuild_grid<Dim>(places_of<Dim>(*data, path));
  if (!grid) damaged(path, "the cells are no balanced tree");
  if (n != grid->n_nodes()) damaged(path, "the number of nodes");
  Deformation<Dim> result{std::move(*grid), std::vector<Vec<Dim>>(static_cast<std::size_t>(n)), {}};
  std::vector<char> is_set(static_cast<std::size_t>(n), 0);
  for (vtkIdType i = 0; i < n; ++i) {
    double position[3];
    data->GetPoint(i, position);
    typename Octree<Dim>::Coord coord;
    for (int k = 0; k < Dim; ++k) {
      const double x = std::ldexp(position[k], Octree<Dim>::max_level);
      if (!(x >= 0 && x <= std::ldexp(1.0, Octree<Dim>::max_level) && x == std::floor(x)))
        damaged(path, "a node is off the lattice");
      coord[k] = static_cast<std::int32_t>(x);
    }
    const Index node = result.grid.find_node(coord);
    if (node == no_index || is_set[node]) damaged(path, "a node is nobody's corner, or is there twice");
    is_set[node] = 1;
    for (int k = 0; k < Dim; ++k) result.phi[node][k] = phi.GetTypedComponent(i, k);
  }
  result.placement.scale = scale.GetValue(0);
  for (int k = 0; k < Dim; ++k) result.placement.offset[k] = offset.GetTypedComponent(0, k);
  result.pose = pose;
  return result;
}

int deformation_dimension(const std::string& path) {
  const std::string file = file_in(path);
  return dimension_of(*read_grid(file), file);
}

template Deformation<2> read_deformation<2>(const std::string&);
template Deformation<3> read_deformation<3>(const std::string&);

}  // namespace shellmatch
