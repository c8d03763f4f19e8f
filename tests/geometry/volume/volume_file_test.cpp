// Files of volumes: the frames of all formats, what is written is read back, and what is refused.
#include "geometry/volume/volume_file.h"
#include "tests/geometry/io/files.h"
#include "tests/geometry/volume/volume_files.h"

#include <Eigen/Geometry>

#include <sys/stat.h>

namespace shellmatch::testing {
namespace {

const VoxelGrid straight = grid_over({-10.5, 20.25, 3}, {1, 0.5, 2}, {4, 5, 3});
const VoxelGrid turned = grid_over({-10.5, 20.25, 3}, {1, 0.5, 2}, {4, 5, 3}, {true, true, false});

double number_of_place(const Vec<3>& x) {
  return std::max(0.0, std::round(3 * (x[0] + 10.5) + 7 * (x[1] - 20.25) + 11 * (x[2] - 3)));
}

void expect_equal(const VoxelGrid& a, const VoxelGrid& b, double tolerance) {
  EXPECT_EQ(a.size, b.size);
  EXPECT_LE((a.origin - b.origin).norm(), tolerance);
  EXPECT_LE((a.axes - b.axes).norm(), tolerance);
}

TEST(VolumeFile, EveryFormatIsInRas) {
  const TempFolder folder;
  for (const VoxelGrid& grid : {straight, turned, permuted(turned)}) {
    const Volume volume = volume_of(grid, number_of_place);
    std::vector<std::string> files{folder.write("a.nii", nifti(volume)), folder.write("b.nrrd", nrrd(volume, true)),
                                   folder.write("c.nrrd", nrrd(volume, false))};
    if (grid.axes.isDiagonal()) files.push_back(folder.write("d.mha", meta_image(volume)));
    for (const std::string& file : files) {
      const Volume read = read_volume(file);
      expect_equal(read.grid, grid, 0);
      EXPECT_EQ(read.values, volume.values) << file;
      const Volume same = canonical(read);
      expect_equal(same.grid, straight, 0);
      EXPECT_EQ(same.values, volume_of(straight, number_of_place).values) << file;
    }
  }
}

TEST(VolumeFile, WhatIsWrittenIsReadBack) {
  const TempFolder folder;
  VoxelGrid oblique = straight;
  oblique.axes = Eigen::AngleAxisd(0.4, Vec<3>(1, 2, -1).normalized()).toRotationMatrix() * oblique.axes;
  for (const VoxelType type :
       {VoxelType::uint8, VoxelType::int16, VoxelType::int32, VoxelType::float32, VoxelType::float64})
    for (const std::string name : {"a.nii", "a.nii.gz", "a.nrrd", "a.mha"}) {
      const Volume volume = volume_of(oblique, number_of_place, type);
      write_volume(folder.path(name), volume, Existing::is_replaced);
      const Volume read = read_volume(folder.path(name));
      EXPECT_EQ(read.type, type);
      EXPECT_EQ(read.values, volume.values);
      // NIfTI has numbers of single precision.
      expect_equal(read.grid, oblique, name.starts_with("a.nii") ? 1e-5 : 1e-12);
      expect_equal(read_voxel_grid(folder.path(name)), read.grid, 0);
    }
  // The qform alone says the same as the sform, for left-handed axes, too.
  for (const double sign : {1.0, -1.0}) {
    oblique.axes.col(0) *= sign;
    write_volume(folder.path("q.nii"), volume_of(oblique, number_of_place), Existing::is_replaced);
    std::string bytes = folder.read("q.nii");
    put<std::int16_t>(bytes, 254, 0);
    expect_equal(read_volume(folder.write("q.nii", bytes)).grid, oblique, 1e-5);
  }
  // Values beyond the type's range are limited, and rounded.
  const Volume wild = volume_of(straight, [](const Vec<3>& x) { return x[0] < -10 ? -3.7 : x[0] < -9 ? 300 : 1.6; });
  write_volume(folder.path("w.nrrd"), wild, Existing::is_replaced);
  const Volume read = read_volume(folder.path("w.nrrd"));
  EXPECT_EQ(read.values[0], 0);
  EXPECT_EQ(read.values[1], 255);
  EXPECT_EQ(read.values[2], 2);
  EXPECT_TRUE(
      contains(input_error_of([&] { write_volume(folder.path("w.nrrd"), wild, Existing::is_kept); }), "exists"));
  EXPECT_TRUE(contains(input_error_of([&] { check_volume_output("a.mhd"); }),
                       "volumes are written as .nii, .nii.gz, .nrrd, .mha or .vti"));
}

TEST(VolumeFile, NamesItsUnit) {
  const TempFolder folder;
  const Volume volume = volume_of(straight, number_of_place);
  std::string bytes = nifti(volume);
  const auto unit_of_nifti = [&](char code) {
    bytes[123] = code;
    return canonical(read_volume(folder.write("a.nii", bytes))).grid.unit;
  };
  EXPECT_EQ(unit_of_nifti(0), "");
  for (const char code : {1, 2, 3, 10})
    EXPECT_EQ(unit_of_nifti(code), "mm") << "metres and micrometres become millimetres, whatever the unit of time";
  const auto unit_of_nrrd = [&](const std::string& line) {
    std::string text = nrrd(volume, true);
    text.insert(text.find("encoding"), line);
    return read_volume(folder.write("a.nrrd", text)).grid.unit;
  };
  EXPECT_EQ(unit_of_nrrd(""), "");
  EXPECT_EQ(unit_of_nrrd("space units: \"um\" \"um\" \"um\"\n"), "mm");
  EXPECT_EQ(unit_of_nrrd("space units: \"pixel\" \"pixel\" \"pixel\"\n"), "pixel");
  EXPECT_EQ(unit_of_nrrd("space units: \"mm\" \"mm\" \"cm\"\n"), "");
}

// What contradicts itself is read by the type, and said.
TEST(VolumeFile, ContradictionsAreSaid) {
  const TempFolder folder;
  std::string bytes = nifti(volume_of(straight, number_of_place));
  EXPECT_TRUE(volume_notes(read_voxel_grid(folder.write("a.nii", bytes))).empty());
  put<std::int16_t>(bytes, 72, 16);
  const std::vector<std::string> notes = volume_notes(read_voxel_grid(folder.write("b.nii", bytes)));
  ASSERT_EQ(notes.size(), 1u);
  EXPECT_TRUE(contains(notes[0], "16 bits for each voxel (bitpix), and a type of 8 (datatype 2)"));
  const auto notes_of_nrrd = [&](const std::string& spacings) {
    return volume_notes(read_voxel_grid(
        folder.write("a.nrrd", "NRRD0005\ntype: uchar\ndimension: 3\nsizes: 2 2 2\nspace: LPS\nspacings: " + spacings +
                                   "\nspace directions: (2,0,0) (0,2,0) (0,0,3)\nencoding: raw\n\n12345678")));
  };
  EXPECT_TRUE(notes_of_nrrd("2 2 3").empty());
  EXPECT_TRUE(notes_of_nrrd("nan nan nan").empty());
  ASSERT_EQ(notes_of_nrrd("2 1 1").size(), 1u);
  EXPECT_TRUE(contains(notes_of_nrrd("2 1 1")[0],
                       "voxels of 1 along axis 2 (spacings), and of 2 by its space directions, by which it is read"));
}

// Whether gzip has compressed a file is what its first bytes say.
TEST(VolumeFile, MayBeCompressedWhateverItsName) {
  const TempFolder folder;
  const Volume volume = volume_of(straight, number_of_place);
  for (const auto& [written, renamed] : {std::pair{"a.nii.gz", "a.nii"}, {"b.nii", "b.nii.gz"}}) {
    write_volume(folder.path(written), volume, Existing::is_kept);
    std::filesystem::rename(folder.path(written), folder.path(renamed));
    EXPECT_EQ(read_volume(folder.path(renamed)).values, volume.values) << renamed;
  }
}

class RefusedVolume : public ::testing::Test {
 protected:
  std::string refusal(const std::string& name, const std::string& bytes) {
    const std::string file = folder.write(name, bytes);
    ::testing::internal::CaptureStderr();
    const std::string message = input_error_of([&] { read_volume(file); });
    EXPECT_EQ(::testing::internal::GetCapturedStderr(), "") << "one message, and not the libraries' own";
    EXPECT_TRUE(contains(message, file));
    return message;
  }
  static std::string replaced(std::string text, const std::string& from, const std::string& to) {
    const std::size_t at = text.find(from);
    EXPECT_NE(at, text.npos) << from;
    return at == text.npos ? text : text.replace(at, from.size(), to);
  }
  template <class T>
  static std::string changed(std::string bytes, std::size_t offset, T value) {
    put<T>(bytes, offset, value);
    return bytes;
  }
  const TempFolder folder;
  const std::string nii = nifti(volume_of(straight, number_of_place)),
                    nrd = nrrd(volume_of(straight, number_of_place), true),
                    mha = meta_image(volume_of(straight, number_of_place));
};

TEST_F(RefusedVolume, ShortData) {
  EXPECT_TRUE(contains(refusal("a.nii", nii.substr(0, nii.size() - 1)), "cut off"));
  EXPECT_TRUE(contains(refusal("a.nrrd", nrd.substr(0, nrd.size() - 30)), "cut off"));
  EXPECT_TRUE(contains(refusal("a.mha", mha.substr(0, mha.size() - 30)), "cut off"));
  EXPECT_TRUE(contains(refusal("b.nii", nii.substr(0, 100)), "no NIfTI image"));
  EXPECT_TRUE(contains(refusal("b.nrrd", "NRRD0004\n"), "does not say type, dimension, sizes and encoding"));
  EXPECT_TRUE(contains(refusal("b.mha", "ObjectType = Image\n"), "ElementDataFile"));
  EXPECT_TRUE(contains(refusal("c.nii.gz", nii.substr(0, 360)), "cut off"));
  EXPECT_TRUE(contains(refusal("c.nii", ""), "empty"));
  EXPECT_TRUE(contains(refusal("d.nrrd", "no such thing"), "does not begin with the word NRRD"));
  for (const std::string name : {"e.nii.gz", "e.nrrd", "e.mha"}) {  // compressed
    write_volume(folder.path(name),
                 volume_of(
                     grid_over({0, 0, 0}, {1, 1, 1}, {20, 20, 20}),
                     [](const Vec<3>& x) { return 37 * x[0] * x[1] + x[2] * x[2]; }, VoxelType::int32),
                 Existing::is_replaced);
    const auto size = std::filesystem::file_size(folder.path(name));
    EXPECT_NO_THROW(read_volume(folder.path(name)));
    std::filesystem::resize_file(folder.path(name), size - 200);
    EXPECT_TRUE(contains(input_error_of([&] { read_volume(folder.path(name)); }), "cut off")) << name;
  }
  EXPECT_TRUE(contains(input_error_of([&] { read_volume(folder.path("none.mha")); }), "no such file"));
}

TEST_F(RefusedVolume, DamagedCompression) {
  write_volume(folder.path("whole.nii.gz"), volume_of(straight, number_of_place), Existing::is_replaced);
  std::string bytes = folder.read("whole.nii.gz");
  bytes.replace(10, 20, std::string(20, '\xff'));  // behind the header of gzip
  EXPECT_TRUE(contains(refusal("a.nii.gz", bytes), "its compressed data are damaged"));
}

TEST_F(RefusedVolume, HugeHeaders) {
  std::string huge = nii;
  for (std::size_t k = 0; k < 3; ++k) put<std::int16_t>(huge, 42 + 2 * k, 600);
  EXPECT_TRUE(contains(
      refusal("a.nii", huge),
      "cut off, or damaged: 600 x 600 x 600 voxels take 216000000 bytes, which the file, of 412 bytes, does not hold"));
  for (std::size_t k = 0; k < 3; ++k) put<std::int16_t>(huge, 42 + 2 * k, 32000);
  EXPECT_TRUE(contains(refusal("a.nii", huge), "has more than 268435456 voxels"));
  EXPECT_TRUE(contains(refusal("a.nrrd", replaced(nrd, "sizes: 4 5 3", "sizes: 600 600 600")), "cut off"));
  EXPECT_TRUE(contains(refusal("b.nrrd", replaced(nrd, "sizes: 4 5 3", "sizes: 4000000000 4000000000 4000000000")),
                       "has more than"));
  EXPECT_TRUE(contains(refusal("a.mha", replaced(mha, "DimSize = 4 5 3", "DimSize = 600 600 600")), "cut off"));
}

TEST_F(RefusedVolume, OtherDimensions) {
  EXPECT_TRUE(
      contains(refusal("a.nii", changed<std::int16_t>(changed<std::int16_t>(nii, 40, 2), 46, 1)), "a single slice"));
  EXPECT_TRUE(
      contains(refusal("b.nii", changed<std::int16_t>(changed<std::int16_t>(nii, 40, 4), 48, 3)), "has 4 dimensions"));
  EXPECT_TRUE(contains(refusal("a.mha", replaced(mha, "ElementType", "ElementNumberOfChannels = 3\nElementType")),
                       "3 numbers for each voxel"));
}

TEST_F(RefusedVolume, NoFrameOfSpace) {
  EXPECT_TRUE(contains(refusal("a.nii", changed<float>(nii, 84, 0)), "the spacing of its voxels along axis 2 is 0"));
  EXPECT_TRUE(
      contains(refusal("a.nii", changed<float>(nii, 84, NAN)), "the spacing of its voxels along axis 2 is nan"));
  EXPECT_TRUE(contains(refusal("a.nii", changed<float>(nii, 84, -1)), "the spacing of its voxels along axis 2 is -1"));
  EXPECT_TRUE(contains(refusal("b.nii", changed<float>(nii, 280, INFINITY)), "position in space is not finite"));
  EXPECT_TRUE(contains(refusal("c.nii", changed<float>(changed<float>(nii, 280, 0), 296, 1)),
                       "do not span space"));  // two columns along one axis
  EXPECT_TRUE(
      contains(refusal("a.nrrd", replaced(nrd, "(-1,-0,0) (-0,-0.5,0)", "(-1,-0,0) (-1,-0,0)")), "do not span space"));
  EXPECT_TRUE(
      contains(refusal("b.nrrd", replaced(nrd, "(-1,-0,0) (-0,-0.5,0)", "(-1,-0,0) (0,0,0)")), "must be positive"));
  EXPECT_TRUE(contains(refusal("a.mha", replaced(mha, "ElementSpacing = 1 0.5 2", "ElementSpacing = 1 0 2")),
                       "must be positive"));
  EXPECT_TRUE(contains(refusal("a.mha", replaced(mha, "ElementSpacing = 1 0.5 2", "ElementSpacing = 1 -0.5 2")),
                       "must be positive"));
  EXPECT_TRUE(
      contains(refusal("b.mha", replaced(mha, "TransformMatrix = -1 0 0 0 -1 0", "TransformMatrix = -1 0 0 -1 0 0")),
               "do not span space"));
}

TEST_F(RefusedVolume, ValuesThatAreNoNumbers) {
  std::string grey = nrrd(volume_of(straight, number_of_place), true);
  grey = replaced(grey, "unsigned char", "float\nendian: little");
  grey.resize(grey.find("\n\n") + 2);
  Volume volume = volume_of(straight, number_of_place);
  volume.values[6] = NAN;
  EXPECT_TRUE(contains(refusal("a.nrrd", grey + bytes_of<float>(volume)), "voxel 2 1 0 (counted from 0) is nan"));
  volume.values[6] = -INFINITY;
  EXPECT_TRUE(contains(refusal("a.nrrd", grey + bytes_of<float>(volume)), "is -inf"));
  EXPECT_TRUE(
      contains(refusal("b.nrrd", replaced(grey, "float", "int") +
                                     bytes_of<std::int32_t>(volume_of(straight, [](const Vec<3>&) { return 5e7; }))),
               "whole numbers up to 16777216"));
}

TEST_F(RefusedVolume, ValuesElsewhere) {
  std::string header = replaced(mha, "LOCAL", "values.raw");
  const std::string values = header.substr(header.find("values.raw\n") + 11);
  header.resize(header.find("values.raw\n") + 11);
  EXPECT_TRUE(contains(refusal("a.mhd", header), "values.raw: no such file"));
  folder.write("values.raw", values);
  EXPECT_EQ(read_volume(folder.write("a.mhd", header)).values, volume_of(straight, number_of_place).values);
  folder.write("values.raw", values.substr(1));
  EXPECT_TRUE(contains(refusal("a.mhd", header), "cut off"));
  EXPECT_TRUE(contains(refusal("a.mhd", replaced(header, "values.raw", "slice%03d.raw 1 3 1")), "in several files"));
  // A pipe would be waited for without end.
  ASSERT_EQ(mkfifo(folder.path("pipe.raw").c_str(), 0600), 0);
  EXPECT_TRUE(contains(refusal("b.mhd", replaced(header, "values.raw", "pipe.raw")), "is a pipe"));
}

}  // namespace
}  // namespace shellmatch::testing
