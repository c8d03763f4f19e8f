// Where a deformed vertex lies on the template's file, and how far the template is from the deformed reference.

#include "geometry/generate/generate_shape.h"
#include "geometry/repair/make_shape.h"
#include "geometry/repair/repair_steps.h"
#include "geometry/surface/facet_point.h"
#include "matching/result/deformed_shape.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <random>

namespace shellmatch {
namespace {

const VertexAttribute& column(const auto& shape, const std::string& name) {
  const auto at = std::ranges::find(shape.attributes, name, &VertexAttribute::name);
  if (at == shape.attributes.end()) throw std::runtime_error("no column " + name);
  return *at;
}

template <int Dim>
Similarity<Dim> some_placement() {
  Similarity<Dim> placement;
  placement.scale = 0.01;
  placement.offset = Vec<Dim>::LinSpaced(0.3, 0.2);
  return placement;
}

/// The point that the columns name.
template <int Dim>
Vec<Dim> named_point(const OriginalShape<Dim>& deformed, const OriginalShape<Dim>& template_shape, std::size_t i) {
  Vec<Dim> x = Vec<Dim>::Zero();
  double sum = 0;
  const auto& polygon = template_shape.polygons.at(
      static_cast<std::size_t>(column(deformed, Dim == 3 ? "template_face" : "template_ring").values[i]));
  for (int k = 0; k < Dim; ++k) {
    const auto v = static_cast<Index>(column(deformed, "template_v" + std::to_string(k)).values[i]);
    const double b = column(deformed, "template_b" + std::to_string(k)).values[i];
    EXPECT_NE(std::ranges::find(polygon, v), polygon.end()) << "the vertex is one of the face";
    EXPECT_GE(b, 0);
    sum += b;
    x += b * template_shape.vertices[v];
  }
  EXPECT_NEAR(sum, 1, 1e-12);
  return x;
}

// Against all triangles of the file: a face that repeats a corner, one without area and quads among them.
TEST(NearestFaces, AreThoseOfTheFile) {
  OriginalShape<3> cube;
  for (int i = 0; i < 8; ++i) cube.vertices.push_back(20 * Vec<3>(i & 1, i >> 1 & 1, i >> 2 & 1));
  cube.vertices.push_back({10, 0, 0});
  cube.polygons = {{0, 8, 1}, {0, 0, 1, 5}, {0, 2, 3, 1}, {4, 5, 7, 6},
                   {0, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}};
  std::mt19937 random(3);
  std::uniform_real_distribution<double> uniform(-10, 30);
  OriginalShape<3> deformed;
  for (int i = 0; i < 200; ++i) deformed.vertices.push_back({uniform(random), uniform(random), uniform(random)});
  deformed.vertices.insert(deformed.vertices.end(), cube.vertices.begin(), cube.vertices.end());
  deformed.attributes.push_back({"template_face", "double", std::vector<double>(deformed.vertices.size(), 99)});
  add_correspondence(deformed, cube, some_placement<3>());
  EXPECT_EQ(deformed.attributes.size(), 7u);
  EXPECT_EQ(column(deformed, "template_face").type, "int");
  std::vector<Index> polygon_of;
  const Surface<3> all{cube.vertices, triangulate(cube, &polygon_of)};
  ASSERT_EQ(polygon_of.size(), all.facets.size());
  for (std::size_t i = 0; i < deformed.vertices.size(); ++i) {
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t f = 0; f < all.facets.size(); ++f)
      least = std::min(
          least, (closest_point_on_facet(all, static_cast<Index>(f), deformed.vertices[i]).point - deformed.vertices[i])
                     .norm());
    EXPECT_NEAR((named_point(deformed, cube, i) - deformed.vertices[i]).norm(), least, 1e-10);
  }
}

TEST(NearestFaces, AreEdgesOfRingsInThePlane) {
  OriginalShape<2> rings;
  rings.vertices = {{0, 0}, {10, 0}, {10, 10}, {0, 10}, {3, 3}, {3, 6}, {6, 3}};
  rings.polygons = {{0, 1, 2, 3}, {4, 5, 6}};
  OriginalShape<2> deformed;
  deformed.vertices = {{-1, 4}, {2, 4}, {11, -1}, {5, 12}};
  add_correspondence(deformed, rings, some_placement<2>());
  const std::vector<Vec<2>> expected = {{0, 4}, {3, 4}, {10, 0}, {5, 10}};
  for (std::size_t i = 0; i < 4; ++i) EXPECT_LT((named_point(deformed, rings, i) - expected[i]).norm(), 1e-12);
  EXPECT_EQ(column(deformed, "template_ring").values, (std::vector<double>{0, 1, 0, 0}));
}

// A sphere of radius 10 that has become one of radius 9; also where the template is the shape that the pose has moved.
TEST(NearestFaces, TheTemplateKnowsItsDistance) {
  const auto sphere = [](double radius) {
    auto shape = std::get<OriginalShape<3>>(generate_shape("sphere", "", 0.02, {{"radius", 0.4}}));
    for (Vec<3>& x : shape.vertices) x = radius / 0.4 * (x - Vec<3>::Constant(0.5));
    return shape;
  };
  MapFrame<3> frame;
  frame.placement = some_placement<3>();
  const OriginalShape<3> template_shape = sphere(10);
  for (const bool is_backward : {false, true}) {
    frame.is_backward = is_backward;
    frame.pose.scale = 2;
    frame.pose.offset = Vec<3>(1, 0, -3);
    Surface<3> deformed = make_shape(sphere(9), "").surface;
    for (Vec<3>& x : deformed.vertices) x = frame.placement(is_backward ? frame.pose(x) : x);
    const OriginalShape<3> covered = template_with_distance(template_shape, frame, SignedDistance<3>(deformed));
    EXPECT_EQ(covered.vertices, template_shape.vertices);
    EXPECT_EQ(covered.polygons, template_shape.polygons);
    const VertexAttribute distance = column(covered, "distance_to_deformed");
    for (const double d : distance.values) EXPECT_NEAR(d, 1, 0.03);
  }
}

}  // namespace
}  // namespace shellmatch
