// Units of volumes that are written: the same lengths whatever the format, and no unit where none is known.
#include "geometry/volume/volume_file.h"
#include "geometry/volume/zlib_volume.h"
#include "tests/geometry/io/files.h"
#include "tests/geometry/volume/volume_files.h"

namespace shellmatch::testing {
namespace {

VoxelGrid grid_in(const std::string& unit) {
  VoxelGrid grid = grid_over({-10.5, 20.25, 3}, {1, 0.5, 2}, {4, 5, 3});
  grid.unit = unit;
  return grid;
}

float number_at(const std::string& bytes, std::size_t offset) {
  float number;
  std::memcpy(&number, bytes.data() + offset, sizeof number);
  return number;
}

TEST(VolumeUnits, ANiftiIsInMillimetresOrSaysNothing) {
  const TempFolder folder;
  const std::string file = folder.path("a.nii");
  for (const auto& [unit, millimetres] : {std::pair{"mm", 1.0},
                                          {"cm", 10.0},
                                          {"m", 1000.0},
                                          {"um", 1e-3},
                                          {"\u00b5m", 1e-3},
                                          {"micrometer", 1e-3},
                                          {"inch", 25.4}}) {
    const Volume volume = volume_of(grid_in(unit), [](const Vec<3>& x) { return std::round(x[2]); });
    write_volume(file, volume, Existing::is_replaced);
    EXPECT_EQ(folder.read("a.nii")[123], 2) << unit;
    const Volume read = read_volume(file);
    EXPECT_EQ(read.grid.unit, "mm");
    EXPECT_LE((read.grid.origin - millimetres * volume.grid.origin).norm(),
              1e-6 * millimetres * volume.grid.origin.norm())
        << unit;
    EXPECT_LE((read.grid.axes - millimetres * volume.grid.axes).norm(), 1e-6 * millimetres) << unit;
    EXPECT_EQ(read.values, volume.values) << unit << ": values are no lengths";
  }
  for (const std::string unit : {"", "voxel"}) {
    write_volume(file, volume_of(grid_in(unit), [](const Vec<3>&) { return 1; }), Existing::is_replaced);
    EXPECT_EQ(folder.read("a.nii")[123], 0) << unit;
    EXPECT_EQ(read_volume(file).grid.unit, "");
    EXPECT_EQ(read_volume(file).grid.axes(2, 2), 2);
  }
}

TEST(VolumeUnits, VectorsAreInTheUnitOfTheirFile) {
  const TempFolder folder;
  const VoxelGrid grid = grid_in("cm");
  const std::vector<float> values(3 * grid.n_voxels(), 0.25f);
  vector_volume_file(folder.path("u.nii"), grid, values, Existing::is_kept).publish();
  vector_volume_file(folder.path("u.nrrd"), grid, values, Existing::is_kept).publish();
  const std::string nii = folder.read("u.nii"), nrrd = folder.read("u.nrrd");
  EXPECT_EQ(nii[123], 2);
  EXPECT_EQ(number_at(nii, 352), 2.5f);
  EXPECT_TRUE(contains(nrrd, "space units: \"cm\" \"cm\" \"cm\"\n"));
  std::string inflated;
  for_each_piece(folder.path("u.nrrd"), nrrd.find("\n\n") + 2, true, 0, sizeof(float),
                 [&](std::string_view piece) { inflated += piece; });
  ASSERT_EQ(inflated.size(), sizeof(float));
  EXPECT_EQ(number_at(inflated, 0), 0.25f);
}

TEST(VolumeUnits, AnNrrdKeepsItsUnit) {
  const TempFolder folder;
  for (const std::string unit : {"cm", "um", "mm", "voxel", ""}) {
    write_volume(folder.path("a.nrrd"), volume_of(grid_in(unit), [](const Vec<3>&) { return 1; }),
                 Existing::is_replaced);
    const Volume read = canonical(read_volume(folder.path("a.nrrd")));
    const std::optional<double> millimetres = millimetres_of(unit);
    EXPECT_EQ(read.grid.unit, millimetres ? "mm" : unit);
    EXPECT_EQ(read.grid.axes(2, 2), 2 * millimetres.value_or(1));
    EXPECT_EQ(folder.read("a.nrrd").find("units") != std::string::npos, unit != "");
    // What lies on its voxels has its numbers, and vectors too.
    const VoxelGrid grid = read_voxel_grid(folder.path("a.nrrd"));
    EXPECT_EQ(volume_notes(grid).empty(), !millimetres || *millimetres == 1);
    const std::string header = folder.read("a.nrrd").substr(0, folder.read("a.nrrd").find("\n\n"));
    write_volume(folder.path("b.nrrd"), read_volume(folder.path("a.nrrd")), Existing::is_replaced);
    EXPECT_EQ(folder.read("b.nrrd").substr(0, header.size()), header);
    vector_volume_file(folder.path("u.nrrd"), grid, std::vector<float>(3 * grid.n_voxels(), 5.0f),
                       Existing::is_replaced)
        .publish();
    std::string inflated;
    for_each_piece(folder.path("u.nrrd"), folder.read("u.nrrd").find("\n\n") + 2, true, 0, sizeof(float),
                   [&](std::string_view piece) { inflated += piece; });
    EXPECT_FLOAT_EQ(number_at(inflated, 0), static_cast<float>(5 / millimetres.value_or(1)));
  }
}

// What other programs do not turn into millimetres, or not wholly, they have in one place with its model.
TEST(VolumeUnits, ANiftiOnTheVoxelsOfANiftiKeepsItsUnit) {
  const TempFolder folder;
  for (const auto& [code, millimetres] : {std::pair<char, double>{1, 1000}, {3, 1e-3}}) {
    std::string bytes = nifti(volume_of(grid_in("mm"), [](const Vec<3>&) { return 1; }));
    bytes[123] = code;
    folder.write("a.nii", bytes);
    const Volume read = read_volume(folder.path("a.nii"));
    EXPECT_EQ(read.grid.unit, "mm");
    EXPECT_NEAR(read.grid.origin[1], 20.25 * millimetres, 1e-9);
    EXPECT_TRUE(contains(volume_notes(read.grid)[0], "nibabel leaves them as they are, and ITK before 5.4"));
    write_volume(folder.path("b.nii"), read, Existing::is_replaced);
    const std::string written = folder.read("b.nii");
    EXPECT_EQ(written[123], code);
    for (const std::size_t offset : {80, 84, 88, 280, 292, 300, 308, 320, 324})  // pixdim, srow
      EXPECT_EQ(number_at(written, offset), number_at(bytes, offset)) << offset;
    // Other programs leave the numbers of an NRRD as they are.
    write_volume(folder.path("b.nrrd"), read, Existing::is_replaced);
    EXPECT_TRUE(contains(folder.read("b.nrrd"), "space units: \"mm\" \"mm\" \"mm\"\n"));
  }
}

}  // namespace
}  // namespace shellmatch::testing
