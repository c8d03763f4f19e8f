// The true positions of the standard pairs: on the template, and rigid or affine where the motion is.
#include "base/error.h"
#include "geometry/generate/dolphin.h"
#include "geometry/generate/hand.h"
#include "geometry/distance/signed_distance.h"
#include "tests/geometry/generate/generated_surface.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace shellmatch {
namespace {

// Root of the mean squared distance of the true positions from the template's tessellation; -1 without any.
template <int Dim>
double distance_of_truth(const GeneratedPair<Dim>& pair) {
  EXPECT_NE(pair.reference.vertices.size(), pair.template_shape.vertices.size());
  if (pair.truth.empty()) return -1;
  for (std::size_t i = 0; i < pair.truth.size(); ++i) {
    EXPECT_LT(pair.truth[i].vertex, static_cast<Index>(pair.reference.vertices.size()));
    EXPECT_GT(pair.truth[i].vertex, i > 0 ? pair.truth[i - 1].vertex : no_index);
  }
  const SignedDistance<Dim> distance(as_surface(pair.template_shape));
  double sum = 0;
  for (const auto& known : pair.truth) sum += std::pow(distance(known.position), 2);
  return std::sqrt(sum / pair.truth.size());
}

class EveryPair : public testing::TestWithParam<GeneratorInfo> {};

TEST_P(EveryPair, TruthLiesOnTheTemplateToTheErrorOfItsTessellation) {
  const GeneratorInfo& info = GetParam();
  const double coarse = 1.8 * info.edge_length, fine = 0.9 * info.edge_length;
  const auto distance_at = [&](double edge) {
    return std::visit([](const auto& pair) { return distance_of_truth(pair); }, generated_pair(info.name, edge));
  };
  if (info.name == "beet" || info.name == "face") {
    EXPECT_EQ(distance_at(0.02), -1);
    return;
  }
  const double far = distance_at(coarse), near = distance_at(fine);
  EXPECT_GT(far, 0);
  EXPECT_LT(near, 0.05 * fine);
  // Second order: halving the edges quarters the distance, nearly so where the coarse edges hardly resolve
  // the details (teeth of the leaf, edges of the box).
  EXPECT_GT(std::log2(far / near), 1.4) << far << ' ' << near;
}

INSTANTIATE_TEST_SUITE_P(Catalogue, EveryPair, testing::ValuesIn(generator_catalogue()),
                         [](const auto& named) { return named.param.name; });

// Where a part that is left out would count, the function jumps.
TEST(HandFunction, HasNoJumps) {
  HandOptions options;
  options.bend_index = 40;
  const Hand hand(options);
  std::mt19937 random(5);
  std::uniform_real_distribution<double> coordinate(0.2, 0.8);
  const auto point = [&] { return Vec<3>(coordinate(random), coordinate(random), coordinate(random)); };
  constexpr int n_steps = 4000;
  for (int line = 0; line < 200; ++line) {
    const Vec<3> from = point(), step = (point() - from) / n_steps;
    for (int i = 0; i < n_steps; ++i) {
      const double change = std::abs(hand(from + (i + 1) * step) - hand(from + i * step));
      ASSERT_LE(change, 1.3 * step.norm() + 1e-12) << "at " << (from + i * step).transpose();
    }
  }
}

TEST(HandPair, FingersMoveRigidlyAndThePalmStays) {
  const auto pair = std::get<GeneratedPair<3>>(generated_pair("hand", 0.009));
  const Hand rest(HandOptions{});
  std::vector<std::vector<KnownPosition<3>>> parts(6);
  for (const auto& known : pair.truth) {
    const int part = rest.part_of(pair.reference.vertices[known.vertex]);
    ASSERT_GE(part, 0);
    parts[part].push_back(known);
  }
  EXPECT_GT(pair.truth.size(), pair.reference.vertices.size() / 2);
  const double degrees[] = {20, 25, 30, 25, 20, 0};
  for (int p = 0; p < 6; ++p) {
    ASSERT_GT(parts[p].size(), 100u) << "part " << p;
    const auto& first = parts[p].front();
    double farthest = 0, most_turned = 0;
    for (const auto& known : parts[p]) {
      const Vec<3> before = pair.reference.vertices[known.vertex] - pair.reference.vertices[first.vertex];
      const Vec<3> after = known.position - first.position;
      EXPECT_NEAR(before.norm(), after.norm(), 1e-12);
      if (before.norm() > farthest) {
        farthest = before.norm();
        most_turned = std::atan2(before.cross(after).norm(), before.dot(after)) * 180 / M_PI;
      }
    }
    // The farthest pair of points lies about along the finger, across the axis it turns about.
    EXPECT_NEAR(most_turned, degrees[p], 2) << "part " << p;
  }
}

TEST(BoxPair, IsAffine) {
  const auto pair = std::get<GeneratedPair<3>>(generated_pair("box", 0.03));
  ASSERT_EQ(pair.truth.size(), pair.reference.vertices.size());
  const double c = std::cos(25 * M_PI / 180), s = std::sin(25 * M_PI / 180);
  for (const auto& known : pair.truth) {
    const Vec<3> x = pair.reference.vertices[known.vertex].array() - 0.5;
    const Vec<3> expected(0.64 * c * x.x() - s * x.y(), 0.64 * s * x.x() + c * x.y(), x.z());
    EXPECT_LT((known.position.array() - 0.5 - expected.array()).matrix().norm(), 1e-12);
  }
}

TEST(DolphinPair, BendingKeepsCrossSectionsAndTheLengthOfTheSpine) {
  const Body<3> body = dolphin_body({.bend = 60, .sway = -30}, 0.03);
  std::mt19937 generator(4);
  std::uniform_real_distribution<double> along(0.1, 0.9), across(-0.15, 0.15);
  for (int i = 0; i < 100; ++i) {
    const double x = along(generator), h = 1e-5;
    const Vec<3> spine(x, 0.5, 0.48), offset(0, across(generator), across(generator));
    const Vec<3> image = body.pose(spine), arm = body.pose(spine + offset) - image;
    EXPECT_NEAR(arm.norm(), offset.norm(), 1e-9);
    const Vec<3> step = h * Vec<3>::UnitX();
    const Vec<3> tangent = (body.pose(spine + step) - body.pose(spine - step)) / (2 * h);
    EXPECT_NEAR(tangent.norm(), 1, 1e-6);
    EXPECT_NEAR(arm.dot(tangent), 0, 1e-6);
  }
  // The tail turns against the head by the angles asked for: straight pieces before 0.25 and after 0.9.
  const auto direction = [&](double x) -> Vec<3> {
    return (body.pose(Vec<3>(x + 1e-3, 0.5, 0.48)) - body.pose(Vec<3>(x, 0.5, 0.48))).normalized();
  };
  const double c = M_PI / 180;
  EXPECT_NEAR(direction(0.1).dot(direction(0.92)), std::cos(60 * c) * std::cos(30 * c), 1e-6);
}

TEST(DolphinPair, TurnsAboutTheUprightAxisThroughTheMiddle) {
  const auto at_rest = std::get<KnownPositions<3>>(known_positions("dolphin", "straight", "straight"));
  const auto turned = std::get<KnownPositions<3>>(known_positions("dolphin", "straight", "turned"));
  const auto reversed = std::get<KnownPositions<3>>(known_positions("dolphin", "straight", "reversed"));
  ASSERT_EQ(at_rest.size(), turned.size());
  ASSERT_GT(at_rest.size(), 1000u);
  const auto original = std::get<OriginalShape<3>>(generate_shape("dolphin", "turned"));
  const double c = std::cos(M_PI / 6), s = std::sin(M_PI / 6);
  for (std::size_t i = 0; i < at_rest.size(); ++i) {
    const Vec<3> x = at_rest[i].position.array() - 0.5, y = turned[i].position.array() - 0.5;
    EXPECT_LT((y - Vec<3>(c * x.x() - s * x.y(), s * x.x() + c * x.y(), x.z())).norm(), 1e-12);
    const Vec<3> z = reversed[i].position.array() - 0.5;
    EXPECT_LT((z - Vec<3>(-x.x(), -x.y(), x.z())).norm(), 1e-12);
    // The same vertices as those of the shape itself.
    EXPECT_LT((original.vertices[turned[i].vertex] - turned[i].position).norm(), 1e-12);
  }
}

TEST(Pairs, UnknownNameIsAnError) { EXPECT_THROW(generated_pair("cow"), InputError); }

}  // namespace
}  // namespace shellmatch
