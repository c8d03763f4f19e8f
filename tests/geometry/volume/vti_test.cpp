// VTK's images: what VTK writes is read, what is written VTK reads, and what is no volume is refused.
#include "geometry/volume/volume_file.h"
#include "tests/geometry/io/files.h"
#include "tests/geometry/volume/volume_files.h"

#include <vtkCellData.h>
#include <vtkFloatArray.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkShortArray.h>
#include <vtkXMLImageDataReader.h>
#include <vtkXMLImageDataWriter.h>

#include <Eigen/Geometry>

namespace shellmatch::testing {
namespace {

using Turn = Eigen::Matrix<double, 3, 3, Eigen::RowMajor>;

const Turn direction = Eigen::AngleAxisd(0.4, Vec<3>(1, 2, -1).normalized()).toRotationMatrix();

// An extent that does not begin at 0 belongs to a part that was cut out.
vtkNew<vtkImageData> image(const Turn& turn) {
  vtkNew<vtkImageData> made;
  made->SetExtent(2, 5, -1, 3, 0, 2);
  made->SetSpacing(1, 0.5, 2);
  made->SetOrigin(-10.5, 20.25, 3);
  made->SetDirectionMatrix(turn.data());
  return made;
}

template <class Array>
void add(vtkDataSetAttributes* to, const char* name, vtkIdType n, double step) {
  vtkNew<Array> array;
  array->SetName(name);
  for (vtkIdType i = 0; i < n; ++i)
    array->InsertNextValue(static_cast<typename Array::ValueType>(step * static_cast<double>(i)));
  to->AddArray(array);
}

class VtiFiles : public ::testing::Test {
 protected:
  std::string write(vtkImageData* data, int mode, bool is_compressed, bool is_encoded) {
    const std::string path = folder.path("image.vti");
    vtkNew<vtkXMLImageDataWriter> writer;
    writer->SetFileName(path.c_str());
    writer->SetInputData(data);
    writer->SetDataMode(mode);
    if (!is_compressed) writer->SetCompressorTypeToNone();
    writer->SetEncodeAppendedData(is_encoded);
    EXPECT_EQ(writer->Write(), 1);
    return path;
  }
  std::string refusal(vtkImageData* data) {
    const std::string path = write(data, vtkXMLWriter::Ascii, false, false);
    return input_error_of([&] { read_volume(path); });
  }
  const TempFolder folder;
};

TEST_F(VtiFiles, WhatVtkWritesIsReadInEveryForm) {
  vtkNew<vtkImageData> data = image(direction);
  add<vtkShortArray>(data->GetPointData(), "label", 60, 3);
  for (const int mode : {vtkXMLWriter::Ascii, vtkXMLWriter::Binary, vtkXMLWriter::Appended})
    for (const bool is_compressed : {false, true})
      for (const bool is_encoded : {false, true}) {
        const Volume read = read_volume(write(data, mode, is_compressed, is_encoded));
        EXPECT_EQ(read.type, VoxelType::int16);
        EXPECT_EQ(read.grid.size, (std::array<int, 3>{4, 5, 3}));
        for (int i = 0; i < 60; ++i) {
          EXPECT_EQ(read.values[static_cast<std::size_t>(i)], 3 * i);
          const Vec<3> at = read.grid.position(Vec<3>(i % 4, i / 4 % 5, i / 20));
          Vec<3> there;
          data->GetPoint(i, there.data());
          EXPECT_LT((at - there).norm(), 1e-6) << i;  // in text seven digits
        }
      }
  EXPECT_EQ(read_voxel_grid(folder.path("image.vti")).size, (std::array<int, 3>{4, 5, 3}));
}

TEST_F(VtiFiles, ValuesOfCellsLieInTheirMiddles) {
  vtkNew<vtkImageData> data = image(Turn::Identity());
  add<vtkFloatArray>(data->GetCellData(), "density", 24, 0.25);
  const Volume read = read_volume(write(data, vtkXMLWriter::Appended, true, false));
  EXPECT_EQ(read.grid.size, (std::array<int, 3>{3, 4, 2}));
  EXPECT_LT((read.grid.origin - Vec<3>(-10.5 + 2.5, 20.25 - 0.25, 4)).norm(), 1e-12);
  EXPECT_EQ(read.values[5], 1.25f);
}

TEST_F(VtiFiles, WhatIsWrittenVtkReads) {
  VoxelGrid grid = grid_over({-10.5, 20.25, 3}, {1, 0.5, 2}, {4, 5, 3});
  grid.axes = direction * grid.axes;
  const auto value = [](const Vec<3>& x) { return std::round(10 * x[0] + x[1] - 3 * x[2] + 300); };
  for (const VoxelType type : {VoxelType::int16, VoxelType::uint32, VoxelType::float32, VoxelType::float64}) {
    const Volume volume = volume_of(grid, value, type);
    write_volume(folder.path("a.vti"), volume, Existing::is_replaced);
    vtkNew<vtkXMLImageDataReader> reader;
    reader->SetFileName(folder.path("a.vti").c_str());
    reader->Update();
    vtkImageData* data = reader->GetOutput();
    ASSERT_EQ(data->GetNumberOfPoints(), 60);
    for (vtkIdType i = 0; i < 60; ++i) {
      EXPECT_EQ(data->GetPointData()->GetScalars()->GetTuple1(i), volume.values[static_cast<std::size_t>(i)]);
      Vec<3> there;
      data->GetPoint(i, there.data());
      EXPECT_LT((grid.position(
                     Vec<3>(static_cast<double>(i % 4), static_cast<double>(i / 4 % 5), static_cast<double>(i / 20))) -
                 there)
                    .norm(),
                1e-12);
    }
    const Volume read = read_volume(folder.path("a.vti"));
    EXPECT_EQ(read.type, type);
    EXPECT_EQ(read.values, volume.values);
    EXPECT_LT((read.grid.axes - grid.axes).norm(), 1e-12);
  }
}

// Positions in the file are those of RAS, and so are the components.
TEST_F(VtiFiles, VectorsAreInTheFramesAxes) {
  const VoxelGrid grid = grid_over({0, 0, 0}, {1, 1, 1}, {2, 2, 2});
  std::vector<float> in_lps;
  for (int i = 0; i < 8; ++i) in_lps.insert(in_lps.end(), {1, 2, 3});
  vector_volume_file(folder.path("a.vti"), grid, in_lps, Existing::is_replaced).publish();
  vtkNew<vtkXMLImageDataReader> reader;
  reader->SetFileName(folder.path("a.vti").c_str());
  reader->Update();
  vtkDataArray* vectors = reader->GetOutput()->GetPointData()->GetVectors();
  ASSERT_NE(vectors, nullptr);
  EXPECT_EQ(vectors->GetComponent(7, 0), -1);
  EXPECT_EQ(vectors->GetComponent(7, 1), -2);
  EXPECT_EQ(vectors->GetComponent(7, 2), 3);
}

TEST_F(VtiFiles, WhatIsNoVolumeIsRefused) {
  vtkNew<vtkImageData> data = image(Turn::Identity());
  EXPECT_TRUE(contains(refusal(data), "no array with one number for each point or cell"));
  add<vtkShortArray>(data->GetPointData(), "first", 60, 1);
  EXPECT_EQ(refusal(data), "");
  add<vtkShortArray>(data->GetPointData(), "second", 60, 1);
  EXPECT_TRUE(contains(refusal(data), "several arrays of numbers ('first', 'second')"));

  data->GetPointData()->RemoveArray("second");
  const std::string path = write(data, vtkXMLWriter::Ascii, false, false);
  std::ifstream in(path);
  const std::string text((std::istreambuf_iterator<char>(in)), {});
  const auto changed = [&](const std::string& from, const std::string& to) {
    std::string other = text;
    const std::size_t at = other.find(from);
    EXPECT_NE(at, other.npos) << from;
    other.replace(at, from.size(), to);
    const std::string file = folder.write("changed.vti", other);
    return input_error_of([&] { read_volume(file); });
  };
  EXPECT_TRUE(contains(changed("Piece Extent=\"2 5", "Piece Extent=\"2 4"), "or of a part"));
  EXPECT_TRUE(contains(changed("type=\"ImageData\"", "type=\"PolyData\""), "a volume is of type ImageData"));
  EXPECT_TRUE(contains(changed("Spacing=\"1", "Spacing=\"nan"), "spacing"));
  EXPECT_TRUE(contains(changed("Spacing=\"1 0.5 2\"", "Spacing=\"1 0.5\""), "Spacing has not 3 numbers"));
  EXPECT_TRUE(contains(changed("</VTKFile>", ""), "damaged"));
  EXPECT_TRUE(contains(changed("type=\"Int16\"", "type=\"String\""), "no array with one number"));
}

}  // namespace
}  // namespace shellmatch::testing
