// Pairs between a shape and its turned, renumbered, mirrored, bent and damaged selves.
#include "alignment/pairs/find_pairs.h"
#include "alignment/pose/fit_pose.h"
#include "base/error.h"
#include "base/parallel.h"
#include "geometry/distance/signed_distance.h"
#include "tests/geometry/generate/generated_surface.h"
#include "tests/geometry/surface/test_surfaces.h"

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <random>

namespace shellmatch {
namespace {

/// Enough for shapes without trouble, in a third of the time.
AlignmentOptions quick() {
  AlignmentOptions options;
  options.start_functions = 4;
  options.functions = 60;
  options.refined = 2;
  return options;
}

const Surface<3>& hand() {
  static const Surface<3> surface = generated_surface("hand", "", 0.02);
  return surface;
}

Mat<3> turn() { return Eigen::AngleAxisd(2.5, Vec<3>(1, -2, 0.5).normalized()).toRotationMatrix(); }

Surface<3> turned(const Surface<3>& surface) {
  return test::mapped<3>(surface, [](const Vec<3>& x) { return Vec<3>(30 * turn() * x + Vec<3>(5, 6, 7)); });
}

/// The surface with vertex v as number[v], facets in another order.
Surface<3> renumbered(const Surface<3>& surface, const std::vector<Index>& number) {
  Surface<3> result = surface;
  for (std::size_t v = 0; v < number.size(); ++v) result.vertices[number[v]] = surface.vertices[v];
  for (auto& facet : result.facets)
    for (Index& v : facet) v = number[v];
  std::reverse(result.facets.begin(), result.facets.end());
  return result;
}

std::vector<Index> shuffled(std::size_t n) {
  std::vector<Index> number(n);
  std::iota(number.begin(), number.end(), 0);
  std::mt19937 random(3);
  for (std::size_t i = n; i > 1; --i) std::swap(number[i - 1], number[random() % i]);
  return number;
}

/// Share of the vertices whose image is farther from where it belongs than `tolerance` roots of the area.
double share_beyond(double tolerance, const AutomaticPairs& found, const std::vector<Vec<3>>& belongs) {
  const Surface<3>& surface = found.template_surface.surface;
  double area = 0;
  for (std::size_t f = 0; f < surface.facets.size(); ++f) area += facet_measure(surface, static_cast<Index>(f));
  double n = 0, wrong = 0;
  for (std::size_t v = 0; v < belongs.size(); ++v) {
    const Index image = found.image(static_cast<Index>(v));
    if (image == no_index) continue;
    ++n;
    wrong += (surface.vertices[image] - belongs[v]).norm() > tolerance * std::sqrt(area);
  }
  return wrong / n;
}

TEST(FindPairs, ATurnedAndRenumberedShapeIsFoundVertexByVertex) {
  const std::vector<Index> number = shuffled(hand().vertices.size());
  const Surface<3> other = renumbered(turned(hand()), number);
  const AutomaticPairs found = find_pairs(hand(), other, quick());
  std::size_t n_wrong = 0;
  for (std::size_t v = 0; v < number.size(); ++v) n_wrong += found.image(static_cast<Index>(v)) != number[v];
  EXPECT_EQ(n_wrong, 0u);
  EXPECT_LT(found.candidates[0].score, 1e-3);
  EXPECT_GT(found.margin, 10);
  EXPECT_GE(found.pairs().size(), 290u);
  for (const CorrespondingPoints& p : found.pairs())
    EXPECT_LT((30 * turn() * p.on_reference + Vec<3>(5, 6, 7) - p.on_template).norm(), 1e-3 * 30);
  const Pose pose = fit_pose(found.pairs(), PoseKind::similarity);
  EXPECT_LT((pose.rotation - turn()).norm(), 1e-5);
  EXPECT_NEAR(pose.scale, 30, 1e-4);
}

TEST(FindPairs, TheNumberOfThreadsDoesNotMatter) {
  const Surface<3> bent = generated_surface("hand", "bent", 0.024);
  const auto run = [&](int threads) {
    set_n_threads(threads);
    AutomaticPairs found = find_pairs(hand(), bent, quick());
    set_n_threads(0);
    return found;
  };
  const AutomaticPairs a = run(1), b = run(4);
  ASSERT_EQ(a.candidates.size(), b.candidates.size());
  EXPECT_EQ(a.margin, b.margin);
  for (std::size_t i = 0; i < a.candidates.size(); ++i) {
    EXPECT_EQ(a.candidates[i].score, b.candidates[i].score);
    EXPECT_EQ(a.candidates[i].map, b.candidates[i].map);
    ASSERT_EQ(a.candidates[i].pairs.size(), b.candidates[i].pairs.size());
    for (std::size_t k = 0; k < a.candidates[i].pairs.size(); ++k) {
      EXPECT_EQ(a.candidates[i].pairs[k].on_reference, b.candidates[i].pairs[k].on_reference);
      EXPECT_EQ(a.candidates[i].pairs[k].on_template, b.candidates[i].pairs[k].on_template);
      EXPECT_EQ(a.candidates[i].pairs[k].weight, b.candidates[i].pairs[k].weight);
    }
  }
}

TEST(FindPairs, AMirroredShapeIsFoundWhereMirrorsAreAllowed) {
  const Surface<3> mirrored =
      test::reversed<3>(test::mapped<3>(turned(hand()), [](const Vec<3>& x) { return Vec<3>(x[0], x[1], -x[2]); }));
  AlignmentOptions options = quick();
  options.mirror = true;
  const AutomaticPairs found = find_pairs(hand(), mirrored, options);
  EXPECT_TRUE(found.candidates[0].is_mirrored);
  EXPECT_LT(share_beyond(0.01, found, mirrored.vertices), 0.01);
  EXPECT_TRUE(fit_pose(found.pairs(), PoseKind::similarity, Mirroring::allowed).is_mirrored());
  EXPECT_FALSE(find_pairs(hand(), turned(hand()), options).candidates[0].is_mirrored);
}

TEST(FindPairs, AMirrorImageDoesNotLowerTheMargin) {
  // A dolphin at rest is its own mirror image.
  const Surface<3> shape = generated_surface("dolphin", "straight", 0.02);
  AlignmentOptions options = quick();
  options.mirror = true;
  const AutomaticPairs found = find_pairs(shape, turned(shape), options);
  double same = std::numeric_limits<double>::infinity(), other = same;
  for (std::size_t i = 1; i < found.candidates.size(); ++i) {
    const PairCandidate& c = found.candidates[i];
    if (c.is_mirrored == found.candidates[0].is_mirrored) same = std::min(same, c.margin);
    else other = std::min(other, c.order / found.candidates[0].order);
  }
  EXPECT_LT(other, same);
  EXPECT_EQ(found.margin, same);
  for (const PairCandidate& c : found.candidates)
    EXPECT_EQ(c.score, 0.5 * (c.coarse_score.total() + c.score_parts.total()));
}

TEST(FindPairs, AShapeThatLiesAsItBelongsStays) {
  // A box has four proper rotations onto itself, and all are isometries.
  const Surface<3> box = test::box({0, 0, 0}, {1, 1.5, 2.2});
  const AutomaticPairs found = find_pairs(box, box, quick());
  EXPECT_TRUE(found.candidates[0].is_identity);
  EXPECT_LT(share_beyond(0.01, found, box.vertices), 0.01);
  EXPECT_FALSE(find_pairs(hand(), turned(generated_surface("hand", "bent", 0.02)), quick()).candidates[0].is_identity);
}

TEST(FindPairs, SpheresLeaveOpenByWhichRotationTheyCorrespond) {
  const Surface<3> sphere = generated_surface("ellipsoid", "round", 0.05),
                   ellipsoid = generated_surface("ellipsoid", "long", 0.05);
  for (const auto& [reference, template_surface] : {std::pair(&sphere, &ellipsoid), std::pair(&ellipsoid, &sphere)}) {
    const AutomaticPairs found = find_pairs(*reference, *template_surface, quick());
    EXPECT_EQ(found.margin, 1);
    ASSERT_EQ(found.candidates.size(), 1u) << "no signs of eigenfunctions are tried";
    EXPECT_TRUE(found.candidates[0].is_identity);
  }
  EXPECT_GT(find_pairs(ellipsoid, ellipsoid, quick()).candidates.size(), 1u);
}

TEST(FindPairs, LargeSurfacesWithSeveralPartsAndHolesAreMatched) {
  Surface<3> fine = generated_surface("hand", "", 0.01);
  AlignmentOptions options = quick();
  options.max_vertices = 2500;
  ASSERT_GT(fine.vertices.size(), 4000u);
  Surface<3> other = turned(fine);
  const std::size_t n = fine.vertices.size();
  fine.facets.erase(fine.facets.begin() + 100, fine.facets.begin() + 104);
  const Surface<3> ball = test::mapped<3>(test::unit_sphere(2), [](const Vec<3>& x) { return Vec<3>(0.02 * x); });
  const AutomaticPairs found = find_pairs(test::joined(fine, ball), other, options);
  EXPECT_EQ(found.image(static_cast<Index>(n)), no_index);
  EXPECT_LT(share_beyond(0.06, found, other.vertices), 0.02);
  // The points lie on the surfaces that were given, not on the simplified ones.
  const SignedDistance<3> to_reference(fine), to_template(other);
  for (const CorrespondingPoints& p : found.pairs()) {
    EXPECT_LT(std::abs(to_reference(p.on_reference)), 1e-9);
    EXPECT_LT(std::abs(to_template(p.on_template)), 1e-7);
  }
  EXPECT_LT((fit_pose(found.pairs(), PoseKind::similarity).rotation - turn()).norm(), 0.02);
}

TEST(FindPairs, ABentHandIsFoundInAnyPosition) {
  const auto pair = std::get<GeneratedPair<3>>(generated_pair("hand", 0.018));
  const Surface<3> reference = as_surface(pair.reference), other = turned(as_surface(pair.template_shape));
  const AutomaticPairs found = find_pairs(reference, other);
  double area = 0, wrong = 0;
  for (std::size_t f = 0; f < other.facets.size(); ++f) area += facet_measure(other, static_cast<Index>(f));
  for (const auto& known : pair.truth) {
    const Vec<3> belongs = 30 * turn() * known.position + Vec<3>(5, 6, 7);
    wrong += (other.vertices[found.image(known.vertex)] - belongs).norm() > 0.1 * std::sqrt(area);
  }
  EXPECT_GT(pair.truth.size(), 500u);
  EXPECT_EQ(wrong, 0);
  EXPECT_FALSE(found.candidates[0].is_identity);
  EXPECT_GE(found.margin, 1.1);
}

// Where a map takes one hand to the chin, its twin without that fault differs from it by little on the whole.
TEST(FindPairs, OfNearlyEqualMapsTheOneWithAllLimbsInPlaceStays) {
  const auto reference = test::data_surface("bodies_posed/boy_run.off"),
             man = test::data_surface("bodies_posed/man_up.off");
  if (!reference || !man) GTEST_SKIP() << "set SHELLMATCH_DATA to the data folder";
  // Of ten rotations this one led to such a map.
  const Mat<3> rotation = Eigen::AngleAxisd(3, Vec<3>(1, -2, 2.5).normalized()).toRotationMatrix();
  const Surface<3> other =
      test::mapped<3>(*man, [&](const Vec<3>& x) { return Vec<3>(10 * rotation * x + Vec<3>(5, 6, 7)); });
  const AutomaticPairs found = find_pairs(*reference, other);
  EXPECT_GE(found.margin, 1.1);
  EXPECT_LT(found.candidates[0].score_parts.tips, 0.1);
  EXPECT_LT(share_beyond(0.2, found, other.vertices), 0.05);
}

// The margin would tell nothing if the next map were the first once more.
TEST(FindPairs, NoTwoMapsAreNearlyOne) {
  const auto pair = std::get<GeneratedPair<3>>(generated_pair("hand", 0.018));
  AlignmentOptions options;
  options.refined = 8;
  const auto stretched = [](const Vec<3>& x) { return Vec<3>(1.5 * x[0], x[1], 0.75 * x[2]); };
  const AutomaticPairs found =
      find_pairs(as_surface(pair.reference), test::mapped<3>(as_surface(pair.template_shape), stretched), options);
  const Surface<3>& surface = found.template_surface.surface;
  double area = 0;
  for (std::size_t f = 0; f < surface.facets.size(); ++f) area += facet_measure(surface, static_cast<Index>(f));
  ASSERT_GT(found.candidates.size(), 1u);
  for (std::size_t i = 0; i < found.candidates.size(); ++i)
    for (std::size_t j = 0; j < i; ++j) {
      const std::vector<Index>&a = found.candidates[i].map, &b = found.candidates[j].map;
      if (a.empty() || b.empty()) continue;
      double sum = 0;
      for (std::size_t v = 0; v < a.size(); ++v) sum += (surface.vertices[a[v]] - surface.vertices[b[v]]).norm();
      EXPECT_GT(sum / static_cast<double>(a.size()), 0.04 * std::sqrt(area)) << i << " and " << j;
    }
}

std::vector<CorrespondingPoints> some(const std::vector<Vec<3>>& from, const std::vector<Vec<3>>& to, std::size_t n) {
  std::vector<CorrespondingPoints> pairs;
  for (std::size_t i = 0; i < n; ++i) pairs.push_back({from[i * from.size() / n], to[i * from.size() / n], 1});
  return pairs;
}

TEST(FindPairs, LandmarksTellWhatSpectraCannot) {
  // Half a turn about the third axis carries the box onto itself.
  const Surface<3> box = test::box({0, 0, 0}, {1, 1.5, 2.2});
  std::vector<Vec<3>> belongs;
  for (const Vec<3>& x : box.vertices) belongs.push_back({1 - x[0], 1.5 - x[1], x[2]});
  std::vector<CorrespondingPoints> landmarks = some(box.vertices, belongs, 6);
  landmarks[2].on_template = box.vertices[5];  // a wrong one does no harm
  const AutomaticPairs found = find_pairs(box, box, quick(), landmarks);
  EXPECT_FALSE(found.candidates[0].is_identity);
  EXPECT_LT(share_beyond(0.01, found, belongs), 0.01);
  EXPECT_LT(found.candidates[0].landmark_distance.value(), 0.01);
  EXPECT_EQ(found.candidates[0].landmark_trust, 1);
  const std::size_t n_landmarks = found.candidates[0].n_landmarks;
  EXPECT_GE(n_landmarks, 5u);  // the wrong one may name a vertex that has been named before
  // Landmarks on a component that is left out do not take part, however near it lies.
  const Surface<3> inner = test::box({0.03, 0.03, 0.03}, {0.97, 1.47, 2.17});
  for (int k = 1; k < 12; ++k) {
    const Vec<3> x(0.03, 0.03 + 0.12 * k, 0.03 + 0.18 * k);
    landmarks.push_back({x, x, 1});
  }
  const AutomaticPairs hollow = find_pairs(test::joined(box, test::reversed(inner)),
                                           test::joined(box, test::reversed(inner)), quick(), landmarks);
  EXPECT_EQ(hollow.candidates[0].n_landmarks, n_landmarks);
  EXPECT_LT(hollow.reference.share, 0.6);
  landmarks.resize(3);
  EXPECT_TRUE(find_pairs(box, box, quick(), landmarks).candidates[0].is_identity) << "too few";
}

TEST(FindPairs, LandmarksMakePairsOfUnlikeShapesMoreExact) {
  const auto pair = std::get<GeneratedPair<3>>(generated_pair("hand", 0.018));
  const Surface<3> reference = as_surface(pair.reference);
  // Fingers grow, and the palm becomes narrow.
  const auto grown = [](const Vec<3>& x) {
    return Vec<3>(0.5 + (x[0] - 0.5) * (0.75 + x[1]), x[1] + 0.8 * x[1] * x[1], x[2]);
  };
  const Surface<3> other = test::mapped<3>(as_surface(pair.template_shape), grown);
  std::vector<Vec<3>> from, to;
  for (const auto& known : pair.truth) {
    from.push_back(reference.vertices[known.vertex]);
    to.push_back(grown(known.position));
  }
  const auto error = [&](const std::vector<CorrespondingPoints>& landmarks) {
    const AutomaticPairs found = find_pairs(reference, other, quick(), landmarks);
    double sum = 0;
    for (std::size_t i = 0; i < to.size(); ++i)
      sum += (other.vertices[found.image(pair.truth[i].vertex)] - to[i]).norm();
    return sum / static_cast<double>(to.size());
  };
  const std::vector<CorrespondingPoints> exact = some(from, to, 80);
  const double without = error({}), with = error(exact);
  EXPECT_LT(with, 0.8 * without);
  std::vector<CorrespondingPoints> some_wrong = exact;
  for (std::size_t i = 0; i < some_wrong.size(); i += 10) some_wrong[i].on_template = to[(i * 37 + 100) % to.size()];
  EXPECT_LT(error(some_wrong), 1.3 * with);
}

TEST(FindPairs, NoisyLandmarksDoNotSpoilExactPairs) {
  const Surface<3> other = turned(hand());
  std::mt19937 random(5);
  std::normal_distribution<double> normal(0, 0.03 * 30);
  std::vector<CorrespondingPoints> landmarks = some(hand().vertices, other.vertices, 40);
  for (CorrespondingPoints& l : landmarks) l.on_template += Vec<3>(normal(random), normal(random), normal(random));
  const AutomaticPairs found = find_pairs(hand(), other, quick(), landmarks);
  EXPECT_LT(found.candidates[0].landmark_trust, 0.01);
  EXPECT_LT(share_beyond(0.01, found, other.vertices), 0.02);
}

TEST(FindPairs, SurfacesThatCannotBeMatchedAreRefused) {
  EXPECT_THROW(find_pairs({}, hand(), quick()), InputError);
  Surface<3> broken = hand();
  broken.vertices[3][0] = std::nan("");
  EXPECT_THROW(find_pairs(broken, hand(), quick()), InputError);
  AlignmentOptions few = quick();
  few.functions = 39;
  EXPECT_THROW(find_pairs(hand(), hand(), few), InputError);
}

TEST(FindPairs, TellWhetherTheMirroredReferenceFits) {
  const Surface<3> left = test::mapped<3>(test::unit_sphere(4), [](const Vec<3>& x) {
    return Vec<3>(1.6 * x[0], x[1] * (1 + 0.3 * x[0]), 0.8 * x[2] + 0.3 * x[0] * x[0] + 0.2 * x[1] * x[0]);
  });
  Surface<3> right = test::mapped<3>(left, [](const Vec<3>& x) { return Vec<3>(-x[0], x[1], x[2]); });
  for (auto& facet : right.facets) std::swap(facet[1], facet[2]);
  const AutomaticPairs same = find_pairs(left, left, quick()), other = find_pairs(left, right, quick());
  const auto fits = [&](const AutomaticPairs& found, double most_order) {
    return fits_mirrored(*found.spectra[0], *found.spectra[1], quick(), 0.3, most_order);
  };
  EXPECT_TRUE(fits(other, other.candidates[0].order / 3));
  EXPECT_GT(other.mirrored_gain, 3);
  EXPECT_LT(same.mirrored_gain, 0.3);
  EXPECT_FALSE(fits(same, other.candidates[0].order / 3));
  EXPECT_FALSE(fits(other, 0));
}

}  // namespace
}  // namespace shellmatch
