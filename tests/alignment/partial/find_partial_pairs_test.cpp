// Half of a bent hand on a whole, straight and turned one.
#include "alignment/partial/find_partial_pairs.h"

#include "alignment/partial/partial_map.h"
#include "alignment/pose/fit_pose.h"
#include "base/parallel.h"
#include "geometry/distance/surface_distance.h"
#include "tests/geometry/generate/generated_surface.h"
#include "tests/geometry/surface/test_surfaces.h"

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <variant>

namespace shellmatch {
namespace {

const GeneratedPair<3>& hands() {
  static const auto pair = std::get<GeneratedPair<3>>(generated_pair("hand", 0.02));
  return pair;
}

Mat<3> turn() { return Eigen::AngleAxisd(2.5, Vec<3>(1, -2, 0.5).normalized()).toRotationMatrix(); }

// The thumb's side; vertices keep their numbers.
Surface<3> half() {
  Surface<3> part = as_surface(hands().reference);
  std::vector<double> x;
  for (const Vec<3>& v : part.vertices) x.push_back(v[0]);
  const double limit = quantile(x, 0.55);
  std::erase_if(part.facets, [&](const auto& f) {
    return std::ranges::any_of(f, [&](Index v) { return part.vertices[v][0] > limit; });
  });
  return part;
}

struct Truth {
  Surface<3> part = half(), whole = test::mapped<3>(as_surface(hands().template_shape), [](const Vec<3>&x) {
                              return Vec<3>(turn() * x + Vec<3>(3, 1, 2));
                            });
  std::vector<CorrespondingPoints> points;
  Truth() {
    std::vector<bool> is_used(part.vertices.size(), false);
    for (const auto& f : part.facets)
      for (const Index v : f) is_used[v] = true;
    for (const auto& t : hands().truth)
      if (is_used[t.vertex])
        points.push_back({part.vertices[t.vertex], Vec<3>(turn() * t.position + Vec<3>(3, 1, 2)), 1});
  }
};

AlignmentOptions few_vertices() {
  AlignmentOptions options;
  options.max_vertices = 1500;
  return options;
}

// Of the map's ends from where they belong, in roots of the whole's area.
double error_of_share(const PartialPairs& found, const Truth& truth, double share, std::size_t candidate = 0) {
  std::vector<double> errors;
  for (const CorrespondingPoints& p : truth.points) {
    const auto& vertices = found.part.surface.vertices;
    const auto v =
        std::ranges::min_element(vertices, {}, [&](const Vec<3>& x) { return (x - p.on_reference).norm(); }) -
        vertices.begin();
    errors.push_back(
        (found.whole.surface.vertices[found.candidates[candidate].map[static_cast<std::size_t>(v)]] - p.on_template)
            .norm());
  }
  return quantile(errors, share) / std::sqrt(surface_measure(truth.whole));
}

TEST(FindPartialPairs, HalfOfAHandIsFoundOnAWholeOne) {
  const Truth truth;
  ASSERT_GT(truth.points.size(), 300u);
  const PartialPairs found = find_partial_pairs(truth.part, truth.whole);
  EXPECT_LT(error_of_share(found, truth, 0.5), 0.08);
  // The others have a limb or more elsewhere.
  EXPECT_GT(found.candidates.size(), 1u);
  for (std::size_t k = 1; k < found.candidates.size(); ++k) EXPECT_GT(error_of_share(found, truth, 0.9, k), 0.15);
  EXPECT_GT(found.margin, 1.02);
  ASSERT_GT(found.candidates[0].pairs.size(), 100u);
  for (const CorrespondingPoints& pair : found.candidates[0].pairs) {
    const auto distance = [](const Surface<3>& surface, const Vec<3>& x) {
      double least = std::numeric_limits<double>::infinity();
      for (const Vec<3>& v : surface.vertices) least = std::min(least, (v - x).norm());
      return least;
    };
    ASSERT_LT(distance(truth.part, pair.on_reference) + distance(truth.whole, pair.on_template), 1e-9);
  }
  // The palm turns as the whole hand does.
  const Pose pose = fit_pose(found.candidates[0].pairs, PoseKind::rigid);
  EXPECT_LT(Eigen::AngleAxisd(pose.rotation.transpose() * turn()).angle(), 0.4);
}

// In millimetres, the whole in metres.
TEST(FindPartialPairs, APartOfALargerIndividualInAnotherUnitIsFound) {
  Truth truth;
  const double size = 1400;
  for (Vec<3>& x : truth.part.vertices) x *= size;
  for (CorrespondingPoints& p : truth.points) p.on_reference *= size;
  const PartialPairs found = find_partial_pairs(truth.part, truth.whole, few_vertices());
  EXPECT_NEAR(found.scale * size, 1, 0.05);
  EXPECT_LT(error_of_share(found, truth, 0.5), 0.08);
  ASSERT_GT(found.candidates[0].pairs.size(), 100u);
  const Pose pose = fit_pose(found.candidates[0].pairs, PoseKind::similarity);
  EXPECT_NEAR(pose.scale * size, 1, 0.1);
}

// Both in two searches, as one takes seconds.
TEST(FindPartialPairs, LandmarksOrderWhatIsFoundWhateverTheNumberOfThreads) {
  const Truth truth;
  const int before = n_threads();
  set_n_threads(1);
  const PartialPairs found = find_partial_pairs(truth.part, truth.whole, few_vertices());
  ASSERT_GT(found.candidates.size(), 1u);
  EXPECT_FALSE(found.candidates[0].landmark_distance);
  // Landmarks that agree with the last candidate, which is wrong.
  std::vector<CorrespondingPoints> landmarks;
  for (std::size_t v = 0; v < found.part.surface.vertices.size(); v += 40)
    landmarks.push_back(
        {found.part.surface.vertices[v], found.whole.surface.vertices[found.candidates.back().map[v]], 1});
  set_n_threads(3);
  PartialPairs by_landmarks = find_partial_pairs(truth.part, truth.whole, few_vertices(), landmarks);
  set_n_threads(before);
  EXPECT_EQ(by_landmarks.candidates[0].map, found.candidates.back().map);
  EXPECT_NEAR(by_landmarks.candidates[0].landmark_distance.value(), 0, 1e-9);
  // But for their order the candidates are the same to the bit.
  std::ranges::stable_sort(by_landmarks.candidates, {}, &PartialCandidate::order);
  ASSERT_EQ(by_landmarks.candidates.size(), found.candidates.size());
  for (std::size_t k = 0; k < found.candidates.size(); ++k) {
    EXPECT_EQ(by_landmarks.candidates[k].map, found.candidates[k].map) << k;
    EXPECT_EQ(by_landmarks.candidates[k].order, found.candidates[k].order) << k;
  }
}

TEST(PartialShape, LengthsAreInTheCommonUnitAndBordersAreKnown) {
  Surface<3> grid;  // 20 x 10 squares
  for (int y = 0; y <= 10; ++y)
    for (int x = 0; x <= 20; ++x) grid.vertices.push_back(Vec<3>(x, y, 0));
  for (Index y = 0; y < 10; ++y)
    for (Index x = 0; x < 20; ++x) {
      const Index v = 21 * y + x;
      grid.facets.push_back({v, v + 1, v + 22});
      grid.facets.push_back({v, v + 22, v + 21});
    }
  const PartialShape shape = make_partial_shape(grid, 10, {});
  EXPECT_NEAR(shape.mass.sum(), 2, 1e-9);
  EXPECT_EQ(shape.to_border[0], 0);
  EXPECT_NEAR(shape.to_border[21 * 5 + 10], 0.5, 1e-9);
  // Derivatives vanish across the border: the first wave along the longer side is half one.
  EXPECT_NEAR(shape.spectrum.values[1], std::pow(M_PI / 2, 2), 0.02);
  const PartialShape closed = make_partial_shape(as_surface(hands().template_shape), 1, {});
  EXPECT_EQ(closed.to_border[0], std::numeric_limits<double>::infinity());
}

}  // namespace
}  // namespace shellmatch
