// Arrays in VTK's legacy files: types and names as VTK writes them.

#include "geometry/polydata/polydata.h"
#include "geometry/polydata/write_polydata.h"
#include "tests/geometry/io/files.h"

#include <vtkCellArray.h>
#include <vtkIdTypeArray.h>
#include <vtkIntArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolyDataWriter.h>
#include <vtkSignedCharArray.h>
#include <vtkSmartPointer.h>

#include <array>

namespace shellmatch::testing {
namespace {

// A triangle, with an array behind each other one, so that a wrong size would be noticed.
vtkSmartPointer<vtkPolyData> triangle(const std::vector<std::string>& names) {
  auto data = vtkSmartPointer<vtkPolyData>::New();
  vtkNew<vtkPoints> points;
  for (const auto& x : {std::array{0.0, 0.0}, {1.0, 0.0}, {0.0, 1.0}}) points->InsertNextPoint(x[0], x[1], 0);
  vtkNew<vtkCellArray> cells;
  const std::array<vtkIdType, 3> corners{0, 1, 2};
  cells->InsertNextCell(3, corners.data());
  data->SetPoints(points);
  data->SetPolys(cells);
  const std::array<vtkSmartPointer<vtkDataArray>, 3> arrays{vtkSmartPointer<vtkIdTypeArray>::New(),
                                                            vtkSmartPointer<vtkSignedCharArray>::New(),
                                                            vtkSmartPointer<vtkIntArray>::New()};
  for (std::size_t k = 0; k < arrays.size(); ++k) {
    arrays[k]->SetName(names[k].c_str());
    for (const double value : {-7.0, 0.0, 100.0}) arrays[k]->InsertNextTuple1(value + static_cast<double>(k));
    if (k == 0) data->GetPointData()->SetScalars(arrays[k]);
    else data->GetPointData()->AddArray(arrays[k]);
  }
  return data;
}

TEST(PolyDataLegacyArrays, OfTypesAndNamesThatVtkWrites) {
  for (const std::vector<std::string>& names :
       {std::vector<std::string>{"a", "b", "c"}, {"Mean Curvature", "100 %, or \"all\"", "%20"}})
    for (const bool is_binary : {false, true}) {
      vtkNew<vtkPolyDataWriter> writer;
      writer->SetInputData(triangle(names));
      if (is_binary) writer->SetFileTypeToBinary();
      writer->WriteToOutputStringOn();
      writer->Write();
      std::vector<std::string> notes;
      const OriginalShape<3> shape = read_legacy_vtk("a.vtk", writer->GetOutputStdString(), notes);
      ASSERT_EQ(shape.attributes.size(), 3u) << is_binary;
      for (std::size_t k = 0; k < 3; ++k) {
        EXPECT_EQ(shape.attributes[k].name, names[k]);
        const auto shift = static_cast<double>(k);
        EXPECT_EQ(shape.attributes[k].values, (std::vector<double>{shift - 7, shift, shift + 100})) << names[k];
      }
      EXPECT_EQ(shape.attributes[1].type, "char");
    }
}

TEST(PolyDataLegacyArrays, KeepTheirNamesAndTypes) {
  OriginalShape<3> shape = cube();
  for (const char* type : {"char", "uchar", "short", "ushort", "int", "uint", "int64", "uint64", "float", "double"})
    shape.attributes.push_back({fmt::format("{} of 100 %", type), type, {1, 2, 3, 4, 5, 6, 7, 8}});
  std::vector<std::string> notes;
  const OriginalShape<3> read = read_legacy_vtk("a.vtk", polydata_bytes(shape, PolyDataFormat::legacy), notes);
  ASSERT_EQ(read.attributes.size(), shape.attributes.size());
  for (std::size_t k = 0; k < shape.attributes.size(); ++k) {
    EXPECT_EQ(read.attributes[k].name, shape.attributes[k].name);
    EXPECT_EQ(read.attributes[k].type, shape.attributes[k].type);
    EXPECT_EQ(read.attributes[k].values, shape.attributes[k].values);
  }
}

// What is no code stays as it is.
TEST(PolyDataLegacyArrays, NamesWithAPercentSign) {
  const std::string head =
      "# vtk DataFile Version 3.0\nx\nASCII\nDATASET POLYDATA\nPOINTS 1 float\n0 0 0\nPOINT_DATA 1\nSCALARS ";
  for (const auto& [written, name] :
       {std::pair{"50%", "50%"}, {"50%2", "50%2"}, {"%zz", "%zz"}, {"%2", "%2"}, {"a%25b", "a%b"}, {"%-1", "%-1"}}) {
    std::vector<std::string> notes;
    const OriginalShape<3> shape =
        read_legacy_vtk("a.vtk", head + written + " float\nLOOKUP_TABLE default\n1\n", notes);
    ASSERT_EQ(shape.attributes.size(), 1u);
    EXPECT_EQ(shape.attributes[0].name, name);
  }
}

}  // namespace
}  // namespace shellmatch::testing
