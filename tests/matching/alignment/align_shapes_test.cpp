// The pose of a hand is found, taken out and put back, in results, in the map and in its file.

#include "matching/alignment/align_shapes.h"

#include "base/error.h"
#include "geometry/repair/make_shape.h"
#include "matching/experiment/generated_source.h"
#include "matching/experiment/shape_source.h"
#include "matching/map_file/deformation_file.h"
#include "matching/match_shapes.h"
#include "matching/result/correspondence.h"
#include "tests/matching/output/temporary_folder.h"

#include <Eigen/Geometry>
#include <gtest/gtest.h>

namespace shellmatch {
namespace {

using testing::message_of;
using testing::TemporaryFolder;

Shape<3> hand(const std::string& variant = "") { return std::get<Shape<3>>(open_shape("generate:hand" + variant)); }

/// Turned by half a turn about a skew axis, moved, and scaled.
Similarity<3> motion(double scale) {
  return {scale, Vec<3>(3, -7, 1), Eigen::AngleAxisd(3.0, Vec<3>(1, 0.4, -0.3).normalized()).toRotationMatrix()};
}

Shape<3> moved(const Shape<3>& shape, const Similarity<3>& by) {
  OriginalShape<3> original;
  original.vertices = shape.original.vertices;
  original.polygons = shape.original.polygons;
  for (Vec<3>& x : original.vertices) x = by(x);
  return make_shape(std::move(original), "moved");
}

ExperimentOptions quick(AlignMode mode) {
  ExperimentOptions o = profile_defaults(Profile::standard);
  o.cascade.max_level = 5;
  o.align.mode = mode;
  o.align.search.start_functions = 4;
  o.align.search.functions = 60;
  o.align.search.refined = 2;
  return o;
}

struct Notes final : Observer {
  void note(const std::string& text) override { all += text + "\n"; }
  std::string all;
};

class AlignShapes : public ::testing::Test {
 protected:
  const Shape<3> reference_ = hand(), bent_ = hand("/bent");
};

TEST_F(AlignShapes, ATurnedPairMatchesAsWellAsTheOneThatLiesAsItBelongs) {
  const Similarity<3> by = motion(20);
  const Shape<3> target = moved(bent_, by);
  Notes notes;
  const MatchResult<3> straight = match_shapes(reference_, bent_, quick(AlignMode::automatic), notes);
  const MatchResult<3> result = match_shapes(reference_, target, quick(AlignMode::automatic), notes);
  const Correspondence<3> truth = generated_correspondence<3>("generate:hand", "generate:hand/bent");
  std::vector<Vec<3>> turned_back;
  for (const Vec<3>& y : result.deformed.vertices) turned_back.push_back(by.inverse(y));
  const double diagonal = bounding_box(bent_.original.vertices).diagonal();
  EXPECT_LT(correspondence_error(truth, straight.deformed.vertices), 0.01 * diagonal);
  // A bent hand has no one pose: another start on coarse grids ends a little elsewhere.
  EXPECT_LT(correspondence_error(truth, turned_back), 0.02 * diagonal) << notes.all;
  ASSERT_TRUE(result.summary.alignment);
  EXPECT_FALSE(result.summary.alignment->doubtful);
  EXPECT_NEAR(result.summary.alignment->angle, 172, 15);
  EXPECT_NEAR(result.summary.alignment->scale, 20, 2);
  EXPECT_NE(notes.all.find("the reference is turned by"), std::string::npos) << notes.all;
  // What lies as it belongs stays: its pairs alone are used.
  EXPECT_EQ(straight.summary.alignment->angle, 0);
  EXPECT_GT(straight.summary.alignment->n_pairs, 100);
}

TEST_F(AlignShapes, TheFileOfTheMapHasThePose) {
  const TemporaryFolder tmp;
  Observer quiet;
  const MatchResult<3> result = match_shapes(reference_, moved(bent_, motion(1)), quick(AlignMode::rigid), quiet);
  ASSERT_FALSE(result.map.pose.is_identity());
  write_deformation(tmp / "map.vtu", result.map);
  const Deformation<3> read = read_deformation<3>(tmp / "map.vtu");
  for (std::size_t i = 0; i < reference_.original.vertices.size(); i += 17) {
    const Vec<3> y = read.apply(reference_.original.vertices[i]);
    EXPECT_LT((y - result.deformed.vertices[i]).norm(), 1e-12 * bounding_box(result.deformed.vertices).diagonal());
  }
}

TEST_F(AlignShapes, DoubtfulPairsAreNotUsedUnlessTheyAreAskedFor) {
  Notes notes;
  const ShapePair<3> pair{reference_, moved(bent_, motion(1))};
  ExperimentOptions o = quick(AlignMode::automatic);
  o.align.doubtful_score = 0;
  const Alignment<3> none = align_shapes(pair, {}, o, notes);
  EXPECT_TRUE(none.pose.is_identity());
  EXPECT_TRUE(none.pairs.empty());
  EXPECT_TRUE(none.summary->doubtful);
  EXPECT_NE(notes.all.find("doubtful"), std::string::npos);
  o.align.mode = AlignMode::similarity;
  const Alignment<3> all = align_shapes(pair, {}, o, notes);
  EXPECT_FALSE(all.pose.is_identity());
  EXPECT_GT(all.pairs.size(), 100u);
}

TEST_F(AlignShapes, LandmarksGiveThePose) {
  Observer quiet;
  std::vector<Landmark<3>> landmarks;
  const Similarity<3> by = motion(2);
  for (std::size_t i = 0; i < 5; ++i) {
    const Vec<3>& x = reference_.original.vertices[i * reference_.original.vertices.size() / 5];
    landmarks.push_back({std::to_string(i), x, by(x)});
  }
  const Alignment<3> found = align_shapes(ShapePair<3>{reference_, moved(reference_, by)}, landmarks, quick(AlignMode::landmarks), quiet);
  EXPECT_LT((found.pose.rotation - by.rotation).norm(), 1e-9);
  EXPECT_NEAR(found.pose.scale, 2, 1e-9);
  EXPECT_TRUE(found.pairs.empty());
  const std::string told =
      message_of<InputError>([&] { align_shapes(ShapePair<3>{reference_, bent_}, {}, quick(AlignMode::landmarks), quiet); });
  EXPECT_NE(told.find("landmarks.file"), std::string::npos) << told;
}

TEST(AlignOutlines, StayWhereTheyAreOrAreRefused) {
  const auto outline = [](const char* name) { return std::get<Shape<2>>(open_shape(name)); };
  const ShapePair<2> pair{outline("generate:circle"), outline("generate:ellipse")};
  Observer quiet;
  EXPECT_TRUE(align_shapes(pair, {}, quick(AlignMode::automatic), quiet).pose.is_identity());
  const std::string told = message_of<InputError>([&] { align_shapes(pair, {}, quick(AlignMode::rigid), quiet); });
  EXPECT_NE(told.find("align.mode: rigid"), std::string::npos) << told;
}

TEST(MirroringPose, KeepsFacetsFacingOutward) {
  Surface<3> surface = hand().surface;
  Similarity<3> mirror;
  mirror.rotation = Vec<3>(-1, 1, 1).asDiagonal();
  const auto volume = [](const Surface<3>& s) {
    double sum = 0;
    for (const auto& f : s.facets) sum += s.vertices[f[0]].dot(s.vertices[f[1]].cross(s.vertices[f[2]]));
    return sum;
  };
  const double before = volume(surface);
  apply_placement(mirror, surface);
  EXPECT_NEAR(volume(surface) / before, 1, 1e-9);
}

}  // namespace
}  // namespace shellmatch
