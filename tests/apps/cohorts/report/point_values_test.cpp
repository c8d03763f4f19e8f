// Values of known cohorts at the points.

#include "apps/cohorts/report/cohort_report.h"

#include "apps/cohorts/report/shown_shapes.h"
#include "tests/apps/cohorts/report/cohort_samples.h"

#include <gtest/gtest.h>

#include <cmath>
#include <utility>

namespace shellmatch {
namespace {

// Spheres (circles) of radii 1, 2 and 6 around the origin.
template <int Dim>
CohortResult<Dim> spheres() {
  CohortResult<Dim> result = test::sample_cohort<Dim>({.n_subjects = 0, .has_failures = false});
  const std::vector<Vec<Dim>>& vertices = result.surface.vertices;
  result.aligned.coordinates.resize(static_cast<Eigen::Index>(Dim * vertices.size()), 3);
  for (std::size_t v = 0; v < vertices.size(); ++v)
    for (const auto& [c, radius] : {std::pair(0, 1.0), std::pair(1, 2.0), std::pair(2, 6.0)})
      result.aligned.coordinates.col(c).template segment<Dim>(static_cast<Eigen::Index>(Dim * v)) =
          radius * vertices[v].normalized();
  result.subjects.resize(3);
  result.rows = {0, 1, 2};
  result.difference.emplace();
  result.difference->difference = result.aligned.coordinates.col(1) - result.aligned.coordinates.col(0);
  return result;
}

template <int Dim>
void expect_known_values() {
  CohortResult<Dim> result = spheres<Dim>();
  CentralShape<Dim> mean = central_shape(result);
  EXPECT_EQ(mean.kind, "mean");
  EXPECT_NEAR(mean.surface.vertices[5].norm(), 3, 1e-12);
  for (const bool turned : {false, true}) {
    if (turned)
      for (auto& facet : mean.surface.facets) std::swap(facet[0], facet[1]);
    const CohortPointValues values = cohort_point_values(result, mean.surface);
    ASSERT_EQ(values.deviation.size(), mean.surface.vertices.size());
    for (std::size_t v = 0; v < values.deviation.size(); ++v) {
      EXPECT_NEAR(values.deviation[v], std::sqrt((4.0 + 1 + 9) / 2), 1e-9);
      EXPECT_NEAR(values.difference[v], 1, 1e-9);
      EXPECT_NEAR(values.difference_normal[v], 1, 0.02);  // of facets, hence not exactly that of the sphere
    }
  }
  result.difference->difference *= -2;
  EXPECT_NEAR(cohort_point_values(result, mean.surface).difference_normal[3], -2, 0.04);
  EXPECT_NEAR(cohort_point_values(result, mean.surface).difference[3], 2, 1e-9);
}

TEST(CohortPointValues, AreThoseOfSpheresHoweverTheFacetsAreOriented) { expect_known_values<3>(); }
TEST(CohortPointValues, AreThoseOfCirclesHoweverTheSegmentsAreOriented) { expect_known_values<2>(); }

TEST(CohortPointValues, OfOneShapeAreNotDefined) {
  CohortResult<3> result = spheres<3>();
  result.aligned.coordinates.conservativeResize(Eigen::NoChange, 1);
  result.rows = {1};
  result.difference.reset();
  const CentralShape<3> only = central_shape(result);
  EXPECT_EQ(only.kind, "subject");
  const CohortPointValues values = cohort_point_values(result, only.surface);
  EXPECT_TRUE(values.deviation.empty() && values.difference.empty() && values.difference_normal.empty());
}

}  // namespace
}  // namespace shellmatch
