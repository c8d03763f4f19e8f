// Whether corresponding points look alike: nothing for a copy of another size, much for head on tail, none where little
// is known.
#include "matching/result/spin_difference.h"

#include "geometry/repair/repair_steps.h"
#include "matching/input/shape_source.h"
#include "tests/geometry/surface/test_surfaces.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <variant>

namespace shellmatch {
namespace {

const ObservedPair<3> all_is_known;

Surface<3> dolphin() { return std::get<Shape<3>>(open_shape("generate:dolphin/straight")).surface; }

Surface<3> half_as_large(const Surface<3>& surface) {
  return test::mapped<3>(surface, [](const Vec<3>& x) { return Vec<3>(0.5 * x); });
}

TEST(SpinDifference, IsNothingForACopyOfAnySize) {
  const Surface<3> shape = dolphin(), smaller = half_as_large(shape);
  EXPECT_NEAR(spin_difference<3>(shape, shape, shape, all_is_known, false).value(), 0, 1e-6);
  EXPECT_LT(spin_difference<3>(shape, smaller, smaller, all_is_known, false).value(), 0.02);
  EXPECT_GT(spin_difference<3>(shape, smaller, smaller, all_is_known, true).value(), 0.1)
      << "no part of that size is like it";
}

TEST(SpinDifference, IsLargeWhereHeadLiesOnTail) {
  const Surface<3> shape = dolphin();
  const auto box = bounding_box(shape.vertices);
  int length = 0;
  (box.max - box.min).maxCoeff(&length);
  const Surface<3> reversed = test::mapped<3>(shape, [&](Vec<3> x) {
    x[length] = box.min[length] + box.max[length] - x[length];
    return x;
  });
  EXPECT_GT(spin_difference<3>(shape, reversed, shape, all_is_known, false).value(), 0.4);
}

TEST(SpinDifference, ComparesThePartsThatBothHave) {
  const Surface<3> shape = dolphin();
  const auto box = bounding_box(shape.vertices);
  int length = 0;
  (box.max - box.min).maxCoeff(&length);
  const double middle = 0.5 * (box.min[length] + box.max[length]), unit = std::sqrt(surface_measure(shape));
  const auto is_known = [&](const Vec<3>& x) { return std::abs(x[length] - middle) < 0.15 * unit; };
  // All points of the slice lie beside its borders. What was made up beyond is thin.
  const Surface<3> slice = test::mapped<3>(shape, [&](Vec<3> x) {
    if (is_known(x)) return x;
    for (int d = 0; d < 3; ++d)
      if (d != length) x[d] = 0.5 * (box.min[d] + box.max[d]) + 0.1 * (x[d] - 0.5 * (box.min[d] + box.max[d]));
    return x;
  });
  Evidence<3> evidence{slice, slice};
  evidence.observed.facets.clear();
  evidence.unobserved.facets.clear();
  for (const auto& facet : slice.facets) {
    const bool known = std::ranges::all_of(facet, [&](Index v) { return is_known(shape.vertices[v]); });
    (known ? evidence.observed : evidence.unobserved).facets.push_back(facet);
  }
  const ObservedPair<3> part{ObservedPart<3>(evidence), {}};
  EXPECT_LT(spin_difference<3>(slice, slice, shape, part, true).value(), 0.05);
  const Surface<3> reversed = test::mapped<3>(slice, [&](Vec<3> x) {
    x[length] = 2 * middle - x[length];
    return x;
  });
  EXPECT_GT(spin_difference<3>(slice, reversed, shape, part, true).value(), 0.1);
}

TEST(SpinDifference, TellsOfCoarseMeshesToo) {
  const Surface<3> shape = simplified(dolphin(), 200);
  ASSERT_LT(shape.vertices.size(), 250u);
  EXPECT_NEAR(spin_difference<3>(shape, shape, shape, all_is_known, false).value(), 0, 1e-6);
  const auto box = bounding_box(shape.vertices);
  const Surface<3> turned = test::mapped<3>(shape, [&](const Vec<3>& x) { return Vec<3>(box.min + box.max - x); });
  EXPECT_GT(spin_difference<3>(shape, turned, shape, all_is_known, false).value(), 0.3);
}

TEST(SpinDifference, IsUnknownWithoutEnoughPoints) {
  const Surface<3> coarse = test::unit_sphere(1), shape = dolphin();
  EXPECT_FALSE(spin_difference<3>(coarse, coarse, coarse, all_is_known, false));
  // Half of it was made up: what is known lies beside the gap.
  Evidence<3> evidence{shape, shape};
  evidence.observed.facets.clear();
  evidence.unobserved.facets.clear();
  for (std::size_t f = 0; f < shape.facets.size(); ++f)
    (f % 2 == 0 ? evidence.observed : evidence.unobserved).facets.push_back(shape.facets[f]);
  const ObservedPair<3> half{ObservedPart<3>(evidence), {}};
  EXPECT_FALSE(spin_difference<3>(shape, shape, shape, half, true));
  EXPECT_FALSE(spin_difference<2>({}, {}, {}, {}, false));
}

}  // namespace
}  // namespace shellmatch
