// Starts of a cascade are judged by the energy and the coverage that they reach.

#include "matching/alignment/choose_start.h"

#include "matching/input/shape_source.h"
#include "matching/result/correspondence.h"
#include "tests/matching/alignment/coarse_hands.h"

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace shellmatch {
namespace {

template <int Dim>
ShapePair<Dim> generated(const std::string& reference, const std::string& target) {
  return {std::get<Shape<Dim>>(open_shape("generate:" + reference)),
          std::get<Shape<Dim>>(open_shape("generate:" + target))};
}

ExperimentOptions quick() {
  ExperimentOptions o = profile_defaults(Profile::standard);
  o.cascade.max_level = 5;
  return o;
}

/// Half a turn about an axis through the middle of the template.
Similarity<3> half_turn(const ShapePair<3>& shapes, int axis) {
  Similarity<3> pose;
  pose.rotation = Eigen::AngleAxisd(EIGEN_PI, Vec<3>::Unit(axis)).toRotationMatrix();
  const Box<3> box = bounding_box(shapes.reference.original.vertices);
  const Vec<3> centre = 0.5 * (box.min + box.max);
  pose.offset = centre - pose.rotation * centre;
  return pose;
}

/// Every k-th vertex and where it belongs; both through `pose` first, so that with a turn the pairs are wrong, but fit
/// the pose.
Start<3> hand_start(const ShapePair<3>& hands, const Similarity<3>& pose, double score) {
  const Correspondence<3> truth = testing::truth_of_coarse_hands();
  Start<3> start;
  const auto& x = hands.reference.original.vertices;
  const bool is_right = pose.is_identity();
  for (std::size_t i = 0; i < truth.size(); i += truth.size() / 100) {
    const Vec<3> from = x[truth[i].first];
    Vec<3> y = truth[i].second;
    if (!is_right) {  // the template's vertex nearest to the turned one
      const Vec<3> turned = pose(from);
      const auto& all = hands.template_shape.original.vertices;
      y = *std::min_element(all.begin(), all.end(), [&](const Vec<3>& p, const Vec<3>& q) {
        return (p - turned).norm() < (q - turned).norm();
      });
    }
    start.alignment.pairs.push_back({std::to_string(i), from, y});
  }
  start.n_pairs = start.alignment.pairs.size();
  start.alignment.pose = pose;
  start.score = score;
  return start;
}

template <int Dim>
StartChoice choice_of(const ShapePair<Dim>& shapes, const std::vector<Start<Dim>>& starts, double margin,
                      const ExperimentOptions& options, bool landmarks_are_spread = false, bool is_ambiguous = false,
                      bool is_of_part = false) {
  Observer quiet;
  const std::vector<Landmark<Dim>> no_landmarks;
  Trials<Dim> trials(shapes, no_landmarks, options, quiet);
  StartSearch<Dim> search{starts, margin, landmarks_are_spread};
  search.is_ambiguous = is_ambiguous;
  search.is_of_part = is_of_part;
  return choose_start<Dim>(search, options.align, trials);
}

TEST(ChooseStart, OfSurfacesTheFirstIsChosenWithoutTrials) {
  const ShapePair<3> hands = testing::coarse_hands();
  const Start<3> wrong = hand_start(hands, half_turn(hands, 1), 0.33);
  Start<3> right = hand_start(hands, {}, 0.33);
  right.margin = 1.2;  // beside the other
  const StartChoice clear = choice_of<3>(hands, {right, wrong}, 1.3, quick());
  EXPECT_EQ(clear.index, 0u);
  EXPECT_EQ(clear.n_tried, 0u);
  EXPECT_EQ(clear.margin, 1.3);
  EXPECT_FALSE(clear.is_doubtful);
  EXPECT_FALSE(clear.as_it_lies) << "clear enough to be believed";
  // What is not clear has to be better than the shapes as they lie.
  EXPECT_TRUE(choice_of<3>(hands, {wrong, right}, 1.1, quick()).as_it_lies);
}

TEST(ChooseStart, WhereDescriptorsLeaveItOpenTheLikenessAfterATrialDecides) {
  const ShapePair<3> hands = testing::coarse_hands();
  Start<3> wrong = hand_start(hands, half_turn(hands, 1), 0.33), right = hand_start(hands, {}, 0.33);
  wrong.order = 0.2;
  right.order = 0.21;
  const StartChoice second = choice_of<3>(hands, {wrong, right}, 1.05, quick());
  EXPECT_EQ(second.index, 1u);
  EXPECT_EQ(second.n_tried, 2u);
  EXPECT_EQ(choice_of<3>(hands, {right, wrong}, 1.05, quick()).index, 0u);
  EXPECT_EQ(choice_of<3>(hands, {wrong, right}, 1.05, quick(), false, false, true).index, 0u) << "not of parts";
  right.margin = 1.2;  // not among the close ones
  EXPECT_EQ(choice_of<3>(hands, {wrong, right}, 1.05, quick()).index, 0u);
  EXPECT_EQ(choice_of<3>(hands, {wrong, right}, 1.2, quick()).index, 0u);
}

TEST(ChooseStart, DoubtfulPairsAreUsedWhereTheyAreBetterThanNone) {
  const ShapePair<3> dolphins = generated<3>("dolphin", "dolphin/reversed");
  Start<3> turned;
  turned.n_pairs = 100;
  turned.score = 2;
  turned.alignment.pose = half_turn(dolphins, 2);
  const StartChoice choice = choice_of<3>(dolphins, {turned}, 2, quick());
  EXPECT_TRUE(choice.is_doubtful);
  EXPECT_TRUE(choice.is_usable);
  EXPECT_FALSE(choice.as_it_lies);
  EXPECT_FALSE(choice_of<3>(dolphins, {turned}, 2, quick(), false, true).is_usable) << "any rotation may be as good";
}

TEST(ChooseStart, WhatLiesAsItBelongsStaysUnlessAnotherPoseIsClearlyBetter) {
  Start<3> turned;
  turned.n_pairs = 100;
  turned.score = 0.1;
  const ShapePair<3> boxes = generated<3>("sphere", "box/cube");
  turned.alignment.pose = half_turn(boxes, 0);
  EXPECT_TRUE(choice_of<3>(boxes, {turned}, 1.1, quick()).as_it_lies);
  const ShapePair<3> dolphins = generated<3>("dolphin", "dolphin/reversed");
  turned.alignment.pose = half_turn(dolphins, 2);
  EXPECT_FALSE(choice_of<3>(dolphins, {turned}, 1.1, quick()).as_it_lies);
  // What began as the shapes lie is not compared with them.
  turned.is_identity = true;
  EXPECT_FALSE(choice_of<3>(boxes, {turned}, 1.1, quick()).as_it_lies);
}

TEST(ChooseStart, LandmarksAllOverTheShapeTellThatItDoesNotLieAsItBelongs) {
  const ShapePair<3> boxes = generated<3>("sphere", "box/cube");
  Start<3> turned;
  turned.n_pairs = 100;
  turned.score = 0.1;
  turned.alignment.pose = half_turn(boxes, 0);
  const auto as_it_lies = [&](double landmark_distance, bool landmarks_are_spread) {
    turned.landmark_distance = landmark_distance;
    return choice_of<3>(boxes, {turned}, 1.1, quick(), landmarks_are_spread).as_it_lies;
  };
  EXPECT_FALSE(as_it_lies(0.05, true));
  EXPECT_TRUE(as_it_lies(0.05, false)) << "those on one part do not";
}

TEST(ChooseStart, LandmarksAllOverTheShapeChooseTheStartThatTheyAgreeWith) {
  const ShapePair<3> boxes = generated<3>("sphere", "box/cube");
  Start<3> wrong, right;
  wrong.n_pairs = right.n_pairs = 100;
  wrong.score = 0.5, right.score = 0.6;
  wrong.landmark_distance = 0.4, right.landmark_distance = 0.05;
  EXPECT_EQ(choice_of<3>(boxes, {wrong, right}, 1.1, quick(), true).index, 1u);
  EXPECT_EQ(choice_of<3>(boxes, {wrong, right}, 1.1, quick(), false).index, 0u) << "those on one part do not";
}

/// A start in the plane that is as good as its score says, of the shapes as they lie.
Start<2> scored(double score, std::size_t n_pairs = 100) {
  Start<2> start;
  start.score = score;
  start.n_pairs = n_pairs;
  start.is_identity = true;
  return start;
}

TEST(ChooseStart, TooFewPairsAreNeverChosenAndHideNothing) {
  const ShapePair<2> circles = generated<2>("circle", "ellipse");
  const StartChoice choice = choice_of<2>(circles, {scored(0.1, 3), scored(0.5)}, 5, quick());
  EXPECT_EQ(choice.index, 1u);
  EXPECT_FALSE(choice.is_doubtful);
  EXPECT_TRUE(choice_of<2>(circles, {scored(0.1, 3), scored(0.5, 9)}, 5, quick()).is_doubtful);
}

TEST(ChooseStart, ThePreferredFirstIsTriedWithThoseThatScoreAsWell) {
  const ShapePair<2> circles = generated<2>("circle", "ellipse");
  // Both are the same start: the one that is preferred stays, though its score is a little larger.
  Start<2> other = scored(0.50);
  other.is_identity = false;
  const StartChoice choice = choice_of<2>(circles, {scored(0.51), other, scored(0.8)}, 0.98, quick());
  EXPECT_EQ(choice.index, 0u);
  EXPECT_EQ(choice.n_tried, 2u);
  EXPECT_NEAR(choice.margin, 0.50 / 0.51, 1e-12);  // they reach the same energy
  ExperimentOptions o = quick();
  o.align.clear_margin = 1;  // the score alone
  EXPECT_EQ(choice_of<2>(circles, {scored(0.51), other, scored(0.8)}, 0.98, o).n_tried, 0u);
}

TEST(ChooseStart, ThePreferredFirstIsTriedHoweverMuchLargerItsScoreIs) {
  const ShapePair<2> circles = generated<2>("circle", "ellipse");
  Start<2> other = scored(0.50);
  other.is_identity = false;
  const StartChoice choice = choice_of<2>(circles, {scored(0.70), other}, 0.7, quick());
  EXPECT_EQ(choice.n_tried, 2u);
  EXPECT_EQ(choice.index, 1u);
  ExperimentOptions o = quick();
  o.align.search.identity_preference = 2;
  EXPECT_EQ(choice_of<2>(circles, {scored(0.70), other}, 0.7, o).index, 0u);
}

TEST(ChooseStart, LandmarksTellWhetherPairsAreRight) {
  const ShapePair<2> circles = generated<2>("circle", "ellipse");
  const auto is_doubtful = [&](double score, std::optional<double> landmark_distance, bool landmarks_are_spread) {
    Start<2> start = scored(score);
    start.landmark_distance = landmark_distance;
    return choice_of<2>(circles, {start}, 5, quick(), landmarks_are_spread).is_doubtful;
  };
  EXPECT_TRUE(is_doubtful(1.5, {}, false));
  EXPECT_FALSE(is_doubtful(1.5, 0.05, true));
  EXPECT_TRUE(is_doubtful(1.5, 0.05, false)) << "those on one part do not acquit";
  EXPECT_FALSE(is_doubtful(0.3, {}, false));
  EXPECT_TRUE(is_doubtful(0.3, 0.4, true));
  EXPECT_TRUE(is_doubtful(0.3, 0.4, false)) << "but condemn";
}

TEST(ChooseStart, AMirrorImageThatIsAsGoodIsNoDoubt) {
  const ShapePair<2> circles = generated<2>("circle", "ellipse");
  Start<2> other = scored(0.50);
  other.is_identity = false;
  const double clear = 5;  // of the search
  EXPECT_TRUE(choice_of<2>(circles, {scored(0.50), other}, clear, quick()).is_doubtful);
  other.is_mirrored = true;
  const StartChoice choice = choice_of<2>(circles, {scored(0.50), other, scored(0.8)}, clear, quick());
  EXPECT_EQ(choice.n_tried, 2u);
  EXPECT_FALSE(choice.is_doubtful);
  EXPECT_NEAR(choice.margin, 1.6, 1e-12);
  const StartChoice ambiguous = choice_of<2>(circles, {scored(0.50), other, scored(0.8)}, clear, quick(), false, true);
  EXPECT_EQ(ambiguous.margin, 1);
  EXPECT_TRUE(ambiguous.is_doubtful);
}

TEST(Trial, ReportsEnergyAndCoverage) {
  Observer quiet;
  const ShapePair<3> hands = testing::coarse_hands();
  const std::vector<Landmark<3>> no_landmarks;
  const ExperimentOptions o = quick();
  Trials<3> trials(hands, no_landmarks, o, quiet);
  const Trial none = trials.as_they_lie(), right = trials(hand_start(hands, {}, 1).alignment);
  EXPECT_EQ(none.energy, none.with_pairs);
  EXPECT_GT(right.with_pairs, right.energy);
  EXPECT_GT(right.energy, 0);
  EXPECT_LT(right.template_distance, 0.02);
}

TEST(Trial, GivesLandmarksTheirWholeWeight) {
  const ShapePair<2> shapes = generated<2>("circle", "ellipse");
  const std::vector<Landmark<2>> noisy{
      {"a", shapes.reference.original.vertices[0], shapes.template_shape.original.vertices[5]}};
  const ExperimentOptions options = quick();
  Observer quiet;
  const Trials<2> trials(shapes, noisy, options, quiet);
  Alignment<2> start;
  start.pairs = {{"b", shapes.reference.original.vertices[9], shapes.template_shape.original.vertices[9]}};
  start.landmark_trust = 1;
  Alignment<2> distrusted = start;
  distrusted.landmark_trust = 0.01;
  EXPECT_EQ(trials(distrusted).energy, trials(start).energy);
}

class TrialOfCircles : public ::testing::Test {
 protected:
  Trial tried(const Alignment<2>& start, const ExperimentOptions& options, Observer& observer) {
    return Trials<2>(circles_, {}, options, observer)(start);
  }
  const ShapePair<2> circles_ = generated<2>("circle", "ellipse");
};

TEST_F(TrialOfCircles, AStartThatLeavesTheDomainIsNone) {
  ExperimentOptions o = quick();
  o.input.placement = PlacementKind::as_is;
  Observer quiet;
  Alignment<2> far;
  far.pose.offset = Vec<2>(5, 0);
  EXPECT_TRUE(std::isinf(tried(far, o, quiet).with_pairs));
  EXPECT_TRUE(std::isfinite(tried({}, o, quiet).with_pairs));
}

struct Counting final : Observer {
  void trial_iterated() override { ++n; }
  bool iterated(const LevelStart&, const IterationRecord&) override {
    throw std::logic_error("a trial is no level of the run");
  }
  int n = 0;
};

TEST_F(TrialOfCircles, OptionsOfItsLevelsDoNotMakeItLonger) {
  ExperimentOptions o = quick();
  o.solver.levels.entries.push_back({1, 15, {}});
  o.solver.levels.entries.back().set("name", {std::string("fletcher_reeves")});
  o.solver.levels.entries.back().set("stop.max_iterations", {5000});
  o.solver.levels.entries.back().set("stop.relative_decrease", {0.0});
  Counting counting;
  tried({}, o, counting);
  EXPECT_GT(counting.n, 20);
  EXPECT_LE(counting.n, 80 * 2 * o.cascade.nu_substeps);
}

struct Stopped {};
struct Stopping final : Observer {
  void trial_iterated() override { throw Stopped(); }
};

TEST_F(TrialOfCircles, CanBeStopped) {
  Stopping stopping;
  EXPECT_THROW(tried({}, quick(), stopping), Stopped);
}

}  // namespace
}  // namespace shellmatch
