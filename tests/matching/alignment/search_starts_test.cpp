#include "matching/alignment/search_starts.h"

#include "matching/input/shape_source.h"
#include "tests/geometry/generate/generated_surface.h"
#include "tests/geometry/surface/test_surfaces.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace shellmatch {
namespace {

TEST(SearchStarts, ATurnedSurfaceFindsTheSameMapAsTheOneThatLiesAsItBelongs) {
  const auto shape = [](const char* name) { return std::get<Shape<3>>(open_shape(name)); };
  AlignOptions options;
  options.search.max_vertices = 2000;
  options.search.functions = 60;
  options.search.refined = 2;
  const Shape<3> bent = shape("generate:dolphin/bent");
  const StartSearch<3> straight = search_starts(ShapePair<3>{shape("generate:dolphin/straight"), bent}, {}, options),
                       reversed = search_starts(ShapePair<3>{shape("generate:dolphin/reversed"), bent}, {}, options);
  EXPECT_NEAR(reversed.starts[0].score, straight.starts[0].score, 1e-3);
  EXPECT_GT(straight.margin, 1.5);
  EXPECT_GT(reversed.margin, 1.5);
}

TEST(SearchStarts, LandmarksReachTheSearchAndMakeItsPairsCertain) {
  const auto pair = std::get<GeneratedPair<3>>(generated_pair("hand", 0.02));
  // Fingers are longer, and the palm is narrower.
  const auto grown = [](const Vec<3>& x) {
    return Vec<3>(0.5 + (x[0] - 0.5) * (0.6 + x[1]), x[1] + 1.2 * x[1] * x[1], x[2]);
  };
  ShapePair<3> shapes;
  shapes.reference.surface = as_surface(pair.reference);
  shapes.template_shape.surface = test::mapped<3>(as_surface(pair.template_shape), grown);
  std::vector<Landmark<3>> landmarks;
  for (std::size_t i = 0; i < pair.truth.size(); i += pair.truth.size() / 80)
    landmarks.push_back({"", shapes.reference.surface.vertices[pair.truth[i].vertex], grown(pair.truth[i].position)});
  AlignOptions options;
  options.search.functions = 60;
  options.search.refined = 2;
  const StartSearch<3> without = search_starts(shapes, {}, options), with = search_starts(shapes, landmarks, options);
  EXPECT_FALSE(without.starts[0].landmark_distance);
  EXPECT_FALSE(without.starts[0].alignment.landmark_trust);
  EXPECT_LT(with.starts[0].landmark_distance.value(), 0.15);
  EXPECT_GT(with.starts[0].alignment.landmark_trust.value(), 0.5);
  ASSERT_GT(without.starts[0].alignment.spread, 1.05) << "far from isometric";
  EXPECT_LT(with.starts[0].alignment.spread - 1, 0.3 * (without.starts[0].alignment.spread - 1));
  EXPECT_TRUE(with.landmarks_are_spread);
  EXPECT_GT(with.n_landmarks, 70u);
  EXPECT_LE(with.n_landmarks, landmarks.size());
  EXPECT_TRUE(with.notes.empty());
  // Those of one finger tell little of the others.
  const Vec<3> tip = landmarks.front().on_template;
  std::ranges::sort(landmarks, {}, [&](const Landmark<3>& l) { return (l.on_template - tip).norm(); });
  landmarks.resize(8);
  EXPECT_FALSE(search_starts(shapes, landmarks, options).landmarks_are_spread);
}

TEST(SearchStarts, PairsThatContradictThoseAroundThemAreTheLast) {
  const auto shape = [](const char* name) { return std::get<Shape<3>>(open_shape(name)); };
  AlignOptions options;
  options.search.max_vertices = 1000;
  options.search.functions = 40;
  options.search.refined = 3;
  const auto contradicting = [&](const char* reference, const char* target) {
    std::vector<std::size_t> n;
    for (const Start<3>& start : search_starts({shape(reference), shape(target)}, {}, options).starts) {
      EXPECT_EQ(start.alignment.pairs.size(), start.n_pairs + start.n_contradicting);
      n.push_back(start.n_contradicting);
    }
    return n;
  };
  EXPECT_EQ(contradicting("generate:hand/bent", "generate:hand").front(), 0u);
  const std::vector<std::size_t> unlike = contradicting("generate:hand", "generate:dolphin/bent");
  EXPECT_GT(*std::ranges::max_element(unlike), 0u) << "no map between these is right everywhere";
}

TEST(SearchStarts, SayWhichComponentsAreLeftOut) {
  ShapePair<3> shapes;
  const Surface<3> sphere = generated_surface("sphere", "", 0.05);
  shapes.template_shape.surface = sphere;
  shapes.reference.surface =
      test::joined(sphere, test::mapped<3>(sphere, [](const Vec<3>& x) { return Vec<3>(0.1 * x); }));
  shapes.reference.source = "a.ply";
  AlignOptions options;
  options.search.functions = 40;
  options.search.refined = 1;
  const StartSearch<3> search = search_starts(shapes, {}, options);
  ASSERT_EQ(search.notes.size(), 1u);
  EXPECT_EQ(search.notes[0], "pairs are of the largest component of a.ply alone, 99 % of its area");
}

TEST(SearchPoses, LandmarksJudgeThem) {
  const auto shape = [](const char* name) { return std::get<Shape<3>>(open_shape(name)); };
  const ShapePair<3> shapes{shape("generate:ellipsoid/long"), shape("generate:ellipsoid/long")};
  const auto& x = shapes.reference.original.vertices;
  std::vector<Landmark<3>> agree, contradict;
  for (std::size_t i = 0; i < x.size(); i += x.size() / 8) {
    agree.push_back({"", x[i], x[i]});
    contradict.push_back({"", x[i], x[(i + x.size() / 2) % x.size()]});
  }
  EXPECT_LT(search_poses(shapes, agree, {}).starts[0].landmark_distance.value(), 0.01);
  EXPECT_GT(search_poses(shapes, contradict, {}).starts[0].landmark_distance.value(), 0.2);
  EXPECT_FALSE(search_poses(shapes, {}, {}).starts[0].landmark_distance);
}

}  // namespace
}  // namespace shellmatch
