// What a result says, for deformations whose answer is known in closed form.
#include "matching/result/correspondence.h"
#include "matching/map_file/map_fields.h"
#include "matching/result/deformed_shape.h"
#include "matching/result/figures.h"

#include "geometry/generate/generate_shape.h"
#include "geometry/surface/subdivision.h"
#include "tests/geometry/surface/test_surfaces.h"

#include <gtest/gtest.h>

#include <Eigen/LU>

#include <cmath>
#include <numbers>

namespace shellmatch {
namespace {

/// x -> A x + b on a grid, with a placement that is neither a shift nor a scaling alone.
template <int Dim>
Deformation<Dim> linear_map(const Mat<Dim>& a, const Vec<Dim>& b) {
  Deformation<Dim> d{{}, Octree<Dim>(2), {}};
  for (Index node = 0; node < d.grid.n_nodes(); ++node) d.phi.push_back(a * d.grid.node_position(node) + b);
  d.placement.scale = 0.01;
  d.placement.offset = Vec<Dim>::LinSpaced(0.3, 0.2);
  return d;
}

/// The unit domain's sphere of radius 0.2.
Surface<3> sphere() {
  const auto shape = std::get<OriginalShape<3>>(generate_shape("sphere", "", 0.03, {{"radius", 0.2}}));
  Surface<3> s{shape.vertices, {}};
  for (const auto& p : shape.polygons) s.facets.push_back({p[0], p[1], p[2]});
  return s;
}

/// A curve's ring in the user's coordinates of linear_map: a square with 20 pieces on every second side.
OriginalShape<2> uneven_square(const Similarity<2>& placement) {
  OriginalShape<2> shape;
  const Vec<2> corners[] = {{0.3, 0.3}, {0.6, 0.3}, {0.6, 0.6}, {0.3, 0.6}};
  shape.polygons.resize(1);
  for (int side = 0; side < 4; ++side)
    for (int k = 0, n = side % 2 ? 1 : 20; k < n; ++k) {
      shape.polygons[0].push_back(static_cast<Index>(shape.vertices.size()));
      const Vec<2>&a = corners[side], &b = corners[(side + 1) % 4];
      shape.vertices.push_back(placement.inverse(a + (b - a) * (double(k) / n)));
    }
  return shape;
}

template <int Dim>
std::vector<Vec<Dim>> carried(const OriginalShape<Dim>& shape, const Deformation<Dim>& map) {
  std::vector<Vec<Dim>> vertices;
  for (const Vec<Dim>& x : shape.vertices) vertices.push_back(map.apply(x));
  return vertices;
}

template <int Dim>
Surface<Dim> moved(Surface<Dim> s, const Mat<Dim>& a) {
  const Vec<Dim> centre = Vec<Dim>::Constant(0.5);
  for (Vec<Dim>& x : s.vertices) x = centre + a * (x - centre);
  return s;
}

// A box of twelve triangles, bent: between its vertices it follows the deformation, not the chords.
TEST(TwoSidedDistance, LargeFacetsBendWithTheDeformation) {
  const auto bent = [](const Surface<3>& s) {
    return test::mapped<3>(s, [](const Vec<3>& x) {
      return Vec<3>(x.x() + 0.05 * std::sin(std::numbers::pi * (x.y() - 0.3) / 0.4), x.y(), x.z());
    });
  };
  const Surface<3> box = test::box({0.3, 0.3, 0.3}, {0.7, 0.7, 0.7});
  const SignedDistance<3> target(bent(subdivided(box, 0.01)));
  const TwoSidedDistance fine = two_sided_distance<3>(box, bent, target, {}, 1.0 / 32).figures;
  EXPECT_LT(std::max(fine.template_to_deformed.max, fine.deformed_to_template.max), 1e-3);
  // Cells larger than the box tell nothing of what lies between.
  EXPECT_GT(two_sided_distance<3>(box, bent, target, {}, 4).figures.template_to_deformed.max, 0.05);
}

TEST(MatchResult, ThePlacementIsUndone) {
  const Mat<2> a = (Mat<2>() << 1.1, 0.2, -0.1, 0.9).finished();
  const Vec<2> b(0.01, 0.02);
  const auto map = linear_map<2>(a, b);
  const auto& p = map.placement;
  const OriginalShape<2> square = uneven_square(p);
  Surface<2> far{{{0.1, 0.8}, {0.9, 0.8}, {0.9, 0.9}, {0.1, 0.9}}, {{0, 1}, {1, 2}, {2, 3}, {3, 0}}};
  const auto result = deformed_original(square, carried(square, map), map, SignedDistance<2>(far));
  EXPECT_EQ(result.polygons, square.polygons);
  ASSERT_EQ(result.attributes.size(), 2u);
  EXPECT_EQ(result.attributes[0].name, "distance_to_template");
  EXPECT_EQ(result.attributes[1].name, "length_ratio");
  double before = 0, after = 0;
  for (std::size_t v = 0; v < square.vertices.size(); ++v) {
    // In the user's coordinates the map is x -> A x + c, so that its lengths do not see the placement.
    const Vec<2> c = (a * p.offset + b - p.offset) / p.scale, y = a * square.vertices[v] + c;
    EXPECT_LT((result.vertices[v] - y).norm(), 1e-11);
    // The lower side of the far rectangle is nearest, its length in the user's unit.
    EXPECT_NEAR(result.attributes[0].values[v], (0.8 - p(y).y()) / p.scale, 1e-10);
    const std::size_t next = (v + 1) % square.vertices.size(), last = (v ? v : square.vertices.size()) - 1;
    const Vec<2> forth = square.vertices[next] - square.vertices[v], back = square.vertices[last] - square.vertices[v];
    before = forth.norm() + back.norm();
    after = (a * forth).norm() + (a * back).norm();
    EXPECT_NEAR(result.attributes[1].values[v], after / before, 1e-12);
  }
}

TEST(MatchResult, AreaRatiosInSpaceAreThoseOfAPolygonsPlane) {
  const auto map = linear_map<3>(Vec<3>(2, 1, 0.5).asDiagonal(), Vec<3>::Zero());
  OriginalShape<3> quads;
  for (const Vec<3>& x : {Vec<3>(0, 0, 0), {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0, 0, 5}, {0, 1, 5}, {0, 1, 6}, {0, 0, 6}})
    quads.vertices.push_back(x);
  quads.polygons = {{0, 1, 2, 3}, {4, 5, 6, 7}};  // across z, and across x
  const auto result = deformed_original(quads, carried(quads, map), map, SignedDistance<3>(sphere()));
  EXPECT_EQ(result.attributes[1].name, "area_ratio");
  for (int v = 0; v < 8; ++v) EXPECT_NEAR(result.attributes[1].values[v], v < 4 ? 2 : 0.5, 1e-12);
}

TEST(MatchResult, DistortionOfASimilarityAndOfAStretch) {
  const Surface<3> reference = sphere();
  const auto distortion_of = [&](const Mat<3>& a) {
    const Surface<3> deformed = moved<3>(reference, a);
    MatchSummary s;
    add_distortion(s, reference, deformed, SignedDistance<3>(reference));
    return s;
  };
  const MatchSummary larger = distortion_of(1.5 * Mat<3>::Identity());
  EXPECT_NEAR(larger.area_distortion->mean, 2.25, 1e-12);
  EXPECT_NEAR(larger.angle_distortion->max, 0, 1e-5);
  EXPECT_EQ(larger.n_flipped_facets, 0u);
  const MatchSummary stretched = distortion_of(Vec<3>(1.5, 1, 1).asDiagonal());
  EXPECT_NEAR(stretched.area_distortion->min, 1, 0.01);
  EXPECT_NEAR(stretched.area_distortion->max, 1.5, 0.01);
  // Where the stretch lies in the tangent plane, a square's diagonals enclose 2 atan(sqrt(s1/s2)).
  const double degrees = (2 * std::atan(std::sqrt(1.5)) - std::numbers::pi / 2) * 180 / std::numbers::pi;
  EXPECT_NEAR(stretched.angle_distortion->max, degrees, 0.1);
  EXPECT_LT(stretched.angle_distortion->min, 0.3);
  EXPECT_EQ(distortion_of(Vec<3>(-1, 1, 1).asDiagonal()).n_flipped_facets, reference.facets.size());
}

// The deformed shape of a result may be the reference of another matching.
TEST(MatchResult, FreshAttributesReplaceThoseOfAnEarlierMatching) {
  const auto map = linear_map<2>(Mat<2>::Identity(), Vec<2>(0, 0.05));
  OriginalShape<2> square = uneven_square(map.placement);
  const Surface<2> far{{{0.1, 0.8}, {0.9, 0.8}, {0.9, 0.9}, {0.1, 0.9}}, {{0, 1}, {1, 2}, {2, 3}, {3, 0}}};
  const SignedDistance<2> distance(far);
  square.attributes.push_back({"label", "int", std::vector<double>(square.vertices.size(), 7)});
  const auto once = deformed_original(square, carried(square, map), map, distance);
  const auto twice = deformed_original(once, carried(once, map), map, distance);
  ASSERT_EQ(twice.attributes.size(), 3u);
  EXPECT_EQ(twice.attributes[0].name, "label");
  EXPECT_EQ(twice.attributes[1].name, "distance_to_template");
  EXPECT_EQ(twice.attributes[2].name, "length_ratio");
  for (std::size_t v = 0; v < square.vertices.size(); ++v)
    EXPECT_NEAR(twice.attributes[1].values[v], once.attributes[1].values[v] - 0.05 / map.placement.scale, 1e-10);
}

// Weighted by the reference's lengths the mean is the length after over the length before, however it is cut.
TEST(MatchResult, MeanDistortionIsTheRatioOfTheWhole) {
  const OriginalShape<2> square = uneven_square({});
  Surface<2> reference{square.vertices, {}};
  for (Index i = 0, n = static_cast<Index>(square.vertices.size()); i < n; ++i)
    reference.facets.push_back({i, (i + 1) % n});
  MatchSummary s;
  add_distortion(s, reference, moved<2>(reference, Vec<2>(2, 1).asDiagonal()), SignedDistance<2>(reference));
  EXPECT_NEAR(s.area_distortion->mean, 1.5, 1e-12);
  EXPECT_FALSE(s.angle_distortion.has_value());
}

TEST(MatchResult, CorrespondenceErrorIsTheMeanDistance) {
  const Correspondence<2> truth = {{2, {0, 0}}, {0, {1, 1}}};
  EXPECT_DOUBLE_EQ(correspondence_error<2>(truth, {{1, 1}, {9, 9}, {0, 3}}), 1.5);
}

TEST(MatchResult, CellsKnowTheBandAndTheirDeterminant) {
  const Mat<2> a = (Mat<2>() << 1.1, 0.2, -0.1, 0.9).finished();
  const auto map = linear_map<2>(a, Vec<2>::Zero());
  std::vector<double> d1;
  for (Index node = 0; node < map.grid.n_nodes(); ++node) d1.push_back(map.grid.node_position(node)[0] - 0.5);
  const auto fields = cell_fields<2>(map.grid, map.phi, d1, 0.1);
  ASSERT_EQ(fields.size(), 2u);
  for (std::size_t i = 0; i < map.grid.leaves().size(); ++i) {
    // Columns of cells from 0, 1/4, 1/2, 3/4: the two in the middle meet the band between 0.4 and 0.6.
    const double left = map.grid.cell_corner(map.grid.leaves()[i])[0];
    EXPECT_EQ(fields[0].values[i], left == 0.25 || left == 0.5);
    EXPECT_NEAR(fields[1].values[i], a.determinant(), 1e-12);
  }
}

}  // namespace
}  // namespace shellmatch
