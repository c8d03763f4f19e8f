// What `inspect` reports, on shapes whose answers are known.

#include "matching/shape_report/inspection.h"

#include "geometry/surface/self_intersections.h"

#include <gtest/gtest.h>

#include <cmath>

namespace shellmatch {
namespace {

template <int Dim>
Shape<Dim> shape_of(Surface<Dim> surface) {
  Shape<Dim> shape;
  shape.source = "test";
  shape.original.vertices = surface.vertices;
  for (const auto& facet : surface.facets) shape.original.polygons.emplace_back(facet.begin(), facet.end());
  shape.surface = std::move(surface);
  return shape;
}

void add_circle(Surface<2>& s, int n, double radius, const Vec<2>& centre) {
  const auto first = static_cast<Index>(s.vertices.size());
  for (int i = 0; i < n; ++i) {
    const double t = 2 * M_PI * i / n;
    s.vertices.push_back(centre + radius * Vec<2>(std::cos(t), std::sin(t)));
    s.facets.push_back({first + i, first + (i + 1) % n});
  }
}

// Radii `major` and `minor` about the z axis.
Surface<3> torus(int n, int m, double major, double minor) {
  Surface<3> s;
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < m; ++j) {
      const double a = 2 * M_PI * i / n, b = 2 * M_PI * j / m, r = major + minor * std::cos(b);
      s.vertices.emplace_back(r * std::cos(a), r * std::sin(a), minor * std::sin(b));
      const auto at = [&](int k, int l) { return static_cast<Index>((k % n) * m + l % m); };
      s.facets.push_back({at(i, j), at(i + 1, j), at(i + 1, j + 1)});
      s.facets.push_back({at(i, j), at(i + 1, j + 1), at(i, j + 1)});
    }
  return s;
}

TEST(Inspection, Circle) {
  Surface<2> circle;
  add_circle(circle, 200, 3, {5, 5});
  const Inspection i = inspect_shape(shape_of(circle));
  EXPECT_EQ(i.dimension, 2);
  EXPECT_EQ(i.n_components, 1u);
  EXPECT_NEAR(i.curvature_radius, 3, 0.01);
  EXPECT_NEAR(i.measure, 2 * M_PI * 3, 0.01);
  EXPECT_NEAR(i.enclosed, 9 * M_PI, 0.02);
  EXPECT_NEAR(i.box_min[0], 2, 1e-3);
}

TEST(Inspection, ComponentsAreCounted) {
  Surface<2> circles;
  for (int k = 0; k < 3; ++k) add_circle(circles, 20, 1, {3.0 * k, 0});
  EXPECT_EQ(inspect_shape(shape_of(circles)).n_components, 3u);
}

TEST(Inspection, Torus) {
  const Inspection i = inspect_shape(shape_of(torus(120, 60, 2, 0.5)));
  EXPECT_EQ(i.dimension, 3);
  EXPECT_EQ(i.genus, 1);
  EXPECT_EQ(i.n_components, 1u);
  EXPECT_NEAR(i.curvature_radius, 0.5, 0.05);
  EXPECT_NEAR(i.enclosed, 2 * M_PI * M_PI * 2 * 0.25, 0.05);
  // Five units wide and fitted with a margin of 0.15 each side, so scaled by 0.14: the radius is then 0.07, and the
  // first level whose cells are at most half of that is 5.
  EXPECT_NEAR(i.scale, 0.7 / 5, 1e-6);
  EXPECT_EQ(i.level_of_curvature, 5);
}

TEST(Inspection, VerticesWithoutFacetsDoNotCount) {
  Surface<3> s = torus(12, 8, 2, 0.5);
  s.vertices.emplace_back(0, 0, 0);
  const Inspection i = inspect_shape(shape_of(s));
  EXPECT_EQ(i.n_vertices, 96u);
  EXPECT_EQ(i.genus, 1);
  EXPECT_EQ(i.n_components, 1u);
}

TEST(Inspection, PartsInsideOthersAreCounted) {
  Surface<3> s = torus(60, 30, 2, 0.5);
  const Surface<3> other = s;
  EXPECT_EQ(inspection_text(inspect_shape(shape_of(s))).find("buried"), std::string::npos);
  for (const Vec<3>& x : other.vertices) s.vertices.push_back(x + Vec<3>(0.01, 0.02, 0.6));  // the tubes overlap by 0.4
  for (const auto& f : other.facets) s.facets.push_back({f[0] + 1800, f[1] + 1800, f[2] + 1800});
  Shape<3> shape = shape_of(s);
  shape.crossing = self_intersecting_facets(s);
  const Inspection i = inspect_shape(shape);
  EXPECT_GT(i.n_buried_vertices, 400u);
  EXPECT_NEAR(i.burial_depth, 0.46, 0.1);
  EXPECT_GT(i.buried_share, 0.1);
  EXPECT_LT(i.buried_share, 0.4);
  EXPECT_NE(inspection_text(i).find("inside other parts of the shape"), std::string::npos);
  EXPECT_NE(inspection_json(i).find("\"buried\""), std::string::npos);
}

TEST(Inspection, TextAndJsonSayTheSame) {
  Inspection i = inspect_shape(shape_of(torus(12, 8, 2, 0.5)));
  i.notes = {"3 duplicate vertices welded"};
  EXPECT_NE(inspection_text(i).find("3 duplicate vertices welded"), std::string::npos);
  EXPECT_NE(inspection_json(i).find("\"3 duplicate vertices welded\""), std::string::npos);
  EXPECT_NE(inspection_json(i).find("\"genus\": 1"), std::string::npos);
  i.curvature_radius = INFINITY;
  EXPECT_NE(inspection_json(i).find("\"curvature_radius\": null"), std::string::npos);
}

}  // namespace
}  // namespace shellmatch
