// Volumes that a program has: the frame of the matrix, and what is refused.

#include "geometry/volume/make_volume.h"

#include "geometry/label/volume_shape.h"
#include "tests/support/expect_input_error.h"

#include <gtest/gtest.h>

#include <limits>
#include <vector>

namespace shellmatch {
namespace {

Mat<4> some_matrix() {
  Mat<4> m = Mat<4>::Identity();
  m.row(0) << 2, 0, 0, 5;
  m.row(1) << 0, 3, 0.5, -4;
  m.row(2) << 0, -0.25, 1, 7;
  return m;
}

Volume made(const Mat<4>& matrix, Space space = Space::ras, std::vector<float> values = std::vector<float>(24, 1),
            VoxelType type = VoxelType::int32) {
  return make_volume("scan", {2, 3, 4}, matrix, space, type, std::move(values));
}

TEST(MakeVolume, VoxelsAreWhereTheMatrixSays) {
  const Mat<4> m = some_matrix();
  const Eigen::Vector4d index(1, 2, 3, 1);
  const Vec<3> expected = (m * index).head<3>();
  EXPECT_EQ(made(m).grid.position({1, 2, 3}), expected);
  EXPECT_EQ(made(m).grid.position({0, 0, 0}), Vec<3>(5, -4, 7));
  // The same numbers in LPS are another place in RAS, in which volumes are kept.
  EXPECT_EQ(made(m, Space::lps).grid.position({1, 2, 3}), Vec<3>(-expected.x(), -expected.y(), expected.z()));
}

TEST(MakeVolume, RefusesWhatNoFileMayHold) {
  Mat<4> m = some_matrix();
  m(3, 0) = 0.5;
  expect_input_error([&] { made(m); }, {"scan", "last row", "0.5"});
  m = some_matrix();
  m.col(1) = m.col(0);
  expect_input_error([&] { made(m); }, {"scan", "do not span space"});
  m = some_matrix();
  m(0, 3) = std::numeric_limits<double>::quiet_NaN();
  expect_input_error([&] { made(m); }, {"scan", "finite"});
  expect_input_error([&] { made(some_matrix(), Space::ras, std::vector<float>(23, 1)); }, {"scan", "23 values"});
  expect_input_error(
      [&] {
        make_volume("scan", {1, 3, 4}, some_matrix(), Space::ras, VoxelType::int32, std::vector<float>(12));
      },
      {"scan", "single slice"});
  std::vector<float> values(24, 1);
  values[1 + 2 * 2 + 6] = std::numeric_limits<float>::infinity();
  expect_input_error([&] { made(some_matrix(), Space::ras, values); }, {"scan", "voxel 1 2 1"});
  values.assign(24, 2e7f);
  expect_input_error([&] { made(some_matrix(), Space::ras, values); }, {"scan", "voxel 0 0 0"});
  EXPECT_EQ(made(some_matrix(), Space::ras, values, VoxelType::float32).values[0], 2e7f);
}

TEST(MakeVolume, ItsLabelIsAShape) {
  std::vector<float> values(20 * 20 * 20);
  for (int k = 6; k < 14; ++k)
    for (int j = 6; j < 14; ++j)
      for (int i = 6; i < 14; ++i) values[static_cast<std::size_t>((k * 20 + j) * 20 + i)] = 3;
  Volume volume = make_volume("scan", {20, 20, 20}, Mat<4>::Identity(), Space::ras, VoxelType::int32, values);
  const Shape<3> shape = volume_shape(VolumePart{std::move(volume), {{3}, 0}}, "scan", Space::ras);
  EXPECT_EQ(shape.source, "scan");
  EXPECT_NEAR(enclosed_measure(shape.surface), 512, 40);  // its corners are rounded
}

}  // namespace
}  // namespace shellmatch
