// Pairs between outlines and their turned, scaled, renumbered and mirrored selves; symmetric ones stay; real hands and
// leaves.
#include "alignment/outline/find_outline_pairs.h"
#include "alignment/pose/fit_pose.h"
#include "base/error.h"
#include "base/parallel.h"
#include "geometry/io/read_shape.h"
#include "tests/geometry/generate/generated_surface.h"
#include "tests/geometry/surface/test_surfaces.h"
#include "tests/support/folders.h"

#include <Eigen/LU>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace shellmatch {
namespace {

constexpr double degree = std::numbers::pi / 180;

Similarity<2> similarity(double angle, double scale = 1, Vec<2> offset = Vec<2>::Zero()) {
  Similarity<2> pose{scale, offset, {}};
  pose.rotation << std::cos(angle), -std::sin(angle), std::sin(angle), std::cos(angle);
  return pose;
}

Surface<2> moved(Surface<2> outline, const Similarity<2>& pose) {
  apply_similarity(pose, outline);
  return outline;
}

/// The outline with its vertices counted from another one on.
Surface<2> renumbered(const Surface<2>& outline, Index by) {
  const auto n = static_cast<Index>(outline.vertices.size());
  Surface<2> result = outline;
  for (Index v = 0; v < n; ++v) result.vertices[(v + by) % n] = outline.vertices[v];
  for (auto& facet : result.facets)
    for (Index& v : facet) v = (v + by) % n;
  std::rotate(result.facets.begin(), result.facets.begin() + 3, result.facets.end());
  return result;
}

double turn_of(const Similarity<2>& pose) { return std::atan2(pose.rotation(1, 0), pose.rotation(0, 0)); }

/// Greatest distance of a pair from the motion, in diagonals of the template.
double greatest_error(const OutlinePairs& found, const Surface<2>& template_outline, const Similarity<2>& motion) {
  double greatest = 0;
  for (const auto& pair : found.pairs())
    greatest = std::max(greatest, (motion(pair.on_reference) - pair.on_template).norm());
  return greatest / bounding_box(template_outline.vertices).diagonal();
}

const Surface<2>& leaf() {
  static const Surface<2> outline = generated_outline("leaf", "", 0.004);
  return outline;
}

TEST(FindOutlinePairs, AMovedLeafIsFoundPointByPoint) {
  for (const double angle : {17.0, 90.0, 180.0, -135.0}) {
    const Similarity<2> motion = similarity(angle * degree, 40, {3, -8});
    const Surface<2> other = renumbered(moved(leaf(), motion), 201);
    const OutlinePairs found = find_outline_pairs(leaf(), other);
    EXPECT_GE(found.pairs().size(), 250u);
    EXPECT_LT(greatest_error(found, other, motion), 0.004) << angle;
    EXPECT_LT(found.candidates[0].score, 0.02);
    EXPECT_GT(found.margin, 5);
    EXPECT_TRUE(std::isfinite(found.margin));
    EXPECT_NEAR(found.candidates[0].pose.scale, 40, 0.04);
    EXPECT_LT((found.candidates[0].pose.rotation - motion.rotation).norm(), 1e-3);
    EXPECT_EQ(found.candidates[0].is_identity, angle == 17.0);
  }
}

TEST(FindOutlinePairs, AnotherLeafIsTurnedAsThisOne) {
  const Surface<2> other = generated_outline("leaf", "shallow", 0.005);
  const OutlinePairs as_it_lies = find_outline_pairs(leaf(), other);
  EXPECT_TRUE(as_it_lies.candidates[0].is_identity);
  EXPECT_LT(std::abs(turn_of(as_it_lies.candidates[0].pose)), 10 * degree);
  for (const double angle : {150.0, -100.0}) {
    const OutlinePairs found = find_outline_pairs(moved(leaf(), similarity(-angle * degree)), other);
    EXPECT_NEAR(
        std::remainder(turn_of(found.candidates[0].pose) - turn_of(as_it_lies.candidates[0].pose) - angle * degree,
                       2 * std::numbers::pi),
        0, 2 * degree);
    EXPECT_GT(found.margin, 1.3);
  }
}

TEST(FindOutlinePairs, WhatIsSymmetricStaysAsItLies) {
  for (const auto& [name, variant] : {std::pair("circle", ""), {"ellipse", "long"}, {"star", ""}}) {
    const Surface<2> reference = generated_outline(name, variant, 0.01);
    // The same shape from other vertices, of another size: a circle of another radius, a larger star.
    const Surface<2> other =
        renumbered(moved(generated_outline(name, variant, 0.013), similarity(0, 1.2, {0.1, 0.3})), 11);
    const OutlinePairs found = find_outline_pairs(reference, other);
    EXPECT_TRUE(found.candidates[0].is_identity) << name;
    EXPECT_LT(std::abs(turn_of(found.candidates[0].pose)), 0.5 * degree) << name;
    EXPECT_LT(greatest_error(found, other, similarity(0, 1.2, {0.1, 0.3})), 0.03) << name;
  }
}

TEST(FindOutlinePairs, AStarTurnsNoFartherThanToItsNextPoint) {
  const Surface<2> star = generated_outline("star", "", 0.01);
  for (const double angle : {100.0, 130.0}) {
    const OutlinePairs found = find_outline_pairs(star, moved(star, similarity(angle * degree)));
    EXPECT_NEAR(std::abs(turn_of(found.candidates[0].pose)), std::abs(std::remainder(angle, 72)) * degree,
                0.5 * degree);
    // The four other turns are as good, and leave no doubt.
    EXPECT_GT(found.margin, 2);
  }
}

Surface<2> disc(double radius, const Vec<2>& middle) {
  return moved(test::polygon(60, [=](double) { return radius; }), similarity(0, 1, middle));
}

TEST(FindOutlinePairs, SeveralCurvesAreFoundTogether) {
  // A disc with two holes and a small disc beside it: only together they tell which way is up.
  Surface<2> outline = disc(1, {0, 0});
  outline = test::joined(outline, test::reversed(disc(0.3, {0.4, 0.2})));
  outline = test::joined(outline, test::reversed(disc(0.2, {-0.5, 0.1})));
  outline = test::joined(outline, disc(0.4, {0.3, 1.7}));
  for (const double angle : {35.0, 160.0, -80.0}) {
    const Similarity<2> motion = similarity(angle * degree, 3, {1, 1});
    const Surface<2> other = moved(outline, motion);
    const OutlinePairs found = find_outline_pairs(outline, other);
    EXPECT_LT((found.candidates[0].pose.rotation - motion.rotation).norm(), 0.03) << angle;
    EXPECT_LT(greatest_error(found, other, motion), 0.02) << angle;
    EXPECT_EQ(found.candidates[0].score_parts.unmatched, 0);
  }
  // A curve that the other outline does not have finds no partner.
  const OutlinePairs found = find_outline_pairs(outline, disc(1, {0, 0}));
  EXPECT_NEAR(found.candidates[0].score_parts.unmatched, 0.5 * (1 - 1 / 1.9), 0.01);
}

TEST(FindOutlinePairs, ManyLikeCurvesAreAllOfTheOutline) {
  Surface<2> outline = disc(1, {0, 0});
  for (int k = 1; k < 60; ++k) outline = test::joined(outline, disc(1, {3.0 * (k % 8), 3.0 * (k / 8)}));
  const OutlinePairs found = find_outline_pairs(outline, outline);
  EXPECT_TRUE(found.candidates[0].is_identity);
  EXPECT_LT(greatest_error(found, outline, {}), 1e-9);
}

TEST(FindOutlinePairs, CurvesHaveOnePartnerOfTheirKind) {
  const auto unmatched = [](const Surface<2>& a, const Surface<2>& b) {
    return find_outline_pairs(a, b).candidates[0].score_parts.unmatched;
  };
  const Surface<2> small = disc(0.3, {0.4, 0.2});
  const Surface<2> with_hole = test::joined(disc(1, {0, 0}), test::reversed(small));
  EXPECT_NEAR(unmatched(with_hole, with_hole), 0, 1e-12);
  EXPECT_NEAR(unmatched(with_hole, test::joined(disc(1, {0, 0}), small)), 0.3 / 1.3, 0.01);
  const Surface<2> two = test::joined(test::joined(disc(1, {0, 0}), disc(0.3, {1.6, 0})), disc(0.3, {1.6, 0.7}));
  const Surface<2> one = test::joined(disc(1, {0, 0}), disc(0.3, {1.6, 0.35}));
  EXPECT_NEAR(unmatched(two, one), 0.5 * 0.3 / 1.6, 0.01);
  EXPECT_NEAR(unmatched(one, two), 0.5 * 0.3 / 1.6, 0.01);
}

TEST(FindOutlinePairs, AMirroredLeafNeedsMirror) {
  Surface<2> other = moved(leaf(), similarity(1));
  for (Vec<2>& x : other.vertices) x.x() *= -1;
  for (auto& facet : other.facets) std::swap(facet[0], facet[1]);
  AlignmentOptions options;
  EXPECT_GT(find_outline_pairs(leaf(), other, options).candidates[0].score, 0.1);
  options.mirror = true;
  const OutlinePairs found = find_outline_pairs(leaf(), other, options);
  EXPECT_TRUE(found.candidates[0].is_mirrored);
  EXPECT_EQ(found.candidates[0].score, found.candidates[0].score_parts.total())
      << "a preference is no part of the score";
  EXPECT_LT(found.candidates[0].pose.rotation.determinant(), 0);
  EXPECT_LT(greatest_error(found, other, found.candidates[0].pose), 0.004);
  EXPECT_FALSE(find_outline_pairs(leaf(), moved(leaf(), similarity(2)), options).candidates[0].is_mirrored);
}

TEST(FindOutlinePairs, ThreadsDoNotChangeTheResult) {
  const Surface<2> other = generated_outline("leaf", "shallow", 0.006);
  set_n_threads(1);
  const OutlinePairs one = find_outline_pairs(leaf(), other);
  set_n_threads(3);
  const OutlinePairs three = find_outline_pairs(leaf(), other);
  set_n_threads(0);
  ASSERT_EQ(one.candidates.size(), three.candidates.size());
  for (std::size_t k = 0; k < one.candidates.size(); ++k) EXPECT_EQ(one.candidates[k].score, three.candidates[k].score);
}

TEST(FindOutlinePairs, WhatHasNoClosedCurveIsRefused) {
  Surface<2> open = leaf();
  open.facets.pop_back();
  EXPECT_THROW(find_outline_pairs(open, leaf()), InputError);
  EXPECT_THROW(find_outline_pairs(leaf(), open), InputError);
}

TEST(FindOutlinePairs, TurnedHandsFindTheirFingers) {
  const auto folder = test::data_folder() / "hands2d_basel";
  if (!exists(folder)) GTEST_SKIP() << "no folder " << folder << "; set SHELLMATCH_DATA to the data folder";
  for (const auto& [a, b] : {std::pair("00", "03"), {"05", "10"}}) {
    const auto read = [&](const char* number) {
      return read_outline(folder / ("hand" + std::string(number) + "_registered.csv"));
    };
    const Shape<2> reference = read(a), other = read(b);
    for (const double angle : {0.0, 170.0}) {
      const Similarity<2> motion = similarity(angle * degree, 2);
      const OutlinePairs found = find_outline_pairs(moved(reference.surface, motion), other.surface);
      double sum = 0;
      for (const auto& pair : found.pairs()) {
        const auto& vertices = reference.original.vertices;
        const auto nearest = std::min_element(vertices.begin(), vertices.end(), [&](const Vec<2>& x, const Vec<2>& y) {
          return (motion(x) - pair.on_reference).squaredNorm() < (motion(y) - pair.on_reference).squaredNorm();
        });
        sum +=
            (other.original.vertices[static_cast<std::size_t>(nearest - vertices.begin())] - pair.on_template).norm();
      }
      const double diagonal = bounding_box(other.original.vertices).diagonal();
      EXPECT_LT(sum / static_cast<double>(found.pairs().size()), 0.03 * diagonal) << a << ' ' << b << ' ' << angle;
      EXPECT_EQ(found.candidates[0].is_identity, angle == 0);
    }
  }
}

TEST(FindOutlinePairs, TurnedLeavesFindTheirStalk) {
  const auto folder = test::data_folder() / "leaves2d_vitis";
  if (!exists(folder)) GTEST_SKIP() << "no folder " << folder << "; set SHELLMATCH_DATA to the data folder";
  for (const auto& [a, b] : {std::pair("000_CHARDONNAY", "000_ALICANTEBOUSCHET"),
                             {"020_leaf3_588154a", "234_5BB"},
                             {"000_CHARDONNAY", "057_leaf4_588233a"},
                             {"033_leaf4_483146a", "057_leaf4_588233a"}}) {
    const auto read = [&](const char* name) {
      return read_outline(folder / (std::string(name) + "_aligned.csv")).surface;
    };
    const Surface<2> reference = read(a), other = read(b);
    for (const double angle : {0.0, -110.0}) {
      const OutlinePairs found = find_outline_pairs(moved(reference, similarity(angle * degree)), other);
      // Stalks point down; two leaves lie on each other best at some degrees.
      EXPECT_LT(std::abs(std::remainder(turn_of(found.candidates[0].pose) + angle * degree, 2 * std::numbers::pi)),
                18 * degree)
          << a << ' ' << b;
      EXPECT_GT(found.margin, 1.3);
    }
  }
}

}  // namespace
}  // namespace shellmatch
