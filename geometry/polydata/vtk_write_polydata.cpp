#include "geometry/polydata/write_polydata.h"

#include "base/error.h"
#include "geometry/polydata/vtk_one_thread.h"

#include <vtkCellArray.h>
#include <vtkDataArray.h>
#include <vtkFieldData.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolyDataWriter.h>
#include <vtkSmartPointer.h>
#include <vtkStringArray.h>
#include <vtkXMLPolyDataWriter.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace shellmatch {

namespace {

int vtk_type(const std::string& type) {
  constexpr std::pair<const char*, int> types[] = {{"char", VTK_SIGNED_CHAR}, {"uchar", VTK_UNSIGNED_CHAR},
                                                   {"short", VTK_SHORT},      {"ushort", VTK_UNSIGNED_SHORT},
                                                   {"int", VTK_INT},          {"uint", VTK_UNSIGNED_INT},
                                                   {"int64", VTK_LONG_LONG},  {"uint64", VTK_UNSIGNED_LONG_LONG},
                                                   {"float", VTK_FLOAT}};
  for (const auto& [name, number] : types)
    if (type == name) return number;
  return VTK_DOUBLE;
}

// Rounds to an integer type and clamps to its range; NaN becomes 0.
double as_value_of(const vtkDataArray& array, double value) {
  const int type = const_cast<vtkDataArray&>(array).GetDataType();
  if (type == VTK_FLOAT || type == VTK_DOUBLE) return value;
  return std::isnan(value) ? 0
                           : std::clamp(std::round(value), const_cast<vtkDataArray&>(array).GetDataTypeMin(),
                                        const_cast<vtkDataArray&>(array).GetDataTypeMax());
}

// Columns that make up one array.
struct ArrayOfColumns {
  std::string name;
  std::size_t first = 0, n = 1;
};

ArrayOfColumns array_at(const std::vector<VertexAttribute>& columns, std::size_t first) {
  const VertexAttribute& column = columns[first];
  const auto is = [&](std::size_t k, const std::string& name) {
    return first + k < columns.size() && columns[first + k].name == name && columns[first + k].type == column.type;
  };
  if (column.type == "uchar" && is(0, "red") && is(1, "green") && is(2, "blue"))
    return is(3, "alpha") ? ArrayOfColumns{"RGBA", first, 4} : ArrayOfColumns{"RGB", first, 3};
  if (!column.name.ends_with("_0")) return {column.name, first, 1};
  const std::string stem = column.name.substr(0, column.name.size() - 2);
  ArrayOfColumns array{stem, first, 1};
  while (is(array.n, fmt::format("{}_{}", stem, array.n))) ++array.n;
  return array.n > 1 ? array : ArrayOfColumns{column.name, first, 1};
}

vtkSmartPointer<vtkDataArray> data_array(const OriginalShape<3>& shape, const ArrayOfColumns& columns) {
  auto array = vtkSmartPointer<vtkDataArray>::Take(
      vtkDataArray::CreateDataArray(vtk_type(shape.attributes[columns.first].type)));
  array->SetName(columns.name.c_str());
  array->SetNumberOfComponents(static_cast<int>(columns.n));
  array->SetNumberOfTuples(static_cast<vtkIdType>(shape.vertices.size()));
  for (std::size_t c = 0; c < columns.n; ++c)
    for (std::size_t v = 0; v < shape.vertices.size(); ++v)
      array->SetComponent(static_cast<vtkIdType>(v), static_cast<int>(c),
                          as_value_of(*array, shape.attributes[columns.first + c].values[v]));
  return array;
}

vtkSmartPointer<vtkPolyData> polydata_of(const OriginalShape<3>& shape) {
  auto data = vtkSmartPointer<vtkPolyData>::New();
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  points->SetNumberOfPoints(static_cast<vtkIdType>(shape.vertices.size()));
  for (std::size_t v = 0; v < shape.vertices.size(); ++v)
    points->SetPoint(static_cast<vtkIdType>(v), shape.vertices[v].data());
  data->SetPoints(points);
  vtkNew<vtkCellArray> cells;
  const bool has_polygons = !shape.polygons.empty();
  for (const std::vector<Index>& polygon : shape.polygons) {
    cells->InsertNextCell(static_cast<int>(polygon.size()));
    for (const Index v : polygon) cells->InsertCellPoint(v);
  }
  // Programs show points only where they are cells.
  for (std::size_t v = 0; !has_polygons && v < shape.vertices.size(); ++v) {
    const auto point = static_cast<vtkIdType>(v);
    cells->InsertNextCell(1, &point);
  }
  if (has_polygons) data->SetPolys(cells);
  else data->SetVerts(cells);
  for (std::size_t first = 0; first < shape.attributes.size();) {
    const ArrayOfColumns columns = array_at(shape.attributes, first);
    if (shape.attributes[first].type != "text") data->GetPointData()->AddArray(data_array(shape, columns));
    first += columns.n;
  }
  return data;
}

}  // namespace

std::string polydata_bytes(const OriginalShape<3>& shape, PolyDataFormat format) {
  keep_vtk_in_one_thread();
  const vtkSmartPointer<vtkPolyData> data = polydata_of(shape);
  const std::string space(space_name(shape.space));
  if (format == PolyDataFormat::legacy) {
    vtkNew<vtkPolyDataWriter> writer;
    writer->SetInputData(data);
    writer->SetHeader(space.empty() ? "shellmatch" : ("shellmatch SPACE=" + space).c_str());
    writer->SetFileTypeToBinary();
    writer->SetFileVersion(vtkDataWriter::VTK_LEGACY_READER_VERSION_4_2);  // other programs read no version 5
    writer->WriteToOutputStringOn();
    if (writer->Write() == 0) throw_environment_error("VTK could not write the mesh; is there enough memory?");
    return writer->GetOutputStdString();
  }
  if (!space.empty()) {
    vtkNew<vtkStringArray> name;
    name->SetName("SPACE");
    name->InsertNextValue(space);
    data->GetFieldData()->AddArray(name);
  }
  vtkNew<vtkXMLPolyDataWriter> writer;
  writer->SetInputData(data);
  writer->SetHeaderTypeToUInt64();
  writer->SetDataModeToAppended();
  writer->EncodeAppendedDataOff();
  writer->WriteToOutputStringOn();
  if (writer->Write() == 0) throw_environment_error("VTK could not write the mesh; is there enough memory?");
  return writer->GetOutputString();
}

}  // namespace shellmatch
