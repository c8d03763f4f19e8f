#include "geometry/surface/overlapping_boxes.h"

#include <gtest/gtest.h>

#include <random>
#include <set>
#include <string>

namespace shellmatch {
namespace {

template <int Dim>
void expect_all_pairs_once(const std::vector<Box<Dim>>& boxes, const std::string& what) {
  std::set<std::pair<std::size_t, std::size_t>> expected, found;
  for (std::size_t i = 0; i < boxes.size(); ++i)
    for (std::size_t j = i + 1; j < boxes.size(); ++j)
      if ((boxes[i].min.array() <= boxes[j].max.array()).all() && (boxes[j].min.array() <= boxes[i].max.array()).all())
        expected.emplace(i, j);
  std::size_t n_visits = 0;
  for_overlapping_boxes(boxes, [&](std::size_t i, std::size_t j) {
    ++n_visits;
    found.emplace(std::min(i, j), std::max(i, j));
  });
  EXPECT_EQ(found, expected) << what;
  EXPECT_EQ(n_visits, expected.size()) << what;
}

template <int Dim>
Box<Dim> box_around(std::mt19937& random, double step, const Vec<Dim>& size) {
  Box<Dim> box;
  // On a grid, so that many only touch.
  for (int k = 0; k < Dim; ++k) box.min[k] = step * static_cast<double>(random() % 64);
  box.max = box.min + size;
  return box;
}

TEST(OverlappingBoxes, AreFoundOnceWhateverTheirShapes) {
  std::mt19937 random(3);
  std::vector<Box<3>> small, needles, equal(40), graded, crossed;
  for (int i = 0; i < 800; ++i) {
    small.push_back(box_around<3>(random, 1, {3, 2, 4}));
    Vec<3> size(0.1, 0.1, 0.1);
    size[i % 3] = 60;
    needles.push_back(box_around<3>(random, 1, size));
    graded.push_back(box_around<3>(random, std::ldexp(1.0, -i / 20), Vec<3>::Constant(std::ldexp(2.0, -i / 20))));
    const bool is_across = i % 2 == 0;
    crossed.push_back(box_around<3>(random, 1, is_across ? Vec<3>(64, 0, 0) : Vec<3>(0, 64, 0)));
  }
  for (Box<3>& box : equal) box.add(Vec<3>(1, 2, 3));
  expect_all_pairs_once(small, "small");
  expect_all_pairs_once(needles, "needles");
  expect_all_pairs_once(equal, "equal");
  expect_all_pairs_once(graded, "graded");
  expect_all_pairs_once(crossed, "crossed");
  std::vector<Box<2>> flat;
  for (int i = 0; i < 500; ++i) flat.push_back(box_around<2>(random, 1, {2, 0}));
  expect_all_pairs_once(flat, "in the plane");
}

}  // namespace
}  // namespace shellmatch
