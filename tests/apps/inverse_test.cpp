// `apply --inverse` undoes `apply`, pose and placement included; `--keep-pose` leaves the pose out of both.

#include "geometry/io/read_shape.h"
#include "tests/apps/cli_harness.h"
#include "tests/matching/output/temporary_folder.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <string>
#include <vector>

namespace shellmatch {
namespace {

using testing::TemporaryFolder;

using Points = std::vector<Vec<2>>;

void run(const std::vector<std::string>& words) {
  const ProgramResult result = run_program(words);
  ASSERT_EQ(result.exit_code, 0) << result.err;
}

Points points(const std::string& file) { return read_points_or_outline_2d(file).vertices; }

double largest_distance(const Points& a, const Points& b) {
  EXPECT_EQ(a.size(), b.size());
  double largest = 0;
  for (std::size_t i = 0; i < std::min(a.size(), b.size()); ++i) largest = std::max(largest, (a[i] - b[i]).norm());
  return largest;
}

Vec<2> mean(const Points& all) {
  Vec<2> sum = Vec<2>::Zero();
  for (const Vec<2>& x : all) sum += x;
  return sum / static_cast<double>(all.size());
}

/// Matches a star onto a star that is moved, solved in this direction, and applies the map in four ways.
struct AppliedMaps {
  explicit AppliedMaps(const std::string& direction) {
    run({"generate", "star/mild", "-o", tmp / "star.csv"});
    run({"generate", "star/sharp", "-o", tmp / "sharp.csv"});
    std::ofstream moved(tmp / "moved.csv");
    for (const Vec<2>& x : points(tmp / "sharp.csv")) moved << x[0] + shift[0] << ',' << x[1] + shift[1] << '\n';
    moved.close();
    run({"match", tmp / "star.csv", tmp / "moved.csv", "-o", tmp / "out", "--levels", "3:5", "--set", "pictures=none",
         "-q", "--set", "align.mode=rigid", "--set", "align.direction=" + direction});
    star = points(tmp / "star.csv");
    there = apply("star.csv", "there.csv", {});
    back = apply("there.csv", "back.csv", {"--inverse"});
    in_place = apply("star.csv", "in_place.csv", {"--keep-pose"});
    from_place = apply("in_place.csv", "from_place.csv", {"--inverse", "--keep-pose"});
  }
  Points apply(const std::string& from, const std::string& to, const std::vector<std::string>& flags) const {
    std::vector<std::string> words{"apply", tmp / "out", tmp / from, "-o", tmp / to};
    words.insert(words.end(), flags.begin(), flags.end());
    run(words);
    return points(tmp / to);
  }
  const TemporaryFolder tmp;
  const Vec<2> shift{3, -2};
  Points star, there, back, in_place, from_place;
};

class ApplyInverse : public ::testing::TestWithParam<const char*> {};
INSTANTIATE_TEST_SUITE_P(Directions, ApplyInverse, ::testing::Values("forward", "backward"));

TEST_P(ApplyInverse, CarriesPointsBackAndKeepsThePoseWhereAsked) {
  const AppliedMaps maps(GetParam());
  EXPECT_LT(largest_distance(maps.back, maps.star), 1e-9);
  EXPECT_LT(largest_distance(maps.from_place, maps.star), 1e-9);
  // The template lies elsewhere; without the pose the deformed star lies where the star did.
  EXPECT_LT((mean(maps.there) - mean(maps.star) - maps.shift).norm(), 0.05);
  EXPECT_LT((mean(maps.in_place) - mean(maps.star)).norm(), 0.05);
  EXPECT_GT(largest_distance(maps.in_place, maps.star), 0.02);
}

TEST(ApplyKeepPose, SaysWhereThereIsNone) {
  const TemporaryFolder tmp;
  run({"match", "generate:circle", "generate:ellipse", "-o", tmp / "out", "--levels", "3:3", "--set", "pictures=none",
       "-q", "--align", "none"});
  run({"generate", "circle", "-o", tmp / "circle.csv"});
  const ProgramResult result =
      run_program({"apply", tmp / "out", tmp / "circle.csv", "-o", tmp / "moved.csv", "--keep-pose"});
  EXPECT_EQ(result.exit_code, 0);
  EXPECT_NE(result.err.find("changes nothing"), std::string::npos) << result.err;
}

}  // namespace
}  // namespace shellmatch
