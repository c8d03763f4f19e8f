// Weights of points by their share of a surface, and what cannot be computed with.
#include "geometry/statistics/point_sets.h"

#include "base/error.h"
#include "tests/geometry/statistics/families.h"

#include <gtest/gtest.h>

#include <limits>
#include <string>

namespace shellmatch {
namespace {

using testing::random_sets;

template <class Call>
std::string error_of(const Call& call) {
  try {
    call();
  } catch (const InputError& error) {
    return error.what();
  }
  return "no InputError";
}

bool contains(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

TEST(AreaWeights, OfTwoTriangles) {
  // Areas 1/2 and 2; point 3 is in the second alone, point 4 in none.
  const Eigen::VectorXd points{{0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 4, 9, 9, 9}};
  const Eigen::VectorXd weights = area_weights<3>(points, {{0, 1, 2}, {0, 1, 3}});
  EXPECT_LE((weights - Eigen::VectorXd{{1 / 3.0, 1 / 3.0, 1 / 15.0, 4 / 15.0, 0}}).norm(), 1e-15);
}

TEST(AreaWeights, OfAnOutline) {
  const Eigen::VectorXd points{{0, 0, 3, 0, 3, 1, 0, 1}};
  const Eigen::VectorXd weights = area_weights<2>(points, {{0, 1}, {1, 2}, {2, 3}, {3, 0}});
  EXPECT_LE((weights - Eigen::VectorXd::Constant(4, 0.25)).norm(), 1e-15);
  const Eigen::VectorXd open = area_weights<2>(points, {{0, 1}, {1, 2}});
  EXPECT_LE((open - Eigen::VectorXd{{0.375, 0.5, 0.125, 0}}).norm(), 1e-15);
}

TEST(AreaWeights, SayWhatIsWrong) {
  const Eigen::VectorXd points{{0, 0, 0, 1, 0, 0, 2, 0, 0}};
  EXPECT_TRUE(contains(error_of([&] { area_weights<3>(points, {{0, 1, 2}}); }), "no area"));  // on a line
  EXPECT_TRUE(contains(error_of([&] { area_weights<3>(points, {}); }), "0 facets have no area"));
  EXPECT_TRUE(contains(error_of([&] { area_weights<3>(points, {{0, 1, 2}, {0, 1, 3}}); }), "facet 1 names point 3"));
  EXPECT_TRUE(contains(error_of([&] { area_weights<3>(points, {{0, -1, 2}}); }), "facet 0 names point -1"));
  const Eigen::VectorXd broken = points * std::numeric_limits<double>::quiet_NaN();
  EXPECT_TRUE(contains(error_of([&] { area_weights<3>(broken, {{0, 1, 2}}); }), "not finite"));
}

TEST(PointSets, AreChecked) {
  const Eigen::VectorXd weights = uniform_weights(5);
  PointSets sets = random_sets(3, 5, 4, 1);
  EXPECT_NO_THROW(check_point_sets(sets, weights));
  EXPECT_TRUE(contains(error_of([&] { check_point_sets(sets, uniform_weights(6)); }), "6 weights for 5 points"));
  EXPECT_TRUE(contains(error_of([&] { check_point_sets(sets, 2 * weights); }), "sum of the weights is 2"));
  Eigen::VectorXd negative = weights;
  negative[1] = 0.4;
  negative[3] = 0;
  EXPECT_NO_THROW(check_point_sets(sets, negative));
  negative[3] = -1e-3;
  EXPECT_TRUE(contains(error_of([&] { check_point_sets(sets, negative); }), "weight 3"));
  negative[3] = std::numeric_limits<double>::quiet_NaN();
  EXPECT_TRUE(contains(error_of([&] { check_point_sets(sets, negative); }), "weight 3"));
  sets.coordinates(7, 2) = std::numeric_limits<double>::infinity();
  EXPECT_TRUE(contains(error_of([&] { check_point_sets(sets, weights); }), "shape 2, point 2"));
  EXPECT_TRUE(contains(error_of([&] { check_point_sets({3, Eigen::MatrixXd(15, 0)}, weights); }), "0 shapes"));
  EXPECT_TRUE(contains(error_of([&] { check_point_sets({3, Eigen::MatrixXd::Zero(14, 2)}, weights); }), "no multiple"));
  EXPECT_TRUE(contains(error_of([&] { check_point_sets({4, Eigen::MatrixXd::Zero(20, 2)}, weights); }), "2 or 3"));
}

TEST(PointSets, MeanIsExactForEqualShapes) {
  PointSets sets{2, Eigen::Vector4d(0.1, 1e9 / 3, -0.7, 1 / 3.0).replicate(1, 7)};
  EXPECT_EQ(mean_of(sets), Eigen::VectorXd(sets.coordinates.col(0)));
  sets.coordinates.col(3) *= 8;
  EXPECT_LE((mean_of(sets) - 2 * sets.coordinates.col(0)).norm(), 1e-7);
}

}  // namespace
}  // namespace shellmatch
