// A matching that is solved from template to reference gives the inverse map back, in results, files and `apply`.

#include "matching/alignment/prepare_pair.h"

#include "base/error.h"
#include "geometry/repair/make_shape.h"
#include "geometry/surface/subdivision.h"
#include "matching/alignment/trial.h"
#include "matching/input/shape_source.h"
#include "matching/map_file/deformation_file.h"
#include "matching/match_shapes.h"
#include "matching/result/correspondence.h"
#include "matching/run_gradient_check.h"
#include "matching/run_matching.h"
#include "matching/write_result.h"
#include "tests/matching/alignment/coarse_hands.h"
#include "tests/matching/alignment/letter.h"
#include "tests/matching/output/temporary_folder.h"

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include <algorithm>

namespace shellmatch {
namespace {

using testing::letter;
using testing::message_of;
using testing::TemporaryFolder;

template <int Dim>
Shape<Dim> generated(const std::string& name) {
  return std::get<Shape<Dim>>(open_shape("generate:" + name));
}

ExperimentOptions options_to(int level, MatchDirection direction) {
  ExperimentOptions o = profile_defaults(Profile::standard);
  o.cascade.max_level = level;
  o.align.direction = direction;
  o.align.search.start_functions = 4;
  o.align.search.functions = 60;
  o.align.search.refined = 2;
  return o;
}

/// Turned, moved and enlarged.
template <int Dim>
Shape<Dim> moved(const Shape<Dim>& shape, const Similarity<Dim>& by) {
  OriginalShape<Dim> original;
  original.vertices = shape.original.vertices;
  original.polygons = shape.original.polygons;
  for (Vec<Dim>& x : original.vertices) x = by(x);
  return make_shape(std::move(original), "moved");
}

struct Words final : Observer {
  void note(const std::string& text) override { all += text + "\n"; }
  std::string all;
};

TEST(MatchBackward, AHandEndsWhereItBelongsAlsoWhereTheTemplateIsTurnedAndLarger) {
  const ShapePair<3> hands = testing::coarse_hands();
  const Shape<3>& hand = hands.reference;
  const Similarity<3> by{20, Vec<3>(3, -7, 1),
                         Eigen::AngleAxisd(3.0, Vec<3>(1, 0.4, -0.3).normalized()).toRotationMatrix()};
  const Shape<3> target = moved(hands.template_shape, by);
  const double diagonal = bounding_box(target.original.vertices).diagonal();
  Observer quiet;
  const MatchResult<3> r = match_shapes(hand, target, options_to(5, MatchDirection::backward), quiet);
  Correspondence<3> truth = testing::truth_of_coarse_hands();
  for (auto& [vertex, place] : truth) place = by(place);
  EXPECT_LT(correspondence_error(truth, r.deformed.vertices), 0.02 * diagonal);

  ASSERT_TRUE(r.map.is_backward);
  ASSERT_TRUE(r.summary.direction && r.summary.alignment);
  EXPECT_TRUE(r.summary.direction->backward);
  // The pose is that of the template onto the reference.
  EXPECT_NEAR(r.summary.alignment->scale, 0.05, 0.005);
  EXPECT_EQ(r.summary.reference.n_vertices, hand.surface.vertices.size());
  EXPECT_LT(r.summary.distance->deformed_to_template.mean, 2e-3);
  EXPECT_LT(r.summary.distance->template_to_deformed.mean, 2e-3);

  // What is said about vertices is in the unit of the template.
  const auto& attributes = r.deformed.attributes;
  const auto distance = std::find_if(attributes.begin(), attributes.end(),
                                     [](const auto& a) { return a.name == "distance_to_template"; });
  ASSERT_NE(distance, attributes.end());
  const SignedDistance<3> to_target(target.surface);
  for (std::size_t i = 0; i < r.deformed.vertices.size(); i += 97)
    EXPECT_NEAR(distance->values[i], std::abs(to_target(r.deformed.vertices[i])), 1e-6 * diagonal) << i;
  ASSERT_EQ(r.surfaces.deformed.vertices.size(), hand.surface.vertices.size());
}

TEST(MatchBackward, TheFileOfTheMapCarriesBothWays) {
  const TemporaryFolder tmp;
  const Shape<2> ellipse = generated<2>("ellipse/long"), circle = generated<2>("circle");
  Observer quiet;
  const ExperimentOptions o = options_to(6, MatchDirection::backward);
  const MatchResult<2> r = match_shapes(ellipse, circle, o, quiet);
  write_result_folder(r, o, tmp / "out");
  const Deformation<2> read = read_deformation<2>(tmp / "out");
  ASSERT_TRUE(read.is_backward);
  const PointMap<2> there(read, Toward::template_shape), back(read, Toward::reference);
  for (std::size_t i = 0; i < ellipse.original.vertices.size(); i += 7) {
    const Vec<2>& x = ellipse.original.vertices[i];
    const std::optional<Vec<2>> y = there(x);
    ASSERT_TRUE(y);
    EXPECT_LT((*y - r.deformed.vertices[i]).norm(), 1e-12);
    EXPECT_LT((*back(*y) - x).norm(), 1e-11);
  }
  EXPECT_LT(r.summary.distance->deformed_to_template.max, 2e-3);
}

TEST(MatchBackward, LandmarksAreThoseOfTheShapesAsGiven) {
  const Shape<2> ellipse = generated<2>("ellipse/long"), circle = generated<2>("circle");
  const auto highest = [](const Shape<2>& shape, int axis) {
    const auto& x = shape.original.vertices;
    return *std::max_element(x.begin(), x.end(), [&](const auto& a, const auto& b) { return a[axis] < b[axis]; });
  };
  // It turns the circle by a quarter.
  const std::vector<Landmark<2>> landmarks{{"tip", highest(circle, 0), highest(ellipse, 1)}};
  Observer quiet;
  ExperimentOptions o = options_to(5, MatchDirection::backward);
  o.align.mode = AlignMode::none;
  o.landmarks.weight = 10;
  const MatchResult<2> r = match_shapes(circle, ellipse, o, quiet, landmarks);
  const std::optional<Vec<2>> y = PointMap<2>(r.map, Toward::template_shape)(landmarks[0].on_reference);
  EXPECT_LT((*y - landmarks[0].on_template).norm(), 0.02);
  const Vec<2>& x = landmarks[0].on_reference;
  const std::optional<LandmarkSummary>& ends = r.summary.landmarks;
  ASSERT_TRUE(ends);
  EXPECT_NEAR(ends->max, (r.map.apply(landmarks[0].on_template) - x).norm() / *r.summary.template_diagonal, 1e-12);
  EXPECT_EQ(ends->farthest, "tip");
}

TEST(MatchBackward, ThePoseOfLandmarksCarriesTheTemplateOntoTheReference) {
  ShapePair<2> pair{generated<2>("circle"), generated<2>("ellipse/long")};
  Similarity<2> by;
  by.rotation = Eigen::Rotation2Dd(1.2).toRotationMatrix();
  by.scale = 3;
  std::vector<Landmark<2>> landmarks;
  for (std::size_t i = 0; i < 3; ++i) {
    const Vec<2>& x = pair.reference.original.vertices[i * pair.reference.original.vertices.size() / 3];
    landmarks.push_back({std::to_string(i), x, by(x)});
  }
  ExperimentOptions o = options_to(4, MatchDirection::backward);
  o.align.mode = AlignMode::landmarks;
  o.landmarks.max_distance = 10;  // they lie on no ellipse
  Words notes;
  const Similarity<2> pose = prepare_pair(pair, landmarks, o, notes).alignment.pose;
  for (const Landmark<2>& l : landmarks) EXPECT_LT((pose(l.on_template) - l.on_reference).norm(), 1e-9);
  EXPECT_NE(notes.all.find("the template is turned by 69 degrees"), std::string::npos) << notes.all;
}

TEST(MatchBackward, DerivativesAreCheckedWhereTheMatchingEnded) {
  const TemporaryFolder tmp;
  ExperimentOptions o = options_to(5, MatchDirection::backward);
  o.input.reference = "generate:circle";
  o.input.template_file = "generate:ellipse/long";
  Observer quiet;
  run_matching(o, tmp / "out", {}, quiet);
  GradientCheckRequest request;
  request.state = CheckState::parse(tmp / "out");
  EXPECT_TRUE(run_gradient_check(o, request, quiet).passed());
  // The map of the other direction is no state of this problem.
  o.align.direction = MatchDirection::forward;
  const std::string told = message_of<InputError>([&] { run_gradient_check(o, request, quiet); });
  EXPECT_NE(told.find("align.direction"), std::string::npos) << told;
}

TEST(ChooseDirection, TakesTheOneThatBringsTheShapesCloser) {
  const auto direction_of = [](const Shape<2>& reference, const Shape<2>& target, MatchDirection wanted, Words& notes) {
    ShapePair<2> pair{reference, target};
    const PreparedPair<2> prepared = prepare_pair(pair, {}, options_to(4, wanted), notes);
    EXPECT_EQ(pair.reference.original.vertices.size(), reference.original.vertices.size());
    EXPECT_EQ(pair.reference.original.vertices[60], reference.original.vertices[60]);  // in the order given
    if (wanted == MatchDirection::automatic) {
      const DirectionSummary& d = *prepared.direction;
      EXPECT_TRUE(d.forward_distance && d.backward_distance && d.forward_energy && d.backward_energy);
      EXPECT_EQ(d.backward, *d.backward_distance * std::sqrt(*d.backward_energy) <
                                0.985 * *d.forward_distance * std::sqrt(*d.forward_energy));
    } else {
      EXPECT_FALSE(prepared.direction && prepared.direction->forward_distance);
    }
    return prepared.is_backward();
  };
  // Limbs that touch cannot be moved apart.
  Words notes;
  EXPECT_TRUE(direction_of(letter(0.04), letter(0.4), MatchDirection::automatic, notes));
  EXPECT_NE(notes.all.find("direction: the template is deformed"), std::string::npos) << notes.all;
  EXPECT_FALSE(direction_of(letter(0.4), letter(0.04), MatchDirection::automatic, notes));
  EXPECT_NE(notes.all.find("direction: the reference is deformed"), std::string::npos) << notes.all;
  EXPECT_TRUE(direction_of(letter(0.4), letter(0.04), MatchDirection::backward, notes));
  EXPECT_FALSE(direction_of(letter(0.04), letter(0.4), MatchDirection::forward, notes));
}

TEST(ChooseDirection, IsForwardWhereNothingLeadsLimbs) {
  ShapePair<2> pair{letter(0.04), letter(0.4)};
  ExperimentOptions o = options_to(4, MatchDirection::automatic);
  o.align.mode = AlignMode::none;
  Words notes;
  EXPECT_FALSE(prepare_pair(pair, {}, o, notes).is_backward());
  EXPECT_EQ(notes.all, "");
}

TEST(ChooseDirection, TheInverseAlignmentIsThatOfTheShapesInTheOtherOrder) {
  Alignment<2> found;
  found.pose = {20, Vec<2>(3, -7), Eigen::Rotation2Dd(1.2).toRotationMatrix()};
  found.pairs.push_back({"a", Vec<2>(1, 2), Vec<2>(-3, 4)});
  found.summary.emplace().scale = 20;
  const Alignment<2> other = inverse(found);
  EXPECT_LT((other.pose(found.pose(Vec<2>(1, 2))) - Vec<2>(1, 2)).norm(), 1e-13);
  EXPECT_EQ(other.pairs[0].on_reference, Vec<2>(-3, 4));
  EXPECT_EQ(other.pairs[0].on_template, Vec<2>(1, 2));
  EXPECT_NEAR(other.summary->scale, 0.05, 1e-15);
  EXPECT_TRUE(inverse(Similarity<2>{}).is_identity());
}

TEST(ChooseDirection, TheAlignmentIsThatOfTheDirectionTaken) {
  const Similarity<2> by{20, Vec<2>(3, -7), Eigen::Rotation2Dd(1.2).toRotationMatrix()};
  for (const bool first : {false, true}) {
    ShapePair<2> pair{letter(first ? 0.04 : 0.4), moved(letter(first ? 0.4 : 0.04), by)}, same = pair;
    Words notes, of_same;
    const PreparedPair<2> chosen = prepare_pair(pair, {}, options_to(5, MatchDirection::automatic), notes);
    const bool backward = chosen.is_backward();
    const PreparedPair<2> asked =
        prepare_pair(same, {}, options_to(5, backward ? MatchDirection::backward : MatchDirection::forward), of_same);
    EXPECT_EQ(chosen.alignment.pose.scale, asked.alignment.pose.scale);
    EXPECT_EQ(chosen.alignment.pose.rotation, asked.alignment.pose.rotation);
    EXPECT_EQ(chosen.alignment.pairs.size(), asked.alignment.pairs.size());
    EXPECT_EQ(chosen.placement.scale, asked.placement.scale);
    EXPECT_EQ(pair.reference.surface.vertices, same.reference.surface.vertices);
    // In diagonals of the shape that is not carried, whatever its unit.
    const DirectionSummary& d = *chosen.direction;
    EXPECT_LT(std::max(*d.forward_distance, *d.backward_distance), 0.1);
    // What was found is said once, and of the shape that moves.
    EXPECT_EQ(notes.all.find("alignment: "), notes.all.rfind("alignment: ")) << notes.all;
    EXPECT_NE(notes.all.find(backward ? "the template is turned" : "the reference is turned"), std::string::npos)
        << notes.all;
  }
}

TEST(ChooseDirection, LandmarksAreThoseOfTheShapesAsGiven) {
  const Similarity<2> by{20, Vec<2>(3, -7), Eigen::Rotation2Dd(1.2).toRotationMatrix()};
  ShapePair<2> pair{letter(0.04), moved(letter(0.4), by)};
  std::vector<Landmark<2>> landmarks;
  for (std::size_t i = 0; i < pair.reference.original.vertices.size(); i += 20)
    landmarks.push_back(
        {std::to_string(i), pair.reference.original.vertices[i], pair.template_shape.original.vertices[i]});
  ExperimentOptions o = options_to(4, MatchDirection::automatic);
  o.align.mode = AlignMode::landmarks;
  Words notes;
  const PreparedPair<2> prepared = prepare_pair(pair, landmarks, o, notes);
  EXPECT_TRUE(prepared.is_backward()) << notes.all;
  EXPECT_NE(notes.all.find("the template is turned"), std::string::npos) << notes.all;
  EXPECT_EQ(notes.all.find("the reference is turned"), std::string::npos) << notes.all;
  for (const Landmark<2>& l : landmarks)
    EXPECT_LT((prepared.alignment.pose(l.on_template) - l.on_reference).norm(), 0.5) << l.name;
}

TEST(ChooseDirection, TrialsMeasureTheShapeThatTheUserCallsReference) {
  // Of a circle that lies within an ellipse: the distance between both after each direction, in diagonals of the shape
  // that is not carried.
  const ShapePair<2> pair{generated<2>("circle"), generated<2>("ellipse/long")};
  const ExperimentOptions o = options_to(5, MatchDirection::forward);
  Observer quiet;
  const Trials<2> trials(pair, {}, o, quiet);
  const DirectionTrial carried = trials.of_direction({}, Carried::reference),
                       inverse = trials.of_direction({}, Carried::template_shape);
  EXPECT_LT(carried.distance, 0.02);
  EXPECT_LT(inverse.distance, 0.05);
  EXPECT_NE(carried.distance, inverse.distance);
  EXPECT_EQ(carried.energy, inverse.energy);  // of the same map
  EXPECT_EQ(carried.energy, trials({}).energy);
  EXPECT_GT(carried.distance, trials({}).template_distance);  // that, and the way back
  Alignment<2> far;
  far.pose.scale = 100;
  EXPECT_FALSE(trials.of_direction(far, Carried::reference).distance < 0.1);
}

// Coarse grids tell no difference.
TEST(ChooseDirection, LargeSurfacesAreTriedSimplified) {
  ShapePair<3> pair{generated<3>("sphere"), generated<3>("ellipsoid/long")}, large = pair;
  for (Shape<3>* shape : {&large.reference, &large.template_shape})
    while (shape->surface.facets.size() <= 200'000) cut_long_edges(shape->surface, 0);
  ExperimentOptions o = options_to(4, MatchDirection::forward);
  Observer quiet;
  const DirectionTrial of_small = Trials<3>(pair, {}, o, quiet).of_direction({}, Carried::reference);
  const Trials<3> trials(large, {}, o, quiet);
  const DirectionTrial of_large = trials.of_direction({}, Carried::reference);
  const DirectionTrial exchanged = trials.of_exchanged_shapes().of_direction({}, Carried::reference);
  std::swap(pair.reference, pair.template_shape);
  const DirectionTrial of_exchanged = Trials<3>(pair, {}, o, quiet).of_direction({}, Carried::reference);
  EXPECT_NEAR(exchanged.energy, of_exchanged.energy, 0.02 * of_exchanged.energy);
  EXPECT_GT(std::abs(exchanged.energy - of_small.energy), 0.02 * of_small.energy);
  EXPECT_NEAR(of_large.energy, of_small.energy, 0.02 * of_small.energy);
  EXPECT_NEAR(of_large.distance, of_small.distance, 0.1 * of_small.distance);
}

}  // namespace
}  // namespace shellmatch
