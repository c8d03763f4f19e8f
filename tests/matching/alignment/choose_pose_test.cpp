#include "matching/alignment/choose_pose.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <vector>

namespace shellmatch {
namespace {

/// A straight rod of length 1, and the same so many times as large and bent to three quarters of a circle.
std::vector<CorrespondingPoints> bent_rod(std::size_t n_rings, double size) {
  constexpr double thickness = 0.05, arc = 1.5 * std::numbers::pi;
  std::vector<CorrespondingPoints> pairs;
  for (std::size_t ring = 0; ring < n_rings; ++ring)
    for (int k = 0; k < 6; ++k) {
      const double u = static_cast<double>(ring) / static_cast<double>(n_rings - 1), around = k * std::numbers::pi / 3;
      const double y = thickness * std::cos(around), z = thickness * std::sin(around), r = 1 / arc + y;
      pairs.push_back({{u, y, z}, {3 + size * r * std::sin(arc * u), size * r * std::cos(arc * u), size * z}, 1.0});
    }
  return pairs;
}

TEST(ChoosePose, BentLimbsSayNothingOfTheSize) {
  const AlignOptions options;
  for (const double size : {0.5, 1.0, 1.1, 2.0}) {
    const std::vector<CorrespondingPoints> pairs = bent_rod(50, size);
    const double scale = choose_pose<3>(pairs, options, Mirroring::never).scale;
    if (size == 1 || size == 1.1) {
      EXPECT_EQ(scale, 1) << "two individuals";
    } else {
      EXPECT_NEAR(scale, size, 0.05 * size);
    }
    ASSERT_LT(fit_pose(pairs, PoseKind::similarity).scale, 0.7 * size) << "what the test is about";
  }
}

TEST(ChoosePose, FewPairsHaveNoNeighbours) {
  const std::vector<CorrespondingPoints> landmarks = bent_rod(8, 1);
  EXPECT_EQ(choose_pose<3>(landmarks, {}, Mirroring::never).scale, fit_pose(landmarks, PoseKind::similarity).scale);
}

}  // namespace
}  // namespace shellmatch
