// Small pictures: of whom, and that they show the shapes.

#include "apps/cohorts/report/shown_shapes.h"
#include "apps/cohorts/report/worst_first.h"
#include "tests/apps/cohorts/report/cohort_samples.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace shellmatch {
namespace {

template <int Dim>
SubjectThumbnails pictures_of(const CohortResult<Dim>& result, std::size_t most) {
  return subject_thumbnails(result, central_shape(result).surface, worst_first(result.subjects), most);
}

template <int Dim>
void expect_pictures() {
  CohortResult<Dim> result = test::sample_cohort<Dim>({.n_points = 150});
  // A shape that two have.
  result.aligned.coordinates.col(0) = result.aligned.coordinates.col(1);
  const SubjectThumbnails all = pictures_of(result, 100);
  EXPECT_EQ(all.n_left_out, 0u);
  const Eigen::MatrixXd& shapes = result.aligned.coordinates;
  const Eigen::MatrixXd squares = (shapes.colwise() - result.model->mean).cwiseAbs2();
  const Eigen::VectorXd distances = squares.reshaped(Dim, squares.size() / Dim).colwise().sum().cwiseSqrt();
  EXPECT_NEAR(static_cast<double>((distances.array() <= all.scale_end).count()) / static_cast<double>(distances.size()),
              0.98, 0.002);
  for (std::size_t s = 0; s < result.subjects.size(); ++s) {
    EXPECT_EQ(all.pictures[s].starts_with("\x89PNG"), result.subjects[s].in_model) << s;
    EXPECT_EQ(all.pictures[s].empty(), !result.subjects[s].in_model) << s;
  }
  EXPECT_EQ(all.pictures[0], all.pictures[1]);
  EXPECT_NE(all.pictures[0], all.pictures[5]);
}

TEST(Thumbnails, ShowEachSubjectOfTheStatisticsInSpace) { expect_pictures<3>(); }
TEST(Thumbnails, ShowEachSubjectOfTheStatisticsInThePlane) { expect_pictures<2>(); }

TEST(Thumbnails, LeaveOutTheBest) {
  const CohortResult<2> result = test::sample_cohort<2>({.n_points = 60});
  const std::vector<std::size_t> order = worst_first(result.subjects);
  const SubjectThumbnails some = pictures_of(result, 4);
  EXPECT_EQ(some.n_left_out, result.rows.size() - 4);
  std::size_t n_seen = 0;
  for (const std::size_t s : order) {
    if (!result.subjects[s].in_model) continue;
    EXPECT_EQ(some.pictures[s].empty(), ++n_seen > 4) << s;
  }
}

// One subject is its own mean: no colours. None has no picture.
TEST(Thumbnails, OfOneSubjectAndOfNone) {
  const CohortResult<3> one = test::sample_cohort<3>({.n_subjects = 1, .n_points = 100, .has_failures = false});
  EXPECT_EQ(pictures_of(one, 10).scale_end, 0);
  EXPECT_FALSE(pictures_of(one, 10).pictures[0].empty());
  CohortResult<3> none = test::sample_cohort<3>({.n_subjects = 0, .has_failures = false});
  none.subjects.resize(2);
  EXPECT_EQ(pictures_of(none, 10).pictures, (std::vector<std::string>{"", ""}));
}

}  // namespace
}  // namespace shellmatch
