#include "alignment/bend/bend_by_pairs.h"
#include "alignment/bend/deformation_graph.h"
#include "base/parallel.h"
#include "tests/geometry/generate/generated_surface.h"
#include "tests/geometry/surface/test_surfaces.h"

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

namespace shellmatch {
namespace {

const Surface<3>& rest_hand() {
  static const Surface<3> surface = generated_surface("hand", "", 0.03);
  return surface;
}

/// Rolled up by a right angle from one end to the other.
const Surface<3>& bent_hand() {
  static const Surface<3> surface = [] {
    Box<3> box;
    for (const Vec<3>& x : rest_hand().vertices) box.add(x);
    Eigen::Index along = 0, across = 0;
    (box.max - box.min).maxCoeff(&along);
    (box.max - box.min).minCoeff(&across);
    const double radius = (box.max - box.min)[along] / std::numbers::pi * 2;
    return test::mapped<3>(rest_hand(), [=](Vec<3> x) {
      const double angle = (x[along] - box.min[along]) / radius, height = radius - (x[across] - box.min[across]);
      x[along] = box.min[along] + height * std::sin(angle);
      x[across] = box.min[across] + radius - height * std::cos(angle);
      return x;
    });
  }();
  return surface;
}

std::vector<CorrespondingPoints> every(std::size_t step, const Surface<3>& from, const Surface<3>& to) {
  std::vector<CorrespondingPoints> pairs;
  for (std::size_t v = 0; v < from.vertices.size(); v += step) pairs.push_back({from.vertices[v], to.vertices[v]});
  return pairs;
}

double mean_distance(const std::vector<Vec<3>>& a, const std::vector<Vec<3>>& b) {
  double sum = 0;
  for (std::size_t v = 0; v < a.size(); ++v) sum += (a[v] - b[v]).norm() / static_cast<double>(a.size());
  return sum;
}

TEST(DeformationGraph, WeightsSumToOneAndEdgesMeasureTheArea) {
  const DeformationGraph graph(rest_hand(), 100);
  ASSERT_EQ(graph.centres().size(), 100u);
  for (Index v = 0; v < static_cast<Index>(rest_hand().vertices.size()); ++v) {
    const auto& weights = graph.influence(v).weights;
    EXPECT_NEAR(std::accumulate(weights.begin(), weights.end(), 0.0), 1, 1e-12);
    EXPECT_GE(*std::ranges::min_element(weights), 0);
  }
  double sum = 0;
  for (const auto& e : graph.edges()) sum += e.weight * (graph.centres()[e.from] - graph.centres()[e.to]).squaredNorm();
  EXPECT_NEAR(sum, 2 * surface_measure(rest_hand()), 1e-9);
}

TEST(DeformationGraph, NodesOfALimbThatTouchesAnotherDoNotMoveIt) {
  const Surface<3> one = test::unit_sphere(3);
  Surface<3> both = one;
  for (const Vec<3>& x : one.vertices) both.vertices.push_back(x + Vec<3>(2, 0, 0));
  const auto n = static_cast<Index>(one.vertices.size());
  for (const auto& f : one.facets) both.facets.push_back({f[0] + n, f[1] + n, f[2] + n});
  const DeformationGraph graph(both, 40);
  for (Index v = 0; v < 2 * n; ++v)
    for (std::size_t i = 0; i < DeformationGraph::n_influences; ++i) {
      const double x = graph.centres()[graph.influence(v).nodes[i]].x();
      EXPECT_TRUE(graph.influence(v).weights[i] == 0 || (v < n ? x < 1.0001 : x > 0.9999)) << v;
    }
}

TEST(BendByPairs, ThreePairsOfARigidMotionMoveAllOfItRigidly) {
  const Mat<3> turn = Eigen::AngleAxisd(0.6, Vec<3>(1, 2, -1).normalized()).toRotationMatrix();
  Surface<3> moved = rest_hand();
  for (Vec<3>& x : moved.vertices) x = turn * x + Vec<3>(0.1, 0.05, -0.1);
  const auto bent = bend_by_pairs(rest_hand(), every(rest_hand().vertices.size() / 3, rest_hand(), moved));
  EXPECT_LT(mean_distance(bent, moved.vertices), 0.01 * std::sqrt(surface_measure(rest_hand())));
}

TEST(BendByPairs, FingersBendByAFewPairs) {
  const double before = mean_distance(rest_hand().vertices, bent_hand().vertices);
  const auto bent = bend_by_pairs(rest_hand(), every(rest_hand().vertices.size() / 100, rest_hand(), bent_hand()));
  EXPECT_LT(mean_distance(bent, bent_hand().vertices), 0.1 * before) << before;
}

TEST(BendByPairs, PairsThatOthersContradictLoseTheirPull) {
  std::vector<CorrespondingPoints> pairs = every(rest_hand().vertices.size() / 100, rest_hand(), bent_hand());
  const double right = mean_distance(bend_by_pairs(rest_hand(), pairs), bent_hand().vertices);
  for (std::size_t i = 0; i < pairs.size(); i += 20) pairs[i].on_template = bent_hand().vertices[0];
  EXPECT_LT(mean_distance(bend_by_pairs(rest_hand(), pairs), bent_hand().vertices), 3 * right);
}

TEST(BendByPairs, AComponentWithoutPairsGoesAlong) {
  Surface<3> both = rest_hand();
  const auto n = static_cast<Index>(both.vertices.size());
  const Surface<3> ball = test::unit_sphere(2);
  for (const Vec<3>& x : ball.vertices) both.vertices.push_back(0.02 * x + both.vertices[0]);
  for (const auto& f : ball.facets) both.facets.push_back({f[0] + n, f[1] + n, f[2] + n});
  const Vec<3> shift(0.3, -0.2, 0.1);
  std::vector<CorrespondingPoints> pairs;
  for (Index v = 0; v < n; v += 40) pairs.push_back({both.vertices[v], both.vertices[v] + shift});
  const auto bent = bend_by_pairs(both, pairs);
  for (std::size_t v = static_cast<std::size_t>(n); v < bent.size(); ++v)
    EXPECT_LT((bent[v] - both.vertices[v] - shift).norm(), 0.02) << v;
}

TEST(BendByPairs, ThreadsDoNotChangeABit) {
  const auto pairs = every(rest_hand().vertices.size() / 50, rest_hand(), bent_hand());
  set_n_threads(1);
  const auto one = bend_by_pairs(rest_hand(), pairs);
  set_n_threads(3);
  EXPECT_EQ(bend_by_pairs(rest_hand(), pairs), one);
}

}  // namespace
}  // namespace shellmatch
