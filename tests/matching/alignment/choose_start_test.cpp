// Starts of a cascade are judged by the energy and the coverage that they reach.

#include "matching/alignment/choose_start.h"

#include "matching/alignment/trial.h"
#include "matching/experiment/generated_source.h"
#include "matching/experiment/shape_source.h"
#include "matching/result/correspondence.h"

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace shellmatch {
namespace {

template <int Dim>
ShapePair<Dim> generated(const std::string& reference, const std::string& target) {
  return {std::get<Shape<Dim>>(open_shape("generate:" + reference)), std::get<Shape<Dim>>(open_shape("generate:" + target))};
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

/// Every k-th vertex and where it belongs; both through `pose` first, so that with a turn the pairs are wrong, but fit the pose.
Start<3> hand_start(const ShapePair<3>& hands, const Similarity<3>& pose, double score) {
  const Correspondence<3> truth = generated_correspondence<3>("generate:hand", "generate:hand/bent");
  Start<3> start;
  const auto& x = hands.reference.original.vertices;
  const bool is_right = pose.is_identity();
  for (std::size_t i = 0; i < truth.size(); i += truth.size() / 100) {
    const Vec<3> from = x[truth[i].first];
    Vec<3> y = truth[i].second;
    if (!is_right) {  // the template's vertex nearest to the turned one
      const Vec<3> turned = pose(from);
      const auto& all = hands.template_shape.original.vertices;
      y = *std::min_element(all.begin(), all.end(),
                            [&](const Vec<3>& p, const Vec<3>& q) { return (p - turned).norm() < (q - turned).norm(); });
    }
    start.alignment.pairs.push_back({std::to_string(i), from, y});
  }
  start.n_pairs = start.alignment.pairs.size();
  start.alignment.pose = pose;
  start.score = score;
  return start;
}

TEST(ChooseStart, TheEnergyChoosesAmongScoresThatAreClose) {
  const ShapePair<3> hands = generated<3>("hand", "hand/bent");
  Observer quiet;
  const Start<3> wrong = hand_start(hands, half_turn(hands, 1), 0.30), right = hand_start(hands, {}, 0.33);
  const StartChoice choice = choose_start<3>(hands, {wrong, right}, 1.1, {}, quick(), quiet);
  EXPECT_EQ(choice.index, 1u);
  EXPECT_EQ(choice.n_tried, 2u);
  EXPECT_GT(choice.margin, 1.2);
  // A score that is clear enough is believed.
  ExperimentOptions o = quick();
  o.align.clear_margin = 1.05;
  const StartChoice by_score = choose_start<3>(hands, {wrong, right}, 1.1, {}, o, quiet);
  EXPECT_EQ(by_score.index, 0u);
  EXPECT_EQ(by_score.n_tried, 0u);
  EXPECT_EQ(by_score.margin, 1.1);
  EXPECT_TRUE(by_score.as_it_lies);  // but it is no better than what lies there
}

TEST(ChooseStart, WhatLiesAsItBelongsStaysUnlessAnotherPoseIsClearlyBetter) {
  Observer quiet;
  Start<3> turned;
  turned.n_pairs = 100;
  turned.score = 0.1;
  const ShapePair<3> boxes = generated<3>("sphere", "box/cube");
  turned.alignment.pose = half_turn(boxes, 0);
  EXPECT_TRUE(choose_start<3>(boxes, {turned}, 2, {}, quick(), quiet).as_it_lies);
  const ShapePair<3> dolphins = generated<3>("dolphin", "dolphin/reversed");
  turned.alignment.pose = half_turn(dolphins, 2);
  EXPECT_FALSE(choose_start<3>(dolphins, {turned}, 2, {}, quick(), quiet).as_it_lies);
  // What began as the shapes lie is not compared with them.
  turned.is_identity = true;
  EXPECT_FALSE(choose_start<3>(boxes, {turned}, 2, {}, quick(), quiet).as_it_lies);
}

TEST(Trial, ReportsEnergyAndCoverage) {
  Observer quiet;
  const ShapePair<3> hands = generated<3>("hand", "hand/bent");
  const Trial none = try_start<3>(hands, {}, {}, quick(), quiet), right = try_start(hands, hand_start(hands, {}, 1).alignment, {}, quick(), quiet);
  EXPECT_EQ(none.energy, none.with_pairs);
  EXPECT_GT(right.with_pairs, right.energy);
  EXPECT_GT(right.energy, 0);
  EXPECT_LT(right.uncovered, 0.02);
}

TEST(Trial, AStartThatLeavesTheDomainIsNone) {
  ExperimentOptions o = quick();
  o.input.placement = PlacementKind::as_is;
  Observer quiet;
  Alignment<2> far;
  far.pose.offset = Vec<2>(5, 0);
  const ShapePair<2> circles = generated<2>("circle", "ellipse");
  EXPECT_TRUE(std::isinf(try_start(circles, far, {}, o, quiet).with_pairs));
  EXPECT_TRUE(std::isfinite(try_start<2>(circles, {}, {}, o, quiet).with_pairs));
}

struct Stopped {};
struct Stopping final : Observer {
  void stage(const std::string&) override { throw Stopped(); }
};

TEST(Trial, CanBeStopped) {
  Stopping stopping;
  EXPECT_THROW(try_start<2>(generated<2>("circle", "ellipse"), {}, {}, quick(), stopping), Stopped);
}

}  // namespace
}  // namespace shellmatch
