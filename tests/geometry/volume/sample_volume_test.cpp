// Values between voxels.
#include "geometry/volume/sample_volume.h"
#include "tests/geometry/volume/volume_files.h"

#include <gtest/gtest.h>

namespace shellmatch::testing {
namespace {

const VoxelGrid sampled_grid = grid_over({1, -2, 5}, {0.5, 1, 2}, {7, 6, 5}, {true, false, false});

TEST(SampleVolume, LinearIsExactForLinearFunctions) {
  const auto f = [](const Vec<3>& x) { return 2 * x[0] - x[1] + 0.25 * x[2] + 3; };
  const Volume volume = volume_of(sampled_grid, f, VoxelType::float32);
  const VolumeSampler sample(volume, Sampling::linear);
  for (const Vec<3>& x : {Vec<3>(1, -2, 5), Vec<3>(1.3, 0.7, 9.1), Vec<3>(4, 3, 13), Vec<3>(2.2, 2.9, 12)})
    EXPECT_NEAR(sample(x, -1), f(x), 1e-5);
}

TEST(SampleVolume, OutsideIsBackgroundAndAVoxelHoldsHalfItsSideAround) {
  const Volume volume = volume_of(sampled_grid, [](const Vec<3>&) { return 4; });
  for (const Sampling sampling : {Sampling::nearest, Sampling::label, Sampling::linear}) {
    const VolumeSampler sample(volume, sampling);
    EXPECT_EQ(sample({0.76, -2.4, 4.1}, 9), 4);
    EXPECT_EQ(sample({0.74, -2, 5}, 9), 9);
    EXPECT_EQ(sample({1, 3.6, 5}, 9), 9);
    EXPECT_EQ(sample({1, -2, NAN}, 9), 9);
  }
}

TEST(SampleVolume, LabelsKeepTheirPlaceAndLoseTheirStairs) {
  const Volume volume = volume_of(grid_over({0, 0, 0}, {1, 1, 1}, {20, 20, 20}),
                                  [](const Vec<3>& x) { return x[0] + 0.5 * x[1] < 14 ? 3 : 7; });
  const VolumeSampler label(volume, Sampling::label), nearest(volume, Sampling::nearest);
  int n_wrong_labels = 0, n_wrong_nearest = 0;
  for (double x = 5; x < 14; x += 0.1)
    for (double y = 5; y < 14; y += 0.1) {
      // The plane that parts the labels runs through the middle between the voxels on its two sides.
      const float expected = x + 0.5 * y < 13.75 ? 3 : 7;
      n_wrong_labels += label({x, y, 10}, 0) != expected;
      n_wrong_nearest += nearest({x, y, 10}, 0) != expected;
    }
  EXPECT_LT(3 * n_wrong_labels, n_wrong_nearest);
}

TEST(SampleVolume, LabelsAreFewWholeNumbers) {
  EXPECT_TRUE(is_label_volume(volume_of(
      sampled_grid, [](const Vec<3>& x) { return x[0] > 2 ? 1 : 0; }, VoxelType::float32)));
  EXPECT_FALSE(is_label_volume(volume_of(
      sampled_grid, [](const Vec<3>& x) { return x[0] > 2 ? 0.5 : 0; }, VoxelType::float32)));
  EXPECT_FALSE(is_label_volume(volume_of(sampled_grid, [](const Vec<3>& x) { return x[0] > 2 ? -1 : 0; })));
  EXPECT_FALSE(
      is_label_volume(volume_of(grid_over({0, 0, 0}, {1, 1, 1}, {200, 2, 2}), [](const Vec<3>& x) { return x[0]; })));
}

}  // namespace
}  // namespace shellmatch::testing
