#include "base/error.h"
#include "matching/output/deformation_file.h"
#include "matching/output/file_checksum.h"
#include "matching/output/process_info.h"
#include "matching/cascade/rebuild_grid.h"

#include <vtkCellData.h>
#include <vtkCellType.h>
#include <vtkDoubleArray.h>
#include <vtkErrorCode.h>
#include <vtkFieldData.h>
#include <vtkFloatArray.h>
#include <vtkIntArray.h>
#include <vtkLogger.h>
#include <vtkNew.h>
#include <vtkOutputWindow.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkSmartPointer.h>
#include <vtkStringArray.h>
#include <vtkUnstructuredGrid.h>
#include <vtkXMLUnstructuredGridReader.h>
#include <vtkXMLUnstructuredGridWriter.h>

#include <cmath>
#include <filesystem>
#include <optional>
#include <utility>

namespace shellmatch {

namespace {

constexpr const char* what_to_give = "give the deformation.vtu of an output folder, or the folder";

// While it lives, VTK's messages are noted instead of printed.
class Messages {
 public:
  Messages() : before_(vtkOutputWindow::GetInstance()), verbosity_(vtkLogger::GetCurrentVerbosityCutoff()) {
    vtkLogger::SetStderrVerbosity(vtkLogger::VERBOSITY_OFF);
    vtkOutputWindow::SetInstance(window_);
  }
  ~Messages() {
    vtkOutputWindow::SetInstance(before_);
    vtkLogger::SetStderrVerbosity(verbosity_);
  }
  Messages(const Messages&) = delete;
  Messages& operator=(const Messages&) = delete;
  bool any() const { return window_->any; }

 private:
  struct Window : vtkOutputWindow {
    vtkTypeMacro(Window, vtkOutputWindow) static Window* New() {
      auto* window = new Window;
      window->InitializeObjectBase();
      return window;
    }
    void DisplayText(const char*) override { any = true; }
    void DisplayErrorText(const char*) override { any = true; }
    void DisplayWarningText(const char*) override { any = true; }
    void DisplayGenericWarningText(const char*) override { any = true; }
    void DisplayDebugText(const char*) override {}
    bool any = false;
  };
  vtkSmartPointer<vtkOutputWindow> before_;
  vtkLogger::Verbosity verbosity_;
  vtkNew<Window> window_;
};

template <class Array>
vtkNew<Array> new_array(const std::string& name, int n_components, Eigen::Index n_tuples) {
  vtkNew<Array> array;
  array->SetName(name.c_str());
  array->SetNumberOfComponents(n_components);
  array->SetNumberOfTuples(n_tuples);
  return array;
}

// Vectors of the plane become vectors of space.
template <class Array, class Entry>
vtkNew<Array> vector_array(const std::string& name, int n_components, Index n, const Entry& entry) {
  const int written = n_components == 2 ? 3 : n_components;
  auto array = new_array<Array>(name, written, n);
  for (Index i = 0; i < n; ++i)
    for (int k = 0; k < written; ++k) array->SetTypedComponent(i, k, k < n_components ? static_cast<typename Array::ValueType>(entry(i, k)) : 0);
  return array;
}

template <int Dim>
void add_cells(const Octree<Dim>& grid, vtkUnstructuredGrid& data) {
  vtkNew<vtkIntArray> level;
  level->SetName("level");
  level->SetNumberOfTuples(static_cast<vtkIdType>(grid.leaves().size()));
  data.Allocate(static_cast<vtkIdType>(grid.leaves().size()));
  vtkIdType next = 0;
  for (const Index leaf : grid.leaves()) {
    const auto& cell = grid.cell(leaf);
    vtkIdType nodes[n_corners<Dim>];
    for (int c = 0; c < n_corners<Dim>; ++c) nodes[c] = cell.nodes[c];
    data.InsertNextCell(Dim == 2 ? VTK_PIXEL : VTK_VOXEL, n_corners<Dim>, nodes);
    level->SetValue(next++, cell.level);
  }
  data.GetCellData()->AddArray(level);
}

template <int Dim>
void add_facts(const Similarity<Dim>& placement, vtkFieldData& facts) {
  vtkNew<vtkIntArray> dimension;
  dimension->SetName("dimension");
  dimension->InsertNextValue(Dim);
  facts.AddArray(dimension);
  auto scale = new_array<vtkDoubleArray>("placement_scale", 1, 1);
  scale->SetValue(0, placement.scale);
  facts.AddArray(scale);
  auto offset = new_array<vtkDoubleArray>("placement_offset", Dim, 1);
  for (int k = 0; k < Dim; ++k) offset->SetTypedComponent(0, k, placement.offset[k]);
  facts.AddArray(offset);
  vtkNew<vtkStringArray> version;
  version->SetName("program_version");
  version->InsertNextValue(program_version());
  facts.AddArray(version);
}

std::string file_in(const std::string& path) {
  return std::filesystem::is_directory(path) ? (std::filesystem::path(path) / deformation_file_name).string()
                                             : path;
}

[[noreturn]] void damaged(const std::string& path, const char* why) {
  throw_input_error("{}: damaged, cut off, or no deformation that this program wrote ({}); {}", path, why,
                    what_to_give);
}

// VTK trusts what it reads: whatever is cut off, changed or not ours is kept from it.
vtkNew<vtkUnstructuredGrid> read_grid(const std::string& path) {
  const FileChecksum checksum = verify_checksum(path);
  if (checksum == FileChecksum::earlier)
    throw_input_error("{}: written by an earlier version of this program, whose checksums this one does not verify; match the shapes again", path);
  if (checksum != FileChecksum::matches) damaged(path, "the checksum at its end is missing or wrong");
  const Messages messages;
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

// The cells as the file has them: level and lower corner, checked to lie on the lattice.
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

}  // namespace

template <int Dim>
void write_deformation(const std::string& path, const Deformation<Dim>& deformation,
                       const std::vector<NodalField>& nodal_fields,
                       const std::vector<CellField>& cell_fields) {
  write_deformation(path, deformation.grid, deformation.phi, deformation.placement, nodal_fields, cell_fields);
}

template <int Dim>
void write_deformation(const std::string& path, const Octree<Dim>& grid, const std::vector<Vec<Dim>>& phi,
                       const Similarity<Dim>& placement, const std::vector<NodalField>& nodal_fields,
                       const std::vector<CellField>& cell_fields) {
  const Index n = grid.n_nodes();
  SHELLMATCH_CHECK(phi.size() == static_cast<std::size_t>(n), "phi has a value for each node");
  vtkNew<vtkUnstructuredGrid> data;
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  points->SetNumberOfPoints(n);
  for (Index i = 0; i < n; ++i) {
    const Vec<Dim> x = grid.node_position(i);
    points->SetPoint(i, x[0], x[1], Dim == 3 ? x[Dim - 1] : 0.0);
  }
  data->SetPoints(points);
  add_cells(grid, *data);
  data->GetPointData()->AddArray(
      vector_array<vtkDoubleArray>("phi", Dim, n, [&](Index i, int k) { return phi[i][k]; }));
  data->GetPointData()->AddArray(vector_array<vtkFloatArray>("displacement", Dim, n, [&](Index i, int k) {
    return phi[i][k] - grid.node_position(i)[k];
  }));
  for (const NodalField& field : nodal_fields) {
    const int m = field.n_components;
    SHELLMATCH_CHECK(m > 0 && field.values.size() == static_cast<std::size_t>(n) * m,
                     "a nodal field has values for each node");
    data->GetPointData()->AddArray(vector_array<vtkFloatArray>(
        field.name, m, n, [&](Index i, int k) { return field.values[static_cast<std::size_t>(i) * m + k]; }));
  }
  for (const CellField& field : cell_fields) {
    SHELLMATCH_CHECK(field.values.size() == grid.leaves().size(), "a cell field has a value for each leaf");
    data->GetCellData()->AddArray(vector_array<vtkFloatArray>(field.name, 1, static_cast<Index>(field.values.size()),
                                               [&](Index i, int) { return field.values[i]; }));
  }
  add_facts(placement, *data->GetFieldData());

  vtkNew<vtkXMLUnstructuredGridWriter> writer;
  const Messages messages;
  writer->SetFileName(path.c_str());
  writer->SetInputData(data);
  writer->SetDataModeToAppended();
  writer->EncodeAppendedDataOff();
  writer->SetCompressorTypeToZLib();
  writer->SetCompressionLevel(1);  // higher ones take four times as long for a tenth less
  writer->SetHeaderTypeToUInt64();
  if (writer->Write() == 0 || messages.any() || writer->GetErrorCode() != vtkErrorCode::NoError)
    throw_environment_error("{}: cannot be written; is the disk full or the folder read-only?", path);
  append_checksum(path);
}

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
  return result;
}

int deformation_dimension(const std::string& path) {
  const std::string file = file_in(path);
  return dimension_of(*read_grid(file), file);
}

#define SHELLMATCH_INSTANTIATE(Dim)                                                                          \
  template void write_deformation<Dim>(const std::string&, const Deformation<Dim>&,                          \
                                       const std::vector<NodalField>&, const std::vector<CellField>&);       \
  template void write_deformation<Dim>(const std::string&, const Octree<Dim>&, const std::vector<Vec<Dim>>&, \
                                       const Similarity<Dim>&, const std::vector<NodalField>&,               \
                                       const std::vector<CellField>&);                                       \
  template Deformation<Dim> read_deformation<Dim>(const std::string&)
SHELLMATCH_INSTANTIATE(2);
SHELLMATCH_INSTANTIATE(3);

}  // namespace shellmatch
