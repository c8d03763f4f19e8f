#include "base/error.h"
#include "geometry/polydata/vtk_one_thread.h"
#include "matching/map_file/deflate.h"
#include "matching/map_file/deformation_file.h"
#include "matching/output/checksum.h"
#include "matching/progress/process_info.h"

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
#include <vtkXMLUnstructuredGridWriter.h>
#include <vtkZLibDataCompressor.h>

#include <array>
#include <memory>
#include <span>

namespace shellmatch {

namespace {

/// During the lifetime of an object, VTK's messages are recorded instead of printed.
class VtkMessages {
 public:
  VtkMessages();
  ~VtkMessages();
  VtkMessages(const VtkMessages&) = delete;
  VtkMessages& operator=(const VtkMessages&) = delete;

  /// Whether there has been a message.
  bool any() const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

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

struct VtkMessages::State {
  vtkSmartPointer<vtkOutputWindow> before = vtkOutputWindow::GetInstance();
  vtkLogger::Verbosity verbosity = vtkLogger::GetCurrentVerbosityCutoff();
  vtkNew<Window> window;
};

VtkMessages::VtkMessages() : state_(std::make_unique<State>()) {
  vtkLogger::SetStderrVerbosity(vtkLogger::VERBOSITY_OFF);
  vtkOutputWindow::SetInstance(state_->window);
}

VtkMessages::~VtkMessages() {
  vtkOutputWindow::SetInstance(state_->before);
  vtkLogger::SetStderrVerbosity(state_->verbosity);
}

bool VtkMessages::any() const { return state_->window->any; }

/// VTK's file format and class name, with deflate() in place of zlib. Writing the file is a run's longest part on one
/// thread alone.
class Compressor final : public vtkZLibDataCompressor {
 public:
  static Compressor* New() {
    auto* compressor = new Compressor;
    compressor->InitializeObjectBase();
    return compressor;
  }

 protected:
  std::size_t CompressBuffer(const unsigned char* data, std::size_t size, unsigned char* to,
                             std::size_t space) override {
    return deflate({data, size}, {to, space});
  }
  std::size_t GetMaximumCompressionSpace(std::size_t size) override { return deflate_bound(size); }
};

template <class Array>
vtkNew<Array> new_array(const std::string& name, int n_components, Eigen::Index n_tuples) {
  vtkNew<Array> array;
  array->SetName(name.c_str());
  array->SetNumberOfComponents(n_components);
  array->SetNumberOfTuples(n_tuples);
  return array;
}

// An array of vectors; those of the plane get a third component, 0.
template <class Array, class Entry>
vtkNew<Array> vector_array(const std::string& name, int n_components, Index n, const Entry& entry) {
  const int written = n_components == 2 ? 3 : n_components;
  auto array = new_array<Array>(name, written, n);
  for (Index i = 0; i < n; ++i)
    for (int k = 0; k < written; ++k)
      array->SetTypedComponent(i, k, k < n_components ? static_cast<typename Array::ValueType>(entry(i, k)) : 0);
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
void add_facts(const MapFrame<Dim>& frame, vtkFieldData& facts) {
  const auto& [placement, pose, is_backward, space, bend] = frame;
  vtkNew<vtkIntArray> dimension;
  dimension->SetName("dimension");
  dimension->InsertNextValue(Dim);
  facts.AddArray(dimension);
  const auto add = [&](const char* name, std::span<const double> values) {
    auto array = new_array<vtkDoubleArray>(name, static_cast<int>(values.size()), 1);
    for (std::size_t k = 0; k < values.size(); ++k) array->SetTypedComponent(0, static_cast<int>(k), values[k]);
    facts.AddArray(array);
  };
  add("placement_scale", {&placement.scale, 1});
  add("placement_offset", {placement.offset.data(), Dim});
  if (!pose.is_identity()) {
    const Mat<Dim> row_by_row = pose.rotation.transpose();
    add("pose_scale", {&pose.scale, 1});
    add("pose_rotation", {row_by_row.data(), static_cast<std::size_t>(row_by_row.size())});
    add("pose_offset", {pose.offset.data(), Dim});
  }
  if (is_backward) add("is_backward", std::array{1.0});
  if (space != Space::unsaid) add("space", std::array{static_cast<double>(space)});
  if (bend) {
    const std::vector<Vec<Dim>>&from = bend->surface().vertices, &to = bend->bent().vertices;
    const auto& facets = bend->surface().facets;
    add("bend_sizes", std::array{static_cast<double>(from.size()), static_cast<double>(facets.size())});
    facts.AddArray(vector_array<vtkDoubleArray>("bend_vertices", 2 * Dim, static_cast<Index>(from.size()),
                                                [&](Index v, int k) { return k < Dim ? from[v][k] : to[v][k - Dim]; }));
    facts.AddArray(vector_array<vtkIntArray>("bend_facets", Dim, static_cast<Index>(facets.size()),
                                             [&](Index f, int k) { return facets[f][static_cast<std::size_t>(k)]; }));
  }
  vtkNew<vtkStringArray> version;
  version->SetName("program_version");
  version->InsertNextValue(program_version());
  facts.AddArray(version);
}

}  // namespace

template <int Dim>
void write_deformation(const std::string& path, const Deformation<Dim>& deformation,
                       const std::vector<NodalField>& nodal_fields, const std::vector<CellField>& cell_fields) {
  write_deformation<Dim>(path, deformation.grid, deformation.phi, deformation, nodal_fields, cell_fields);
}

template <int Dim>
void write_deformation(const std::string& path, const Octree<Dim>& grid, const std::vector<Vec<Dim>>& phi,
                       const MapFrame<Dim>& frame, const std::vector<NodalField>& nodal_fields,
                       const std::vector<CellField>& cell_fields) {
  const Index n = grid.n_nodes();
  SHELLMATCH_CHECK(phi.size() == static_cast<std::size_t>(n), "phi has a value for each node");
  keep_vtk_in_one_thread();
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
  data->GetPointData()->AddArray(vector_array<vtkFloatArray>(
      "displacement", Dim, n, [&](Index i, int k) { return phi[i][k] - grid.node_position(i)[k]; }));
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
  add_facts(frame, *data->GetFieldData());

  vtkNew<vtkXMLUnstructuredGridWriter> writer;
  const VtkMessages messages;
  writer->SetFileName(path.c_str());
  writer->SetInputData(data);
  writer->SetDataModeToAppended();
  writer->EncodeAppendedDataOff();
  const vtkNew<Compressor> compressor;
  writer->SetCompressor(compressor);
  writer->SetHeaderTypeToUInt64();
  if (writer->Write() == 0 || messages.any() || writer->GetErrorCode() != vtkErrorCode::NoError)
    cannot_be_written(0, fmt::format("{}: cannot be written; is the disk full or the folder read-only?", path));
  append_checksum(path);
}

#define SHELLMATCH_INSTANTIATE(Dim)                                                                                 \
  template void write_deformation<Dim>(const std::string&, const Deformation<Dim>&, const std::vector<NodalField>&, \
                                       const std::vector<CellField>&);                                              \
  template void write_deformation<Dim>(const std::string&, const Octree<Dim>&, const std::vector<Vec<Dim>>&,        \
                                       const MapFrame<Dim>&, const std::vector<NodalField>&,                        \
                                       const std::vector<CellField>&)
SHELLMATCH_INSTANTIATE(2);
SHELLMATCH_INSTANTIATE(3);
#undef SHELLMATCH_INSTANTIATE

}  // namespace shellmatch
