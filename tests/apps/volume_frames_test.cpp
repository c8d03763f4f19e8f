// Where voxels lie, by our readers and by ITK.
#include "geometry/volume/grid_file.h"
#include "geometry/volume/volume_file.h"
#include "matching/map_file/user_map.h"
#include "tests/apps/itk_transform.h"
#include "tests/apps/volume_folder.h"
#include "tests/geometry/volume/volume_files.h"

#include <Eigen/Geometry>
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>

namespace shellmatch {
namespace {

using namespace testing;

TEST(VolumeFrames, AreItks) {
  const VolumeFolder other;
  VoxelGrid oblique = grid_over({-12, 30, 4}, {1, 0.75, 2}, {7, 5, 4}, {true, false, true});
  oblique.axes = Eigen::AngleAxisd(0.6, Vec<3>(1, 2, -1).normalized()).toRotationMatrix() * oblique.axes;
  for (const bool left_handed : {false, true}) {
    if (left_handed) oblique.axes.col(1) *= -1;
    const Volume volume = volume_of(
        oblique, [](const Vec<3>& x) { return std::round(100 * x[0] + 7 * x[1] - x[2]); }, VoxelType::int16);
    for (const char* name : {"a.nii", "a.nii.gz", "a.nrrd", "a.mha"}) {
      write_volume(other / name, volume, Existing::is_replaced);
      for (const std::array<int, 3>& at : {std::array{0, 0, 0}, std::array{6, 0, 0}, std::array{1, 4, 3}}) {
        const ItkVoxel itk = voxel_by_itk(other / name, at);
        const Vec<3> ours = exchange_space(volume.grid.position(Vec<3>(at[0], at[1], at[2])));
        EXPECT_LT((Vec<3>(itk.position[0], itk.position[1], itk.position[2]) - ours).norm(), 1e-4) << name;
        EXPECT_EQ(itk.value, volume.values[volume.grid.number(at[0], at[1], at[2])]) << name;
        const Volume read = read_volume(other / name);
        EXPECT_LT((read.grid.position(Vec<3>(at[0], at[1], at[2])) - volume.grid.position(Vec<3>(at[0], at[1], at[2])))
                      .norm(),
                  1e-4)
            << name;
      }
    }
  }
}

// A NIfTI has two transforms. By which of them ITK goes we say, and what is written keeps both.
TEST(VolumeFrames, OfNiftisAreItksOrItIsSaid) {
  const VolumeFolder other;
  const VoxelGrid straight = grid_over({1, 2, 3}, {1, 1.5, 2}, {6, 5, 4});
  Volume volume = volume_of(straight, [](const Vec<3>& x) { return std::round(x.sum()); });
  const auto lps = [](const ItkVoxel& v) {
    return exchange_space(Vec<3>(v.position[0], v.position[1], v.position[2]));
  };
  Mat<3> rotated = Eigen::AngleAxisd(0.3, Vec<3>(1, 2, -1).normalized()).toRotationMatrix() * straight.axes,
         sheared = straight.axes;
  sheared(0, 1) = 0.5;
  for (const auto& [name, axes] : {std::pair<std::string, Mat<3>>{"equal", straight.axes},
                                   {"turned", rotated},
                                   {"sheared", sheared},
                                   {"unit", Mat<3>::Identity()}})
    for (const int q : {0, 1, 2})
      for (const int s : {0, 1, 2, 4}) {
        SCOPED_TRACE(fmt::format("{} sform, codes {} and {}", name, q, s));
        volume.grid.axes = axes;
        std::string bytes = nifti(volume);
        put<std::int16_t>(bytes, 252, static_cast<std::int16_t>(q));
        put<std::int16_t>(bytes, 254, static_cast<std::int16_t>(s));
        for (int k = 0; k < 3; ++k)
          put(bytes, 80 + 4 * static_cast<std::size_t>(k), static_cast<float>(straight.axes(k, k)));
        for (int k = 0; k < 3; ++k)
          put(bytes, 268 + 4 * static_cast<std::size_t>(k), static_cast<float>(straight.origin[k]));
        write(other / "model.nii", bytes);
        const Volume read = read_volume(other / "model.nii");
        write_volume(other / "kept.nii", read, Existing::is_replaced);
        const std::string kept = other.read("kept.nii");
        for (const auto& [begin, end] : {std::pair{76, 92}, {252, 328}})
          EXPECT_EQ(kept.substr(static_cast<std::size_t>(begin), static_cast<std::size_t>(end - begin)),
                    bytes.substr(static_cast<std::size_t>(begin), static_cast<std::size_t>(end - begin)));
        const ItkChoice choice = itk_choice(*read.grid.file->nifti, read.grid.size);
        const std::array<int, 3> at{5, 3, 2};
        const Vec<3> index(5, 3, 2), ours = read.grid.position(index);
        if (choice == ItkChoice::refused) {
          // Axes of other lengths than pixdim says are refused by ITK 5.2; ITK 5.4 warns, and takes the lengths of
          // pixdim.
          if (name == "unit" && itk_version() >= 504)
            EXPECT_LT((lps(voxel_by_itk(other / "model.nii", at)) - straight.position(index)).norm(), 1e-4);
          else EXPECT_ANY_THROW(voxel_by_itk(other / "model.nii", at));
          EXPECT_FALSE(volume_notes(read.grid).empty());
          continue;
        }
        const Vec<3> itk = lps(voxel_by_itk(other / "model.nii", at));
        const Vec<3> expected = choice == ItkChoice::identity ? exchange_space(Vec<3>(straight.axes * index))
                                : choice == ItkChoice::qform
                                    ? Vec<3>(straight.axes * index + straight.origin)
                                    : Vec<3>(axes.colwise().normalized() * (straight.axes * index) + straight.origin);
        EXPECT_LT((itk - expected).norm(), 1e-5);
        EXPECT_EQ(lps(voxel_by_itk(other / "kept.nii", at)), itk);
        EXPECT_EQ(volume_notes(read.grid).empty(),
                  (itk - ours).norm() < 1e-5 && !(s > 0 && q > 0 && (name == "turned" || name == "sheared")));
      }
  // What was no NIfTI and cannot be said in one.
  volume.grid.axes = sheared;
  EXPECT_FALSE(written_notes("a.nii", volume.grid).empty());
  EXPECT_TRUE(written_notes("a.nrrd", volume.grid).empty());
  volume.grid.axes = rotated;
  EXPECT_TRUE(written_notes("a.nii", volume.grid).empty());
}

// NRRD's axes without directions, which begin at the middle of the first voxel or at its border.
TEST(VolumeFrames, OfAxesWithoutDirectionsAreItks) {
  const VolumeFolder other;
  for (const std::string centres :
       {"", "centers: cell cell cell\n", "centers: node node node\n", "centers: node cell ???\n"}) {
    const std::string axes = "dimension: 3\nsizes: 3 4 2\nspacings: 1 0.5 2\naxis mins: -3 4 5\n" + centres;
    write(other / "a.nrrd", "NRRD0004\ntype: uint8\n" + axes + "encoding: raw\n\n" + std::string(24, '\1'));
    const LpsPoint itk = voxel_by_itk(other / "a.nrrd", {2, 1, 1}).position;
    const Vec<3> ours = exchange_space(read_voxel_grid(other / "a.nrrd").position(Vec<3>(2, 1, 1)));
    EXPECT_LT((Vec<3>(itk[0], itk[1], itk[2]) - ours).norm(), 1e-12) << centres;
  }
}

}  // namespace
}  // namespace shellmatch
