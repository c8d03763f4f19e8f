// Shapes that lie as they belong in what both have keep their places.
#include "matching/alignment/coincidence.h"

#include "geometry/repair/make_shape.h"
#include "matching/alignment/align_shapes.h"
#include "matching/match_shapes.h"
#include "tests/geometry/surface/test_surfaces.h"

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include <cmath>
#include <utility>

namespace shellmatch {
namespace {

Shape<3> shape_of(const Surface<3>& surface) {
  OriginalShape<3> original;
  original.vertices = surface.vertices;
  for (const auto& [a, b, c] : surface.facets) original.polygons.push_back({a, b, c});
  return make_shape(std::move(original), "shape", {}, Closing::automatic);
}

/// A tube with a knob, cut off at z = length: open there.
Shape<3> bone(double length) {
  const int n = 40, rings = static_cast<int>(length / 0.1);
  Surface<3> s;
  for (int i = 0; i <= rings; ++i)
    for (int j = 0; j < n; ++j) {
      const double z = 0.1 * i, t = 2 * EIGEN_PI * j / n;
      const double r =
          std::min(1.0, std::sqrt(z / 0.5) + 0.05) * (1 + 0.8 * std::exp(-(z - 1) * (z - 1)) * (1 + 0.5 * std::cos(t)) +
                                                      0.6 * std::exp(-(z - 3) * (z - 3)) * std::cos(t - 1.5));
      s.vertices.emplace_back(r * std::cos(t) + 0.001 * z * z, r * std::sin(t) + 0.05 * z, z);
    }
  s.vertices.emplace_back(0, 0, -0.1);
  const auto tip = static_cast<Index>(s.vertices.size() - 1);
  for (Index i = 0; i < rings; ++i)
    for (Index j = 0; j < n; ++j) {
      const Index a = i * n + j, b = i * n + (j + 1) % n;
      s.facets.push_back({a, b, b + n});
      s.facets.push_back({a, b + n, a + n});
    }
  for (Index j = 0; j < n; ++j) s.facets.push_back({tip, (j + 1) % n, j});
  return shape_of(s);
}

Shape<3> displaced(const Shape<3>& shape, const Similarity<3>& by) {
  OriginalShape<3> original = shape.original;
  for (Vec<3>& x : original.vertices) x = by(x);
  return make_shape(std::move(original), "moved", {}, Closing::automatic);
}

struct Told final : Observer {
  void note(const std::string& text) override { all += text + "\n"; }
  std::string all;
};

TEST(Coincidence, OneBoneCutAtTwoLengthsStaysWhereItLies) {
  const ShapePair<3> bones{bone(24), bone(28)};
  EXPECT_GT(Coincidence<3>(bones).share(), 0.95);
  Told notes;
  const Alignment<3> found = align_shapes<3>(bones, {}, profile_defaults(Profile::standard), notes);
  EXPECT_TRUE(found.pose.is_identity()) << notes.all;
  EXPECT_TRUE(found.pairs.empty()) << notes.all;
  EXPECT_NE(notes.all.find("coincide"), std::string::npos) << notes.all;
}

// The longer one, deformed, would slide from the edge of the other's gap.
TEST(Coincidence, WhatTwoLengthsOfOneBoneHaveStaysInEitherOrder) {
  ExperimentOptions o = profile_defaults(Profile::standard);
  o.cascade.max_level = 4;
  // The search only has to find a map, whose pairs are then left out.
  o.align.search.max_vertices = 1000;
  o.align.search.functions = 40;
  o.align.search.refined = 1;
  Observer quiet;
  for (const auto& [longer, shorter] : {std::pair(26.0, 19.0), {19.0, 26.0}}) {
    const Shape<3> reference = bone(longer), other = bone(shorter);
    const MatchResult<3> result = match_shapes(reference, other, o, quiet);
    double sum = 0;
    int n = 0;
    for (std::size_t i = 0; i < result.deformed.vertices.size(); ++i) {
      const Vec<3>& x = reference.original.vertices[i];
      if (x[2] > 18) continue;
      sum += (result.deformed.vertices[i] - x).norm();
      ++n;
    }
    EXPECT_LT(sum / n, 0.1) << longer;  // its circumference is 6
  }
}

TEST(Coincidence, WhatIsTurnedOrLiesElsewhereDoesNotCoincide) {
  const Shape<3> whole = bone(16);
  for (const double angle : {0.5, 3.0}) {
    const Similarity<3> by{1, Vec<3>(0, 0.5, 0), Eigen::AngleAxisd(angle, Vec<3>::UnitX()).toRotationMatrix()};
    const Coincidence<3> turned(ShapePair<3>{whole, displaced(whole, by)});
    EXPECT_FALSE(turned.decides()) << turned.share();
  }
  // The sides of a thin plate are near each other, but face away.
  const Shape<3> plate = shape_of(test::box({0, 0, 0}, {1, 1.5, 0.05})),
                 on_top = shape_of(test::box({0, 0, 0.05}, {1, 1.5, 0.5}));
  EXPECT_NEAR(Coincidence<3>(ShapePair<3>{plate, plate}).share(), 1, 1e-9);
  EXPECT_LT(Coincidence<3>(ShapePair<3>{plate, on_top}).share(), 0.1);
}

TEST(Coincidence, PairsThatEndOnWhatBothHaveAreLeftOut) {
  const ShapePair<3> bones{bone(24), bone(30)};
  const Vec<3> shared = bones.reference.surface.vertices[500], beyond(3.0, 1.5, 29.5);
  std::vector<Landmark<3>> pairs = {{"shared", shared, shared}, {"drawn out", shared, beyond}};
  Coincidence<3>(bones).keep_others(pairs);
  EXPECT_TRUE(pairs.empty());
}

/// A torus that a third of a turn nearly takes onto itself.
Shape<3> threefold_torus(double phase) {
  const Index n = 40;
  Surface<3> s;
  for (Index i = 0; i < n; ++i)
    for (Index j = 0; j < n; ++j) {
      const double u = 2 * EIGEN_PI * i / n, v = 2 * EIGEN_PI * j / n;
      const double r = 0.3 * (1 + 0.15 * std::sin(3 * u + phase) * std::cos(2 * v)), far = 1 + r * std::cos(v);
      const Vec<3> x((1 + 0.1 * phase) * far * std::cos(u), far * std::sin(u), r * std::sin(v));
      s.vertices.push_back(x.cast<float>().cast<double>());
      const Index i_1 = (i + 1) % n, j_1 = (j + 1) % n;
      s.facets.push_back({i * n + j, i_1 * n + j, i_1 * n + j_1});
      s.facets.push_back({i * n + j, i_1 * n + j_1, i * n + j_1});
    }
  return shape_of(s);
}

// Which of three maps is right, spectra cannot tell; that the shapes coincide, does.
TEST(Coincidence, WhatCoincidesIsNotDoubtful) {
  Told notes;
  const Alignment<3> found =
      align_shapes<3>({threefold_torus(0), threefold_torus(0.4)}, {}, profile_defaults(Profile::standard), notes);
  EXPECT_TRUE(found.pose.is_identity()) << notes.all;
  EXPECT_FALSE(found.summary->doubtful) << notes.all;
  EXPECT_NE(notes.all.find("coincide"), std::string::npos) << notes.all;
}

// As the map of a shape with a threefold symmetry may do.
TEST(Coincidence, AMapThatTurnsWhatCoincidesHasNoPairs) {
  const ShapePair<3> bones{bone(24), bone(30)};
  const std::vector<Vec<3>>& at = bones.reference.surface.vertices;
  const Landmark<3> elsewhere{"elsewhere", {4, 3, 12}, {5, 4, 15}};
  for (const bool is_turned : {false, true}) {
    std::vector<Landmark<3>> pairs;
    for (std::size_t i = 0; i < 20; ++i)
      pairs.push_back({"", at[25 * i], is_turned ? at[at.size() - 1 - 25 * i] : at[25 * i + 1]});
    pairs.insert(pairs.begin() + 7, elsewhere);
    Coincidence<3>(bones).keep_others(pairs);
    EXPECT_EQ(pairs.size(), is_turned ? 0 : 1);
    for (const Landmark<3>& kept : pairs) EXPECT_EQ(kept.on_template, elsewhere.on_template);
  }
}

TEST(Coincidence, APoseOfOneComponentHasToBringAllNearer) {
  const Shape<3> whole = bone(16);
  const ShapePair<3> pair{whole, whole};
  EXPECT_NEAR(distance_after<3>(pair, {}), 0, 1e-9);
  EXPECT_GT(distance_after<3>(pair, {1, Vec<3>(0, 1, 0), Mat<3>::Identity()}), 0.1);
}

}  // namespace
}  // namespace shellmatch
