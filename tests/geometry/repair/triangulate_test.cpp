// Triangulation of polygons with very many corners: within the polygon where it does not cross itself, and in seconds
// always.
#include "geometry/repair/repair.h"
#include "geometry/repair/repair_steps.h"
#include "tests/geometry/io/files.h"
#include "tests/support/slowdown.h"

#include <Eigen/Geometry>

#include <chrono>
#include <cmath>
#include <numbers>
#include <random>

namespace shellmatch::testing {

namespace {

// All triangles of a polygon that does not cross itself lie within it, also where it has very many corners.
TEST(Repair, AFaceOfVeryManyCornersKeepsItsArea) {
  constexpr Index n = 50000;
  OriginalShape<3> shape;
  shape.polygons.emplace_back();
  std::mt19937 random(1);
  double area = 0;
  for (Index v = 0; v < n; ++v) {
    const double angle = 2 * std::numbers::pi * v / n,
                 radius = 1 + 0.3 * std::sin(3 * angle) + 1e-6 * static_cast<double>(random() % 1000);
    shape.vertices.emplace_back(radius * std::cos(angle), radius * std::sin(angle), 0);
    shape.polygons[0].push_back(v);
  }
  for (Index v = 0; v < n; ++v) area += 0.5 * shape.vertices[v].cross(shape.vertices[(v + 1) % n]).z();
  double sum = 0;
  std::size_t n_given_up = 0;
  for (const auto& [a, b, c] : triangulate(shape, nullptr, &n_given_up))
    sum += 0.5 * (shape.vertices[b] - shape.vertices[a]).cross(shape.vertices[c] - shape.vertices[a]).norm();
  EXPECT_NEAR(sum, area, 1e-10);
  EXPECT_EQ(n_given_up, 0u);
}

// So many corners anywhere, closed by a cone: triangles overlap, and the user is told.
TEST(Repair, AFaceThatCrossesItselfTooMuchIsNoted) {
  constexpr Index n = 7000;
  OriginalShape<3> shape;
  shape.polygons.emplace_back();
  std::mt19937 random(1);
  std::uniform_real_distribution<double> uniform(-1, 1);
  for (Index v = 0; v < n; ++v) {
    const double x = uniform(random);
    shape.vertices.emplace_back(x, uniform(random), 0);
    shape.polygons[0].push_back(v);
    shape.polygons.push_back({(v + 1) % n, v, n});
  }
  shape.vertices.emplace_back(0.1, 0.2, 1);
  std::vector<std::string> notes;
  mend_surface(shape, "thing", notes);
  EXPECT_EQ(
      std::ranges::count(notes, "1 polygon with too many crossings of the edges split into triangles that overlap"), 1);
}

// Nearly every corner of it would be looked at for every triangle: 20,000 corners took an hour.
TEST(Repair, AFaceOfVeryManyCornersThatCrossesItselfIsDividedInSeconds) {
  constexpr Index n = 20000;
  OriginalShape<3> shape;
  shape.polygons.emplace_back();
  std::mt19937 random(1);
  for (Index v = 0; v < n; ++v) {
    shape.vertices.emplace_back(random() % 1000, random() % 1000, 0);
    shape.polygons[0].push_back(v);
  }
  const auto begin = std::chrono::steady_clock::now();
  std::size_t n_given_up = 0;
  Surface<3> surface{shape.vertices, triangulate(shape, nullptr, &n_given_up)};
  EXPECT_EQ(n_given_up, 1u);
  EXPECT_LT(std::chrono::steady_clock::now() - begin, std::chrono::seconds(60 * test::slowdown));
  EXPECT_EQ(surface.facets.size(), static_cast<std::size_t>(n) - 2);
  // Its edges are the only ones with one triangle, so that a fan of the other side closes it.
  std::vector<Index> other_side(shape.polygons[0].rbegin(), shape.polygons[0].rend());
  const Index top = n;
  surface.vertices.emplace_back(0, 0, 1);
  for (std::size_t k = 0; k < other_side.size(); ++k)
    surface.facets.push_back({other_side[k], other_side[(k + 1) % other_side.size()], top});
  EXPECT_TRUE(is_closed_and_oriented(surface));
}

}  // namespace

}  // namespace shellmatch::testing
