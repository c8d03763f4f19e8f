// The pose of a hand is found, taken out and put back, in results, in the map and in its file.

#include "matching/alignment/align_shapes.h"

#include "base/error.h"
#include "geometry/repair/make_shape.h"
#include "matching/alignment/search_starts.h"
#include "matching/experiment/generated_source.h"
#include "matching/input/shape_source.h"
#include "matching/map_file/deformation_file.h"
#include "matching/match_shapes.h"
#include "matching/result/correspondence.h"
#include "tests/geometry/surface/test_surfaces.h"
#include "tests/matching/alignment/coarse_hands.h"
#include "tests/matching/output/temporary_folder.h"

#include <Eigen/Geometry>
#include <gtest/gtest.h>

namespace shellmatch {
namespace {

using testing::coarse_hands;
using testing::message_of;
using testing::TemporaryFolder;
using testing::truth_of_coarse_hands;

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
  o.align.search.max_vertices = 2000;
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
  const ShapePair<3> hands_ = coarse_hands();
  const Shape<3>&reference_ = hands_.reference, &bent_ = hands_.template_shape;
};

TEST_F(AlignShapes, PairsThatContradictThoseAroundThemAreNotUsed) {
  const ShapePair<3> unlike{reference_, std::get<Shape<3>>(open_shape("generate:dolphin/bent"))};
  const ExperimentOptions options = quick(AlignMode::similarity);  // used whatever the score
  ASSERT_GT(search_starts(unlike, {}, options.align).starts.front().n_contradicting, 0u)
      << "the best, which is chosen, has some";
  Notes notes;
  const Alignment<3> found = align_shapes<3>(unlike, {}, options, notes);
  EXPECT_EQ(found.pairs.size(), static_cast<std::size_t>(found.summary->n_pairs));
}

TEST_F(AlignShapes, ATurnedPairMatchesAsWellAsTheOneThatLiesAsItBelongs) {
  const Similarity<3> by = motion(20);
  const Shape<3> target = moved(bent_, by);
  Notes notes;
  const MatchResult<3> straight = match_shapes(reference_, bent_, quick(AlignMode::automatic), notes);
  const MatchResult<3> result = match_shapes(reference_, target, quick(AlignMode::automatic), notes);
  const Correspondence<3> truth = truth_of_coarse_hands();
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

TEST_F(AlignShapes, AFloorOfOneShapeChangesLittle) {
  const Shape<3> turned = moved(bent_, motion(1));
  const Box<3> bounds = bounding_box(turned.surface.vertices);
  const double side = (bounds.max - bounds.min).maxCoeff();
  // Its area is more than that of the hand.
  const Vec<3> middle = (bounds.min + bounds.max) / 2, half(0.8 * side, 0.8 * side, 0.02 * side);
  const Vec<3> below(middle.x(), middle.y(), bounds.min.z() - 0.05 * side);
  const Surface<3> both = test::joined(turned.surface, test::box(below - half, below + half));
  OriginalShape<3> original;
  original.vertices = both.vertices;
  for (const auto& [a, b, c] : both.facets) original.polygons.push_back({a, b, c});
  Notes notes, with_floor;
  const ExperimentOptions options = quick(AlignMode::automatic);
  const Alignment<3> plain = align_shapes<3>({reference_, turned}, {}, options, notes);
  const Alignment<3> found =
      align_shapes<3>({reference_, make_shape(std::move(original), "scan")}, {}, options, with_floor);
  EXPECT_NE(with_floor.all.find("of the most alike component of scan alone"), std::string::npos) << with_floor.all;
  EXPECT_NEAR(static_cast<double>(found.pairs.size()), static_cast<double>(plain.pairs.size()), 10) << with_floor.all;
  EXPECT_NEAR(found.summary->angle, plain.summary->angle, 5);
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

TEST_F(AlignShapes, DoubtfulPairsAreUsedAndSaid) {
  Notes notes;
  const ShapePair<3> pair{reference_, moved(bent_, motion(1))};
  ExperimentOptions o = quick(AlignMode::automatic);
  o.align.doubtful_score = 0;
  const Alignment<3> found = align_shapes(pair, {}, o, notes);
  EXPECT_FALSE(found.pose.is_identity());
  EXPECT_GT(found.pairs.size(), 100u);
  EXPECT_TRUE(found.summary->doubtful);
  EXPECT_NE(notes.all.find("doubtful"), std::string::npos);
}

TEST_F(AlignShapes, LandmarksGiveThePose) {
  Observer quiet;
  std::vector<Landmark<3>> landmarks;
  const Similarity<3> by = motion(2);
  for (std::size_t i = 0; i < 5; ++i) {
    const Vec<3>& x = reference_.original.vertices[i * reference_.original.vertices.size() / 5];
    landmarks.push_back({std::to_string(i), x, by(x)});
  }
  const Alignment<3> found =
      align_shapes(ShapePair<3>{reference_, moved(reference_, by)}, landmarks, quick(AlignMode::landmarks), quiet);
  EXPECT_LT((found.pose.rotation - by.rotation).norm(), 1e-9);
  EXPECT_NEAR(found.pose.scale, 2, 1e-9);
  EXPECT_TRUE(found.pairs.empty());
  const std::string told = message_of<InputError>([&] {
    align_shapes(ShapePair<3>{reference_, bent_}, {}, quick(AlignMode::landmarks), quiet);
  });
  EXPECT_NE(told.find("landmarks.file"), std::string::npos) << told;
}

TEST_F(AlignShapes, WhereNoPairsAreUsedLandmarksTellThePose) {
  // Any rotation of a sphere onto a sphere is as good, but for landmarks.
  const Shape<3> sphere = std::get<Shape<3>>(open_shape("generate:sphere"));
  const Similarity<3> by = motion(20);
  const Shape<3> target = moved(sphere, by);
  std::vector<Landmark<3>> landmarks;
  for (const std::size_t v : {0u, 100u, 200u, 300u, 400u})
    landmarks.push_back({std::to_string(v), sphere.original.vertices[v], target.original.vertices[v]});
  Notes notes;
  const Alignment<3> found = align_shapes<3>({sphere, target}, landmarks, quick(AlignMode::automatic), notes);
  EXPECT_TRUE(found.pairs.empty());
  EXPECT_LT((found.pose.rotation - by.rotation).norm(), 1e-9);
  EXPECT_NEAR(found.pose.scale, 20, 1e-9);
  EXPECT_NE(notes.all.find("the pose is that of 5 landmarks"), std::string::npos) << notes.all;
  EXPECT_FALSE(found.summary->doubtful || found.summary->as_it_lies);
}

TEST_F(AlignShapes, CoordinatesTakenAsTheyAreStay) {
  ExperimentOptions o = quick(AlignMode::automatic);
  o.input.placement = PlacementKind::as_is;
  Notes notes;
  const Alignment<3> none = align_shapes(ShapePair<3>{reference_, moved(bent_, motion(1))}, {}, o, notes);
  EXPECT_TRUE(none.pose.is_identity());
  EXPECT_FALSE(none.summary);
  EXPECT_TRUE(notes.all.empty());
}

TEST(AlignRoundShapes, FindsAPoseWhereSpectraCannotTellTheSidesApart) {
  const Shape<3> ellipsoid = std::get<Shape<3>>(open_shape("generate:ellipsoid/long"));
  const Similarity<3> by{1, Vec<3>(0.1, 0, 0),
                         Eigen::AngleAxisd(0.7, Vec<3>(0.3, 1, 0.5).normalized()).toRotationMatrix()};
  Notes notes;
  ExperimentOptions o = quick(AlignMode::automatic);
  o.align.doubtful_margin = 1.2;  // half a turn of it ends as well but for a few per cent, which depend on rounding
  const Alignment<3> found = align_shapes(ShapePair<3>{moved(ellipsoid, by), ellipsoid}, {}, o, notes);
  EXPECT_TRUE(found.pairs.empty()) << notes.all;
  ASSERT_FALSE(found.summary->doubtful) << notes.all;
  // Half a turn about an axis of the ellipsoid changes nothing: each axis is to lie on itself.
  const Mat<3> both = found.pose.rotation * by.rotation;
  EXPECT_LT((both.cwiseAbs() - Mat<3>::Identity()).norm(), 0.02) << notes.all;
}

TEST(AlignOutlines, ATurnedLeafMatchesAsWellAsTheOneThatLiesAsItBelongs) {
  const Shape<2> deep = std::get<Shape<2>>(open_shape("generate:leaf/deep")),
                 shallow = std::get<Shape<2>>(open_shape("generate:leaf/shallow"));
  Similarity<2> by;
  by.rotation = Eigen::Rotation2Dd(2.3).toRotationMatrix();
  by.scale = 7;
  by.offset = Vec<2>(3, -1);
  OriginalShape<2> original = shallow.original;
  for (Vec<2>& x : original.vertices) x = by(x);
  const Shape<2> turned = make_shape(std::move(original), "turned");
  ExperimentOptions o = quick(AlignMode::automatic);
  o.cascade.max_level = 7;
  Notes notes;
  const Correspondence<2> truth = generated_correspondence<2>("generate:leaf/deep", "generate:leaf/shallow");
  const auto error = [&](const Shape<2>& target, const Similarity<2>& back) {
    std::vector<Vec<2>> ends;
    for (const Vec<2>& y : match_shapes(deep, target, o, notes).deformed.vertices) ends.push_back(back.inverse(y));
    return correspondence_error(truth, ends) / bounding_box(shallow.original.vertices).diagonal();
  };
  EXPECT_LT(error(shallow, {}), 0.004) << notes.all;
  EXPECT_LT(error(turned, by), 0.004) << notes.all;
  o.align.mode = AlignMode::none;
  EXPECT_GT(error(turned, by), 0.1);
}

TEST(AlignOutlines, CirclesStayWhereTheyAre) {
  const auto outline = [](const char* name) { return std::get<Shape<2>>(open_shape(name)); };
  Observer quiet;
  const Alignment<2> found = align_shapes(ShapePair<2>{outline("generate:circle"), outline("generate:ellipse/long")},
                                          {}, quick(AlignMode::automatic), quiet);
  EXPECT_TRUE(found.pose.is_identity());
  EXPECT_TRUE(found.pairs.empty());
}

TEST(MirroringPose, KeepsFacetsFacingOutward) {
  Surface<3> surface = coarse_hands().reference.surface;
  Similarity<3> mirror;
  mirror.rotation = Vec<3>(-1, 1, 1).asDiagonal();
  const auto volume = [](const Surface<3>& s) {
    double sum = 0;
    for (const auto& f : s.facets) sum += s.vertices[f[0]].dot(s.vertices[f[1]].cross(s.vertices[f[2]]));
    return sum;
  };
  const double before = volume(surface);
  apply_similarity(mirror, surface);
  EXPECT_NEAR(volume(surface) / before, 1, 1e-9);
}

}  // namespace
}  // namespace shellmatch
