#include "grid/inverse/box_tree.h"

#include <gtest/gtest.h>

#include <random>

namespace shellmatch {
namespace {

TEST(BoxTree, FindsTheBoxesThatContainAPoint) {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> uniform(0, 1);
  std::vector<std::pair<Vec<3>, Vec<3>>> boxes;
  const auto point = [&] { return Vec<3>(uniform(random), uniform(random), uniform(random)); };
  for (int i = 0; i < 2000; ++i) {
    const Vec<3> low = point();
    boxes.emplace_back(low, low + 0.2 * point());
  }
  const BoxTree<3> tree(boxes);
  for (int i = 0; i < 500; ++i) {
    const Vec<3> x = i < 50 ? boxes[static_cast<std::size_t>(i)].second : point();  // corners count
    std::vector<Index> expected;
    for (std::size_t b = 0; b < boxes.size(); ++b)
      if ((x.array() >= boxes[b].first.array()).all() && (x.array() <= boxes[b].second.array()).all())
        expected.push_back(static_cast<Index>(b));
    EXPECT_EQ(tree.containing(x), expected);
  }
  EXPECT_TRUE(tree.containing(Vec<3>(5, 5, 5)).empty());
  EXPECT_TRUE(BoxTree<2>({}).containing(Vec<2>(0, 0)).empty());
}

}  // namespace
}  // namespace shellmatch
