// The same bits for any number of threads.
#include "base/parallel.h"
#include "geometry/statistics/group_difference.h"
#include "geometry/statistics/model_curves.h"
#include "geometry/statistics/procrustes.h"
#include "tests/geometry/statistics/families.h"

#include <gtest/gtest.h>

#include <vector>

namespace shellmatch {
namespace {

class StatisticsThreads : public ::testing::Test {
 protected:
  void TearDown() override { set_n_threads(0); }
};

// All numbers of all results, one after another.
std::vector<double> everything(int dimension) {
  std::vector<double> numbers;
  const auto add = [&](const auto& values) {
    numbers.insert(numbers.end(), values.data(), values.data() + values.size());
  };
  PointSets sets = testing::random_sets(dimension, 700, 90, 1);
  sets.coordinates = (0.3 * sets.coordinates).colwise() + Eigen::VectorXd(10 * sets.coordinates.col(0));
  const Eigen::VectorXd weights = testing::random_weights(700, 2), start = sets.coordinates.col(0);
  const AlignedSets aligned = procrustes(sets, weights, start, ProcrustesKind::similarity);
  add(aligned.sets.coordinates);
  add(aligned.mean);
  const ShapeModel model = fit_shape_model(aligned.sets, weights);
  add(model.modes);
  add(model.variances);
  add(model.scores);
  add(model.inverse_transform(model.sample_scores(20, 3)));
  const ModelCurves curves = model_curves(model, 100, 3);
  for (const auto& curve : {curves.compactness, curves.generalisation, curves.generalisation_error, curves.specificity,
                            curves.specificity_error})
    add(curve);
  std::vector<char> is_b(90, 0);
  std::fill(is_b.begin(), is_b.begin() + 35, 1);
  const GroupDifference groups = group_difference(aligned.sets, weights, is_b, 300, 4);
  for (const auto& values : {groups.difference, groups.statistic, groups.p, groups.p_corrected, groups.q}) add(values);
  numbers.push_back(groups.distance);
  numbers.push_back(groups.global_p);
  return numbers;
}

TEST_F(StatisticsThreads, SameBits) {
  for (const int dimension : {2, 3}) {
    set_n_threads(1);
    const std::vector<double> one = everything(dimension);
    for (const int threads : {2, 5}) {
      set_n_threads(threads);
      EXPECT_EQ(one, everything(dimension)) << threads << " threads";
    }
  }
}

}  // namespace
}  // namespace shellmatch
