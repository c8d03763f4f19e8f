// VTK's formats of polygonal data: what VTK itself writes is read, what is written VTK reads, and damage is said in one
// line.

#include "geometry/io/read_shape.h"
#include "geometry/io/write_shape.h"
#include "geometry/polydata/polydata.h"
#include "geometry/polydata/write_polydata.h"
#include "tests/geometry/io/files.h"
#include "tests/support/expect_input_error.h"

#include <fmt/ranges.h>
#include <gtest/gtest.h>
#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkDoubleArray.h>
#include <vtkFloatArray.h>
#include <vtkLongLongArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolyDataReader.h>
#include <vtkPolyDataWriter.h>
#include <vtkSmartPointer.h>
#include <vtkStringArray.h>
#include <vtkUnsignedCharArray.h>
#include <vtkXMLPolyDataReader.h>
#include <vtkXMLPolyDataWriter.h>

#include <random>

namespace shellmatch {
namespace {

using testing::contains;
using testing::cube;
using testing::has_note;
using testing::TempFolder;

OriginalShape<3> read_bytes(const std::string& name, const std::string& bytes,
                            std::vector<std::string>* notes = nullptr) {
  std::vector<std::string> own;
  return name.ends_with(".vtk") ? read_legacy_vtk(name, bytes, notes ? *notes : own)
                                : read_vtp(name, bytes, notes ? *notes : own);
}

/// The cube with point data of several types, cell data, normals and texts, a strip in place of two quads, and a line.
vtkSmartPointer<vtkPolyData> full_cube() {
  const OriginalShape<3> shape = cube();
  auto data = vtkSmartPointer<vtkPolyData>::New();
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  for (const Vec<3>& x : shape.vertices) points->InsertNextPoint(x.x(), x.y(), x.z() + 1.0 / 3);
  data->SetPoints(points);
  vtkNew<vtkCellArray> polygons, strips, lines;
  const auto add = [](vtkCellArray& cells, std::initializer_list<vtkIdType> corners) {
    cells.InsertNextCell(static_cast<vtkIdType>(corners.size()), corners.begin());
  };
  for (std::size_t f = 0; f + 2 < shape.polygons.size(); ++f) {
    const auto& p = shape.polygons[f];
    add(*polygons, {p[0], p[1], p[2], p[3]});
  }
  add(*strips, {6, 2, 4, 0});
  add(*strips, {3, 7, 1, 5});
  add(*lines, {0, 7});
  data->SetPolys(polygons);
  data->SetStrips(strips);
  data->SetLines(lines);
  vtkNew<vtkFloatArray> thickness, normals;
  vtkNew<vtkDoubleArray> velocity;
  vtkNew<vtkUnsignedCharArray> colours;
  vtkNew<vtkLongLongArray> ids;
  vtkNew<vtkStringArray> texts;
  thickness->SetName("thickness");
  velocity->SetName("velocity");
  velocity->SetNumberOfComponents(3);
  colours->SetName("RGB");
  colours->SetNumberOfComponents(3);
  normals->SetName("Normals");
  normals->SetNumberOfComponents(3);
  ids->SetName("ids");
  texts->SetName("texts");
  for (int i = 0; i < 8; ++i) {
    thickness->InsertNextValue(0.5f * static_cast<float>(i));
    velocity->InsertNextTuple3(i, 0.1, -i);
    colours->InsertNextTuple3(i, 100, 255);
    normals->InsertNextTuple3(0, 0, 1);
    ids->InsertNextValue(1000000000000 + i);
    texts->InsertNextValue(i == 3 ? "a b\nc" : std::string(static_cast<std::size_t>(i * 30), 'x'));
  }
  for (vtkAbstractArray* array : std::initializer_list<vtkAbstractArray*>{thickness, texts, velocity, colours, ids})
    data->GetPointData()->AddArray(array);
  data->GetPointData()->SetNormals(normals);
  vtkNew<vtkFloatArray> of_cells;
  of_cells->SetName("of_cells");
  for (int i = 0; i < 7; ++i) of_cells->InsertNextValue(7);
  data->GetCellData()->AddArray(of_cells);
  return data;
}

void expect_full_cube(const OriginalShape<3>& shape, const std::vector<std::string>& notes) {
  ASSERT_EQ(shape.vertices.size(), 8u);
  EXPECT_LT((shape.vertices[6] - Vec<3>(0, 1, 1 + 1.0 / 3)).norm(), 1e-5);  // text has six digits
  ASSERT_EQ(shape.polygons.size(), 8u);                                     // 4 quads, 4 triangles of the strips
  EXPECT_EQ(shape.polygons[0], (std::vector<Index>{0, 2, 3, 1}));
  EXPECT_EQ(shape.polygons[4], (std::vector<Index>{6, 2, 4}));
  EXPECT_EQ(shape.polygons[5], (std::vector<Index>{4, 2, 0}));
  std::vector<std::string> names;
  for (const VertexAttribute& a : shape.attributes) names.push_back(a.name + " " + a.type);
  std::ranges::sort(names);
  EXPECT_EQ(names, (std::vector<std::string>{"blue uchar", "green uchar", "ids int64", "red uchar", "thickness float",
                                             "velocity_0 double", "velocity_1 double", "velocity_2 double"}));
  for (const VertexAttribute& a : shape.attributes) ASSERT_EQ(a.values.size(), 8u);
  const auto value = [&](const std::string& name, std::size_t v) {
    const auto at = std::ranges::find(shape.attributes, name, &VertexAttribute::name);
    return at == shape.attributes.end() ? -1 : at->values[v];
  };
  EXPECT_EQ(value("thickness", 5), 2.5);
  EXPECT_EQ(value("velocity_1", 5), 0.1);
  EXPECT_EQ(value("velocity_2", 5), -5);
  EXPECT_EQ(value("ids", 7), 1e12 + 7);
  EXPECT_EQ(value("blue", 7), 255);
  const std::string all = fmt::format("{}", fmt::join(notes, "; "));
  EXPECT_TRUE(contains(all, "1 line ignored"));
  EXPECT_TRUE(contains(all, "vertex normals dropped"));
  EXPECT_TRUE(contains(all, "point data 'texts'"));
  EXPECT_TRUE(contains(all, "cell data dropped"));
  const Shape<3> closed = [&] {
    TempFolder folder;
    write_ply(folder.path("a.ply"), shape);
    return read_mesh(folder.path("a.ply"));
  }();
  EXPECT_NEAR(testing::volume(closed.surface), 1, 1e-9);
}

TEST(PolyDataFiles, LegacyFilesThatVtkWritesAreRead) {
  for (const bool is_binary : {false, true})
    for (const int version : {42, 51}) {
      SCOPED_TRACE(fmt::format("{} {}", is_binary, version));
      vtkNew<vtkPolyDataWriter> writer;
      writer->SetInputData(full_cube());
      writer->SetHeader("3D Slicer output. SPACE=LPS");
      if (is_binary) writer->SetFileTypeToBinary();
      writer->SetFileVersion(version);
      writer->WriteToOutputStringOn();
      ASSERT_EQ(writer->Write(), 1);
      std::vector<std::string> notes;
      const OriginalShape<3> shape = read_bytes("a.vtk", writer->GetOutputStdString(), &notes);
      EXPECT_EQ(shape.space, Space::lps);
      expect_full_cube(shape, notes);
    }
}

TEST(PolyDataFiles, XmlFilesThatVtkWritesAreRead) {
  vtkNew<vtkXMLPolyDataWriter> writer;
  const auto data = full_cube();
  vtkNew<vtkStringArray> space;
  space->SetName("SPACE");
  space->InsertNextValue("LPS");
  data->GetFieldData()->AddArray(space);
  writer->SetInputData(data);
  writer->WriteToOutputStringOn();
  for (const int mode : {vtkXMLWriter::Ascii, vtkXMLWriter::Binary, vtkXMLWriter::Appended})
    for (const bool is_raw : {false, true})
      for (const bool is_packed : {false, true})
        for (const bool is_long : {false, true})
          for (const bool is_big : {false, true}) {
            SCOPED_TRACE(fmt::format("{} {} {} {} {}", mode, is_raw, is_packed, is_long, is_big));
            writer->SetDataMode(mode);
            writer->SetEncodeAppendedData(is_raw ? 0 : 1);
            writer->SetCompressorType(is_packed ? vtkXMLWriter::ZLIB : vtkXMLWriter::NONE);
            writer->SetHeaderType(is_long ? vtkXMLWriter::UInt64 : vtkXMLWriter::UInt32);
            writer->SetByteOrder(is_big ? vtkXMLWriter::BigEndian : vtkXMLWriter::LittleEndian);
            ASSERT_EQ(writer->Write(), 1);
            std::vector<std::string> notes;
            const OriginalShape<3> shape = read_bytes("a.vtp", writer->GetOutputString(), &notes);
            EXPECT_EQ(shape.space, Space::lps);
            expect_full_cube(shape, notes);
          }
  writer->SetCompressorTypeToLZ4();
  writer->Write();
  expect_input_error([&] { read_bytes("a.vtp", writer->GetOutputString()); },
                     {"a.vtp", "vtkLZ4DataCompressor", "zlib"});
}

OriginalShape<3> coloured_cube() {
  OriginalShape<3> shape = cube();
  for (Vec<3>& x : shape.vertices) x.x() += 1.0 / 3;
  shape.space = Space::ras;
  const char* types[][2] = {{"v_0", "float"},   {"v_1", "float"},  {"label", "short"}, {"red", "uchar"},
                            {"green", "uchar"}, {"blue", "uchar"}, {"w_0", "double"},  {"ids", "int64"}};
  for (const auto& [name, type] : types) {
    VertexAttribute column{name, type, {}};
    for (int i = 0; i < 8; ++i) column.values.push_back(10 * i + static_cast<double>(shape.attributes.size()));
    shape.attributes.push_back(column);
  }
  return shape;
}

TEST(PolyDataFiles, WhatIsWrittenIsReadBack) {
  const OriginalShape<3> shape = coloured_cube();
  TempFolder folder;
  for (const char* name : {"a.vtk", "a.vtp"}) {
    SCOPED_TRACE(name);
    write_shape(folder.path(name), shape);
    const OriginalShape<3> read = read_points_or_mesh_3d(folder.path(name));
    EXPECT_EQ(read.vertices, shape.vertices);
    EXPECT_EQ(read.polygons, shape.polygons);
    EXPECT_EQ(read.space, Space::ras);
    ASSERT_EQ(read.attributes.size(), shape.attributes.size());
    for (std::size_t a = 0; a < read.attributes.size(); ++a) {
      EXPECT_EQ(read.attributes[a].name, shape.attributes[a].name);
      EXPECT_EQ(read.attributes[a].type, shape.attributes[a].type);
      EXPECT_EQ(read.attributes[a].values, shape.attributes[a].values);
    }
    EXPECT_NEAR(testing::volume(read_mesh(folder.path(name)).surface), 1, 1e-12);
  }
}

TEST(PolyDataFiles, VtkReadsWhatIsWritten) {
  TempFolder folder;
  write_shape(folder.path("a.vtk"), coloured_cube());
  write_shape(folder.path("a.vtp"), coloured_cube());
  vtkNew<vtkPolyDataReader> legacy;
  legacy->SetFileName(folder.path("a.vtk").c_str());
  legacy->Update();
  vtkNew<vtkXMLPolyDataReader> xml;
  xml->SetFileName(folder.path("a.vtp").c_str());
  xml->Update();
  EXPECT_STREQ(legacy->GetHeader(), "shellmatch SPACE=RAS");
  for (vtkPolyData* data : {legacy->GetOutput(), xml->GetOutput()}) {
    EXPECT_EQ(data->GetNumberOfPoints(), 8);
    EXPECT_EQ(data->GetNumberOfPolys(), 6);
    ASSERT_NE(data->GetPointData()->GetArray("v"), nullptr);
    EXPECT_EQ(data->GetPointData()->GetArray("v")->GetNumberOfComponents(), 2);
    EXPECT_EQ(data->GetPointData()->GetArray("RGB")->GetNumberOfComponents(), 3);
    EXPECT_EQ(data->GetPointData()->GetArray("w_0")->GetNumberOfComponents(), 1);
    EXPECT_EQ(data->GetPointData()->GetArray("label")->GetDataType(), VTK_SHORT);
  }
}

TEST(PolyDataFiles, UnstructuredGridsOfPolygonsAreSurfaces) {
  const std::string head =
      "# vtk DataFile Version 3.0\nt\nASCII\nDATASET UNSTRUCTURED_GRID\nPOINTS 4 float\n0 0 0 1 0 0 0 1 0 1 1 0\n";
  const OriginalShape<3> shape =
      read_bytes("a.vtk", head + "CELLS 3 13\n3 0 1 2\n4 0 1 2 3\n3 1 3 2\nCELL_TYPES 3\n5 8 7\n");
  EXPECT_EQ(shape.polygons, (std::vector<std::vector<Index>>{{0, 1, 2}, {0, 1, 3, 2}, {1, 3, 2}}));
  expect_input_error([&] { read_bytes("a.vtk", head + "CELLS 1 5\n4 0 1 2 3\nCELL_TYPES 1\n10\n"); },
                     {"a.vtk", "type 10", "Extract Surface"});
  expect_input_error([&] { read_bytes("a.vtk", head + "CELLS 1 5\n4 0 1 2 3\nCELL_TYPES 2\n5 5\n"); },
                     {"1 cells, but 2 types"});
}

TEST(PolyDataFiles, DamagedLegacyFilesAreRefusedInOneLine) {
  const std::string head = "# vtk DataFile Version 3.0\nt\nASCII\nDATASET POLYDATA\n",
                    points = head + "POINTS 3 float\n0 0 0 1 0 0 0 1 0\n";
  const auto refused = [](const std::string& text, std::initializer_list<std::string> parts) {
    SCOPED_TRACE(text.substr(0, 200));
    expect_input_error([&] { read_bytes("a.vtk", text); }, parts);
  };
  refused("solid a", {"a.vtk", "starts with '# vtk DataFile Version'"});
  refused("# vtk DataFile Version 3.0\nt\nASCII\nDATASET STRUCTURED_POINTS\n",
          {"line 4", "STRUCTURED_POINTS", "POLYDATA"});
  refused(head, {"no points in it"});
  refused(head + "POINTS 1000000000000 float\n0 0 0", {"1000000000000 points are more"});
  refused(head + "POINTS 1000000 float\n0 0 0", {"line 5", "cut off", "do not fit"});
  refused(head + "POINTS 3 float\n0 0 0 1 0 0 0 1", {"line 6", "cut off: 8 of 9"});
  refused(head + "POINTS 1 float\n0 zero 0", {"line 6", "'zero'"});
  refused(head + "POINTS 1 float\n0 nan 0", {"vertex 0", "not finite"});
  refused(head + "POINTS 1 quad\n0 0 0", {"'quad'"});
  refused(points + "POLYGONS 1 4\n3 0 1 3\n", {"names vertex 3", "there are 3 vertices"});
  refused(points + "POLYGONS 1 4\n3 0 1 -1\n", {"names vertex -1"});
  refused(points + "POLYGONS 1 4\n3 0 1 1.5\n", {"names vertex 1.5"});
  refused(points + "POLYGONS 1 4\n9 0 1 2\n", {"cell 0 has 9 corners"});
  refused(points + "POLYGONS 1 5\n3 0 1 2 7\n", {"take 4 of the 5"});
  refused(points + "POLYGONS 99999999999 4\n3 0 1 2\n", {"cell 1 has -1 corners"});
  refused(points + "POLYGONS 2 3\nOFFSETS vtktypeint64\n0 4\nCONNECTIVITY vtktypeint64\n0 1 2\n",
          {"a cell ends at 4 of 3 corners"});
  refused(points + "POLYGONS 3 3\nOFFSETS vtktypeint64\n0 3 2\nCONNECTIVITY vtktypeint64\n0 1 2\n",
          {"a cell ends at 2"});
  refused(points + "POINT_DATA 4\n", {"POINT_DATA of 4 points, but there are 3"});
  refused(points + "POINT_DATA 3\nSCALARS a float 99999\nLOOKUP_TABLE default\n1", {"99999 components"});
  refused(points + "POINT_DATA 3\nFIELD f 1\na 1 4 float\n1 2 3 4\n", {"'a' has 4 tuples, but there are 3 points"});
  refused(points + "POINT_DATA 3\nFIELD f 100000000000\na 1 3 float\n1 2 3\n", {"1 of 100000000000 arrays"});
  refused(points + "NONSENSE\n", {"line 7", "unknown word 'NONSENSE'"});
  const std::string binary = "# vtk DataFile Version 3.0\nt\nBINARY\nDATASET POLYDATA\nPOINTS 3 double\n";
  refused(binary + std::string(71, '\0'), {"byte", "cut off: 9 coordinates"});
  refused(binary + std::string(72, '\xff'), {"vertex 0", "not finite"});
}

TEST(PolyDataFiles, FilesWithoutFacesSayWhatTheyHold) {
  TempFolder folder;
  const std::string head =
      "# vtk DataFile Version 3.0\nt\nASCII\nDATASET POLYDATA\nPOINTS 3 float\n0 0 0 1 0 0 0 1 0\n";
  for (const std::string& cells :
       {std::string("LINES 1 4\n3 0 1 2\n"), std::string("VERTICES 1 2\n1 0\n"), std::string()}) {
    const std::string path = folder.write("a.vtk", head + cells);
    expect_input_error([&] { read_mesh(path); }, {"a.vtk", "no faces, only 3 vertices"});
    EXPECT_EQ(read_points_or_mesh_3d(path).vertices.size(), 3u);
  }
}

std::string vtp(const std::string& inside, const std::string& root = "type=\"PolyData\"") {
  return "<?xml version=\"1.0\"?><VTKFile " + root + "><PolyData>" + inside + "</PolyData></VTKFile>";
}

TEST(PolyDataFiles, DamagedXmlFilesAreRefusedInOneLine) {
  const std::string points =
      "<Points><DataArray type=\"Float32\" NumberOfComponents=\"3\" format=\"ascii\">0 0 0 1 0 0 0 1 "
      "0</DataArray></Points>";
  const auto polys = [](const std::string& corners, const std::string& ends) {
    return "<Polys><DataArray type=\"Int32\" Name=\"connectivity\" format=\"ascii\">" + corners +
           "</DataArray><DataArray type=\"Int32\" Name=\"offsets\" format=\"ascii\">" + ends + "</DataArray></Polys>";
  };
  const auto piece = [](const std::string& inside, const std::string& n = "3") {
    return vtp("<Piece NumberOfPoints=\"" + n + "\" NumberOfPolys=\"1\">" + inside + "</Piece>");
  };
  const auto refused = [](const std::string& text, std::initializer_list<std::string> parts) {
    SCOPED_TRACE(text);
    expect_input_error([&] { read_bytes("a.vtp", text); }, parts);
  };
  EXPECT_EQ(read_bytes("a.vtp", piece(points + polys("0 1 2", "3"))).polygons.size(), 1u);
  refused("", {"a.vtp", "no XML"});
  refused(vtp("", "type=\"UnstructuredGrid\""), {"'UnstructuredGrid'", "Extract Surface"});
  refused(vtp(""), {"no points in it"});
  refused(piece(""), {"Points has no array"});
  refused(piece(points), {"Polys has no array offsets"});
  refused(piece(points + polys("0 1 2", "3"), "1000000000000"), {"3000000000000 values do not fit"});
  refused(piece(points + polys("0 1 2", "3"), "99999999999999999999"), {"NumberOfPoints"});
  refused(piece(points + polys("0 1 3", "3")), {"names vertex 3"});
  refused(piece(points + polys("0 1 2", "4")), {"4 values do not fit"});
  refused(piece(points + polys("0  1  2", "4")), {"3 of 4 values"});
  refused(piece(points + polys("0 1 2", "1e300")), {"the offsets of Polys"});
  refused(piece(points + polys("0 1 2", "-1")), {"the offsets of Polys"});
  refused(piece(points + polys("0 1 x", "3")), {"'connectivity'", "'x' is no number"});
  std::string appended =
      piece("<Points><DataArray type=\"Float64\" NumberOfComponents=\"3\" format=\"appended\" offset=\"0\"/></Points>");
  refused(appended, {"appended is missing"});
  appended.insert(appended.find("</VTKFile>"), "<AppendedData encoding=\"raw\">_" + std::string("\x48\0\0\0", 4) +
                                                   std::string(70, '\0') + "</AppendedData>");
  EXPECT_NO_THROW(
      read_bytes("a.vtp", vtp("<Piece NumberOfPoints=\"0\"/><Piece NumberOfPoints=\"3\">" + points + "</Piece>")));
  refused(appended.substr(0, appended.find('_') + 20), {"cut off"});
  refused(appended, {"Polys has no array"});
  // A block that is said to expand to what no block of its size can.
  std::string packed =
      piece("<Points><DataArray type=\"Float64\" NumberOfComponents=\"3\" format=\"appended\" offset=\"0\"/></Points>",
            "10000000");
  packed.replace(packed.find("type=\"PolyData\""), 15, "type=\"PolyData\" compressor=\"vtkZLibDataCompressor\"");
  packed.insert(packed.find("</VTKFile>"), "<AppendedData encoding=\"raw\">_" +
                                               std::string("\1\0\0\0\0\x1c\x4e\x0e\0\0\0\0\x20\0\0\0", 16) +
                                               std::string(32, 'x') + "</AppendedData>");
  refused(packed, {"damaged", "cut off"});
}

// Each prefix and many changes are read or refused, never anything else.
TEST(PolyDataFiles, CutAndChangedFilesAreReadOrRefused) {
  std::vector<std::pair<std::string, std::string>> files;
  vtkNew<vtkPolyDataWriter> legacy;
  legacy->SetInputData(full_cube());
  legacy->WriteToOutputStringOn();
  for (const bool is_binary : {false, true}) {
    if (is_binary) legacy->SetFileTypeToBinary();
    legacy->Write();
    files.emplace_back("a.vtk", legacy->GetOutputStdString());
  }
  vtkNew<vtkXMLPolyDataWriter> xml;
  xml->SetInputData(full_cube());
  xml->WriteToOutputStringOn();
  for (const int mode : {vtkXMLWriter::Ascii, vtkXMLWriter::Appended}) {
    xml->SetDataMode(mode);
    xml->EncodeAppendedDataOff();
    xml->Write();
    files.emplace_back("a.vtp", xml->GetOutputString());
  }
  std::mt19937 random(7);
  for (const auto& [name, bytes] : files) {
    const auto attempt = [&](const std::string& changed) {
      try {
        const OriginalShape<3> shape = read_bytes(name, changed);
        for (const auto& polygon : shape.polygons)
          for (const Index v : polygon) ASSERT_TRUE(v >= 0 && static_cast<std::size_t>(v) < shape.vertices.size());
        for (const VertexAttribute& a : shape.attributes) ASSERT_EQ(a.values.size(), shape.vertices.size());
      } catch (const InputError&) {
      }
    };
    for (std::size_t n = 0; n < bytes.size(); n += 7) attempt(bytes.substr(0, n));
    for (int k = 0; k < 2000; ++k) {
      std::string changed = bytes;
      for (int i = 0; i < 3; ++i)
        changed[random() % changed.size()] = static_cast<char>(k % 2 ? random() : '0' + random() % 10);
      attempt(changed);
    }
  }
}

}  // namespace
}  // namespace shellmatch
