// `apply --inverse` undoes `apply`, pose and placement included.

#include "geometry/io/read_shape.h"
#include "tests/apps/cli_harness.h"
#include "tests/matching/output/temporary_folder.h"

#include <gtest/gtest.h>

namespace shellmatch {
namespace {

using testing::TemporaryFolder;

TEST(ApplyInverse, CarriesPointsBackToWhereTheyCameFrom) {
  const TemporaryFolder tmp;
  const auto run = [](std::vector<std::string> words) {
    const ProgramResult result = run_program(words);
    ASSERT_EQ(result.exit_code, 0) << result.err;
  };
  // The star is turned by 12 degrees first.
  run({"match", "generate:star/mild", "generate:star/sharp", "-o", tmp / "out", "--levels", "3:5", "--set", "pictures=none", "-q"});
  run({"generate", "star/mild", "-o", tmp / "star.csv"});
  run({"apply", tmp / "out", tmp / "star.csv", "-o", tmp / "there.csv"});
  run({"apply", tmp / "out", tmp / "there.csv", "-o", tmp / "back.csv", "--inverse"});
  const auto x = read_points_or_outline_2d(tmp / "star.csv").vertices, there = read_points_or_outline_2d(tmp / "there.csv").vertices,
             back = read_points_or_outline_2d(tmp / "back.csv").vertices;
  ASSERT_EQ(x.size(), back.size());
  double moved = 0;
  for (std::size_t i = 0; i < x.size(); ++i) {
    EXPECT_LT((back[i] - x[i]).norm(), 1e-9);
    moved = std::max(moved, (there[i] - x[i]).norm());
  }
  EXPECT_GT(moved, 0.05);
}

}  // namespace
}  // namespace shellmatch
