// Where a surface has data, and at which points distances are measured then: a ball without its cap, closed by a disc.

#include "geometry/distance/measured_parts.h"
#include "geometry/distance/surface_distance.h"
#include "geometry/repair/repair.h"
#include "tests/geometry/surface/test_surfaces.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace shellmatch {
namespace {

using namespace test;

constexpr double height = 0.6, rim = 0.8;  // of the plane of the cut, and the radius of the circle in it

MendedSurface cut_ball() {
  OriginalShape<3> shape;
  const Surface<3> ball = unit_sphere(5);
  shape.vertices = ball.vertices;
  for (const auto& [a, b, c] : ball.facets)
    if ((ball.vertices[a] + ball.vertices[b] + ball.vertices[c]).z() / 3 < height) shape.polygons.push_back({a, b, c});
  std::vector<std::string> notes;
  return mend_surface(shape, "ball", notes, Closing::automatic);
}

TEST(ObservedPart, MarginsAreDistancesFromTheRim) {
  const ObservedPart<3> part(cut_ball().evidence);
  const double edge = 0.04;
  const auto on_sphere = [](double z) { return Vec<3>(std::sqrt(1 - z * z), 0, z); };
  const Vec<3> at_rim(rim, 0, height);
  for (const double z : {0.5, 0.3, 0.0})
    EXPECT_NEAR(part.margin(on_sphere(z)), (on_sphere(z) - at_rim).norm(), edge) << z;
  // On the disc they are the negative distance from the rim; beyond it nothing but the rim is near.
  EXPECT_NEAR(part.margin({0.3, 0, height}), 0.3 - rim, edge);
  EXPECT_NEAR(part.margin({0, 0, height}), -rim, 0.06);
  // From the centres of the triangles that fill the disc, of which none is at its own centre.
  EXPECT_GT(part.nearest_gap({0, 0, height}).half_width, 0.5 * rim);
  EXPECT_LT(part.nearest_gap({0, 0, height}).half_width, rim);
  EXPECT_LT(part.margin({rim, 0, height + 0.5}), edge);
  EXPECT_TRUE(part.contains(on_sphere(0.4)));
  EXPECT_TRUE(part.contains({2, 0, 0}));
  EXPECT_FALSE(part.contains({0, 0, 1}));
}

TEST(ObservedPart, MarginsUpToALimitAreThoseBelowIt) {
  const ObservedPart<3> part(cut_ball().evidence);
  std::size_t n_beyond = 0, n_within = 0;
  for (const double most : {0.05, 0.4, 1.5})
    for (const Vec<3>& x : random_points<3>(300, Vec<3>::Constant(-1.2), Vec<3>::Constant(1.2))) {
      const double margin = part.margin(x);
      if (margin < 0.999 * most) {
        EXPECT_FALSE(part.is_beyond(x, most));
        EXPECT_EQ(part.margin_up_to(x, most), margin);
      }
      EXPECT_FALSE(margin > -0.999 * most && part.is_within(x, -most));
      n_beyond += part.is_beyond(x, most);
      n_within += part.is_within(x, -most);
    }
  EXPECT_GT(n_beyond, 100u);
  EXPECT_GT(n_within, 5u);
  EXPECT_FALSE(ObservedPart<3>().is_within({5, 5, 5}, 1));
  EXPECT_TRUE(ObservedPart<3>().is_beyond({5, 5, 5}, 1));
}

TEST(ObservedPart, GapsOfManyPointsAreThoseOfEach) {
  const ObservedPart<3> part(cut_ball().evidence);
  std::vector<Vec<3>> points = random_points<3>(300, Vec<3>::Constant(-1.2), Vec<3>::Constant(1.2));
  points[7] *= 1e200;  // so far away that nothing can be told
  std::vector<ObservedPart<3>::Gap> gaps(points.size());
  for (const double most : {0.05, 0.4, 10.0}) {
    part.nearest_gaps(points, most, gaps);
    std::size_t n_beyond = 0;
    for (std::size_t i = 0; i < points.size(); ++i) {
      const ObservedPart<3>::Gap gap = part.nearest_gap(points[i]);
      const bool is_beyond = gap.margin >= most;
      EXPECT_EQ(gaps[i].margin, is_beyond ? std::numeric_limits<double>::infinity() : gap.margin) << i;
      if (!is_beyond) {
        EXPECT_EQ(gaps[i].half_width, gap.half_width);
      }
      n_beyond += is_beyond;
    }
    EXPECT_EQ(n_beyond == 0, most == 10);
  }
  ObservedPart<3>().nearest_gaps(points, 1, gaps);
  EXPECT_TRUE(std::ranges::all_of(gaps, [](const auto& gap) { return std::isinf(gap.margin) && gap.margin > 0; }));
}

TEST(ObservedPart, TheEdgeOfAGapIsNotContained) {
  const Evidence<3> evidence = cut_ball().evidence;
  const ObservedPart<3> part(evidence);
  for (const Vec<3>& x : evidence.unobserved.vertices) EXPECT_FALSE(part.contains(x));
  // Above the rim and outside of the disc the rim is nearest to both.
  for (const Vec<3>& x : evidence.unobserved.vertices)
    EXPECT_FALSE(part.contains(Vec<3>(1.05 * x + Vec<3>(0, 0, 0.2)))) << x.transpose();
}

TEST(ObservedPart, WithoutGapsItIsAllOfSpace) {
  const ObservedPart<3> all;
  EXPECT_TRUE(all.is_all());
  EXPECT_TRUE(all.contains({5, 5, 5}));
  EXPECT_TRUE(ObservedPart<3>(Evidence<3>{}).is_all());
}

// The half widths of a wide and a narrow gap: each of its own.
TEST(ObservedPart, GapsHaveTheirOwnWidths) {
  Surface<3> plane;
  plane.vertices = {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {2.5, 0, 0}, {3.5, 0, 0}, {3.6, 0, 0}, {4.6, 0, 0}};
  Evidence<3> evidence;
  evidence.observed = evidence.unobserved = plane;
  for (Surface<3>* s : {&evidence.observed, &evidence.unobserved})
    for (int k = 0; k < 7; ++k)
      s->vertices.emplace_back(plane.vertices[static_cast<std::size_t>(k)] + Vec<3>(0, 10, 0));
  const auto strip = [](Surface<3>& s, Index k) {
    s.facets.push_back({k, k + 1, k + 8});
    s.facets.push_back({k, k + 8, k + 7});
  };
  for (const Index k : {0, 1, 3, 5}) strip(evidence.observed, k);
  for (const Index k : {2, 4}) strip(evidence.unobserved, k);
  const ObservedPart<3> part(evidence);
  EXPECT_NEAR(part.nearest_gap({1.9, 5, 0}).margin, 0.1, 1e-12);
  EXPECT_NEAR(part.nearest_gap({1.9, 5, 0}).half_width, 0.5 / 3, 1e-12);
  EXPECT_NEAR(part.nearest_gap({3.7, 5, 0}).half_width, 0.1 / 3, 1e-12);
}

TEST(MeasuredParts, TheCapOfAWholeBallIsNotMeasuredAgainstOneWithout) {
  const MendedSurface cut = cut_ball();
  const Surface<3> whole = unit_sphere(5);
  const ObservedPart<3> part(cut.evidence), all;
  const auto is_below = [](const Vec<3>& x) { return x.z() < height - 0.05; };
  const auto is_above = [](const Vec<3>& x) { return x.z() > height + 0.05; };
  const MeasuredParts<3> template_cut(all, whole, part), reference_cut(part, cut.surface, all);
  const std::vector<char> deformed = template_cut.of_deformed(whole),
                          reached = reference_cut.of_template(whole.vertices, cut.surface);
  ASSERT_EQ(deformed.size(), whole.vertices.size());
  for (std::size_t v = 0; v < whole.vertices.size(); ++v) {
    const Vec<3>& x = whole.vertices[v];
    if (!is_below(x) && !is_above(x)) continue;
    EXPECT_EQ(deformed[v] != 0, is_below(x)) << x.transpose();
    EXPECT_EQ(reached[v] != 0, is_below(x)) << x.transpose();
  }
  const std::vector<char> facets = template_cut.of_facets(whole, whole);
  for (std::size_t f = 0; f < facets.size(); ++f) {
    const auto& [a, b, c] = whole.facets[f];
    const Vec<3> centre = (whole.vertices[a] + whole.vertices[b] + whole.vertices[c]) / 3;
    if (!is_below(centre) && !is_above(centre)) continue;
    EXPECT_EQ(facets[f] != 0, is_below(centre));
  }
  EXPECT_TRUE(MeasuredParts<3>(all, whole, all).of_deformed(whole).empty());

  // All that is measured agrees, whichever of the two is cut; without the parts the cap is a quarter of the diagonal
  // away.
  for (const MatchQuality<3>& q : {match_quality(whole, SignedDistance<3>(cut.surface), template_cut),
                                   match_quality(cut.surface, SignedDistance<3>(whole), reference_cut)}) {
    EXPECT_LT(q.deformed_to_template.max, 1e-3);
    EXPECT_LT(q.template_to_deformed.max, 1e-3);
    EXPECT_EQ(q.uncovered, 0);
  }
  EXPECT_GT(match_quality(whole, SignedDistance<3>(cut.surface)).deformed_to_template.max, 0.1);
}

TEST(MeasuredParts, NothingInCommonHasNoFigures) {
  const MendedSurface cut = cut_ball();
  Surface<3> above = unit_sphere(3);
  for (Vec<3>& x : above.vertices) x = 0.1 * x + Vec<3>(0, 0, 1.5);
  const MeasuredParts<3> parts({}, above, ObservedPart<3>(cut.evidence));
  const MatchQuality<3> q = match_quality(above, SignedDistance<3>(cut.surface), parts);
  EXPECT_TRUE(std::isnan(q.deformed_to_template.mean));
  EXPECT_TRUE(q.farthest_of_deformed.hasNaN());
}

}  // namespace
}  // namespace shellmatch
