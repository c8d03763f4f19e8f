#include "geometry/surface/placement.h"

#include "base/error.h"
#include "tests/geometry/surface/test_surfaces.h"

#include <gmock/gmock-matchers.h>
#include <gtest/gtest.h>

namespace shellmatch {
namespace {

using namespace test;

template <int Dim>
Shape<Dim> shape_of(const Surface<Dim>& surface, const std::string& source) {
  Shape<Dim> shape;
  shape.source = source;
  shape.surface = surface;
  shape.original.vertices = surface.vertices;
  return shape;
}

template <int Dim>
std::string message_of(const Shape<Dim>& a, const Shape<Dim>& b, double clearance) {
  try {
    as_is_placement(a, b, clearance);
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

TEST(Placement, FitCentresBothShapesTogetherAndFillsTheLongestSide) {
  const Shape<3> a = shape_of(box({10, 20, 30}, {11, 21, 31}), "a.off");
  const Shape<3> b = shape_of(box({13, 20.5, 30}, {14, 21, 32}), "b.off");
  for (const double margin : {0.0, 0.1, 0.3}) {
    const Similarity<3> placement = fit_placement(a, b, margin);
    Box<3> placed;
    for (const Shape<3>* shape : {&a, &b}) {
      Surface<3> surface = shape->surface;
      apply_similarity(placement, surface);
      for (const Vec<3>& x : surface.vertices) placed.add(x);
    }
    EXPECT_LT((0.5 * (placed.min + placed.max) - Vec<3>::Constant(0.5)).norm(), 1e-14);
    EXPECT_NEAR((placed.max - placed.min).maxCoeff(), 1 - 2 * margin, 1e-14);
    // A similarity: the sides keep their proportions 4 : 1 : 2.
    EXPECT_LT(((placed.max - placed.min) / (1 - 2 * margin) - Vec<3>(1, 0.25, 0.5)).norm(), 1e-14);
  }
}

TEST(Placement, InverseUndoesIt) {
  const Shape<2> a = shape_of(polygon(5, [](double) { return 300.0; }), "a.csv");
  const Similarity<2> placement = fit_placement(a, a, 0.2);
  for (const Vec<2>& x : random_points<2>(20, {-300, -300}, {300, 300})) {
    EXPECT_LT((placement.inverse(placement(x)) - x).norm(), 1e-12 * 300);
    EXPECT_LT((placement(placement.inverse(x)) - x).norm(), 1e-12 * 300);
  }
}

TEST(Placement, VerticesWithoutFacetsDoNotCount) {
  Shape<2> a = shape_of(polygon(6, [](double) { return 0.2; }), "a.csv");
  const Similarity<2> before = fit_placement(a, a, 0.1);
  a.surface.vertices.emplace_back(50, 50);
  EXPECT_EQ(fit_placement(a, a, 0.1).scale, before.scale);
}

TEST(Placement, ShapesWithoutExtentAreRefused) {
  const Shape<3> a = shape_of(box({1, 1, 1}, {1, 1, 1}), "point.off");
  EXPECT_THROW(fit_placement(a, a, 0.1), InputError);
}

TEST(Placement, AsIsIsTheIdentityInsideAndNamesTheOffenderOutside) {
  const Shape<3> inside = shape_of(box({0.1, 0.1, 0.1}, {0.9, 0.8, 0.7}), "inside.off");
  const Shape<3> outside = shape_of(box({0.1, 0.1, 0.1}, {0.9, 0.8, 1.5}), "outside.off");
  const Similarity<3> placement = as_is_placement(inside, inside, 0.05);
  EXPECT_EQ(placement.scale, 1);
  EXPECT_EQ(placement.offset, Vec<3>(0, 0, 0));
  EXPECT_EQ(message_of(inside, inside, 0.05), "");
  // Corner 4 is the first one at the height 1.5.
  const std::string message = message_of(inside, outside, 0.05);
  EXPECT_THAT(message, testing::HasSubstr("outside.off"));
  EXPECT_THAT(message, testing::HasSubstr("vertex 4 at (0.1, 0.1, 1.5)"));
  EXPECT_THAT(message, testing::HasSubstr("[0.05, 0.95]^3"));
  EXPECT_THAT(message_of(outside, inside, 0.05), testing::HasSubstr("outside.off"));
  // Within the domain, but too near to its upper and to its lower end.
  const Shape<3> high = shape_of(box({0.1, 0.1, 0.1}, {0.9, 0.96, 0.7}), "high.off");
  const Shape<3> low = shape_of(box({0.1, 0.04, 0.1}, {0.9, 0.8, 0.7}), "low.off");
  EXPECT_THAT(message_of(inside, high, 0.05), testing::HasSubstr("high.off"));
  EXPECT_THAT(message_of(inside, low, 0.05), testing::HasSubstr("low.off"));
  EXPECT_THAT(message_of(inside, inside, 0.15), testing::HasSubstr("vertex 0"));
}

}  // namespace
}  // namespace shellmatch
