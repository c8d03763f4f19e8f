// What the whole energy must be in cases that are known in closed form, and how fast it tends there.

#include "energies/densities/thin_shell.h"
#include "energies/terms/term_names.h"
#include "tests/energies/exact_shapes.h"
#include "tests/energies/matching_problem.h"
#include "tests/energies/densities/random_matrices.h"

#include <gtest/gtest.h>

#include <numbers>
#include <utility>

namespace shellmatch {
namespace {

using namespace test;

template <int Dim>
std::vector<Vec<Dim>> identity(const Octree<Dim>& grid) {
  return at_nodes<Dim>(grid, [](const Vec<Dim>& x) { return x; });
}

template <int Dim>
ExactShape<Dim> test_ellipsoid() {
  return ellipsoid<Dim>(Vec<Dim>::LinSpaced(0.32, 0.24));
}

// The bands have to stay away from the medial axis.
template <int Dim>
constexpr int coarse_level = Dim == 2 ? 5 : 4;

// Order by which `value(grid)` falls from the coarse level to the next.
template <int Dim, class Value>
double order_of(Value&& value) {
  const double coarse = value(Octree<Dim>(coarse_level<Dim>)), fine = value(Octree<Dim>(coarse_level<Dim> + 1));
  return std::log2(coarse / fine);
}

template <class T>
struct Identities : ::testing::Test {};
using Dimensions = ::testing::Types<std::integral_constant<int, 2>, std::integral_constant<int, 3>>;
TYPED_TEST_SUITE(Identities, Dimensions);

TYPED_TEST(Identities, IdenticalShapesCostNothing) {
  constexpr int Dim = TypeParam::value;
  const Octree<Dim> grid = hanging_grid<Dim>(0.28);
  const auto fields = exact_fields<Dim>(grid, test_ellipsoid<Dim>());
  const Problem<Dim> p(grid, fields, fields);
  const auto id = identity<Dim>(grid);
  EXPECT_LT(p.value(id, "match"_term), 1e-17);  // distances are kept in single precision
  EXPECT_LT(std::abs(p.value(id, "membrane"_term)), 1e-13);
  EXPECT_LT(std::abs(p.value(id, "volume"_term)), 1e-13);
  EXPECT_EQ(p.value(id, "barrier"_term), 0);
  EXPECT_LT(p.value(id, "bending"_term), 1e-3);
}

// Interpolated roots of both shapes do not cancel unless one is inverted at the point.
TYPED_TEST(Identities, BendingOfIdenticalShapesFallsWithTheGrid) {
  constexpr int Dim = TypeParam::value;
  const auto shape = test_ellipsoid<Dim>();
  const auto bending = [&](const Octree<Dim>& grid, bool inverse) {
    const Problem<Dim> p(grid, exact_fields<Dim>(grid, shape, inverse ? -0.5 : 0.5), exact_fields<Dim>(grid, shape),
                         {.root_is_inverse = inverse});
    return p.value(identity<Dim>(grid), "bending"_term);
  };
  EXPECT_GT((order_of<Dim>([&](const auto& grid) { return bending(grid, true); })), 3.5);
  EXPECT_GT((order_of<Dim>([&](const auto& grid) { return bending(grid, false); })), 5.5);
  const Octree<Dim> grid(coarse_level<Dim>);
  EXPECT_LT(bending(grid, false), 0.1 * bending(grid, true));
}

template <int Dim>
RigidMotion<Dim> motion() {
  std::mt19937 random(5);
  return {random_rotation<Dim>(random), Vec<Dim>::LinSpaced(0.021, -0.017)};
}

// Values of all terms for the motion on one grid, and the orders by which they fall from the coarse level to the next.
template <int Dim, class MakeFields>
TermValues motion_values(const Octree<Dim>& grid, MakeFields&& fields) {
  auto [reference, target] = fields(grid);
  const Problem<Dim> p(grid, std::move(reference), std::move(target));
  TermValues weights;
  for (std::size_t t = 0; t < weights.size(); ++t) weights[t] = 1;
  return p.values(at_nodes<Dim>(grid, motion<Dim>()), weights).value();
}

template <int Dim, class MakeFields>
TermValues motion_orders(MakeFields&& fields, int level = coarse_level<Dim>) {
  const auto coarse = motion_values<Dim>(Octree<Dim>(level), fields);
  const auto fine = motion_values<Dim>(Octree<Dim>(level + 1), fields);
  EXPECT_LT(std::abs(fine["volume"_term]), 1e-12);
  EXPECT_EQ(fine["barrier"_term], 0);
  TermValues orders;
  for (std::size_t t = 0; t < orders.size(); ++t) orders[t] = std::log2(coarse[t] / fine[t]);
  return orders;
}

TYPED_TEST(Identities, RigidMotionsCostNothingInTheLimit) {
  constexpr int Dim = TypeParam::value;
  const auto shape = test_ellipsoid<Dim>(), image = moved(shape, motion<Dim>());
  const TermValues orders = motion_orders<Dim>([&](const Octree<Dim>& grid) {
    return std::pair(exact_fields<Dim>(grid, shape), exact_fields<Dim>(grid, image));
  });
  // Interpolation errs by h^2. Match and W are quadratic in the error; but an error of the normals' direction turns
  // the membrane's matrix by a rotation to first order, which leaves h^8.
  EXPECT_NEAR(orders["match"_term], 4, 0.5);
  EXPECT_GT(orders["membrane"_term], 6);
  EXPECT_GT(orders["bending"_term], 3.3);
}

// The same with coefficients made from the nodal distances, as the program does.
TYPED_TEST(Identities, RigidMotionsWithComputedCoefficients) {
  constexpr int Dim = TypeParam::value;
  const auto shape = test_ellipsoid<Dim>(), image = moved(shape, motion<Dim>());
  const TermValues orders = motion_orders<Dim>([&](const Octree<Dim>& grid) {
    auto pair = coefficient_pair<Dim>(
        {&grid, &grid},
        nodal_geometry<Dim>(grid, {exact_fields<Dim>(grid, shape).distance, exact_fields<Dim>(grid, image).distance},
                            {}),
        {});
    return std::pair(std::move(pair.reference), std::move(pair.target));
  });
  for (const Term term : {"match"_term, "membrane"_term, "bending"_term})
    EXPECT_GT(orders[term], 3) << term_names()[static_cast<std::size_t>(term)];
}

// A rotated torus, which has curvatures of both signs: where one of them is small, C cuts it, which leaves a kink.
TEST(Identities, RotatedTorusCostsNothingInTheLimit) {
  const auto shape = torus(0.24, 0.13), image = moved(shape, motion<3>());
  const TermValues orders = motion_orders<3>(
      [&](const Octree<3>& grid) { return std::pair(exact_fields<3>(grid, shape), exact_fields<3>(grid, image)); });
  for (const Term term : {"match"_term, "membrane"_term, "bending"_term})
    EXPECT_GT(orders[term], 2.5) << term_names()[static_cast<std::size_t>(term)];
}

// W(diag(by, by, 1))
template <int Dim>
double stretched(double by) {
  Vec<Dim> diagonal = Vec<Dim>::Constant(by);
  diagonal[Dim - 1] = 1;
  return ThinShellDensity<Dim>::value(small<double, Dim>(diagonal.asDiagonal()), Material<double>{1, 1});
}

// Spheres of radii R and R + d, and the map that moves all points outward by d: it stretches by r = 1 + d/R
// along the sphere and takes the curvature 1/R to 1/(R + d).
TYPED_TEST(Identities, ConcentricSpheres) {
  constexpr int Dim = TypeParam::value;
  const double radius = 0.2, offset = 0.06, r = 1 + offset / radius;
  const auto errors = [&](const Octree<Dim>& grid) {
    const Problem<Dim> p(grid, exact_fields<Dim>(grid, sphere<Dim>(radius)),
                         exact_fields<Dim>(grid, sphere<Dim>(radius + offset)), {.points_per_direction = 3});
    const auto phi =
        at_nodes<Dim>(grid, [&](const Vec<Dim>& x) { return Vec<Dim>(x + offset * (x - centre<Dim>()).normalized()); });
    const double area = p.energy.band().measure();
    return std::array{p.value(phi, "match"_term) / area,
                      std::abs(p.value(phi, "membrane"_term) / area / stretched<Dim>(r) - 1),
                      std::abs(p.value(phi, "bending"_term) / area / stretched<Dim>(std::sqrt(r)) - 1)};
  };
  const auto coarse = errors(Octree<Dim>(coarse_level<Dim>)), fine = errors(Octree<Dim>(coarse_level<Dim> + 1));
  EXPECT_GT(std::log2(coarse[0] / fine[0]), 3.5);
  for (int i : {1, 2}) {
    EXPECT_GT(std::log2(coarse[i] / fine[i]), 1.5) << (i == 1 ? "membrane" : "bending");
    EXPECT_LT(fine[i], 0.05);
  }
}

TYPED_TEST(Identities, MeasureOfTheBandTendsToTheAreaOfTheSphere) {
  constexpr int Dim = TypeParam::value;
  const double radius = 0.3, pi = std::numbers::pi;
  const double area = Dim == 2 ? 2 * pi * radius : 4 * pi * radius * radius;
  const auto error = [&](int level, int order) {
    const Octree<Dim> grid(level);
    const auto fields = exact_fields<Dim>(grid, sphere<Dim>(radius));
    const Problem<Dim> p(grid, fields, fields, {.points_per_direction = order});
    return std::abs(p.energy.band().measure() / area - 1);
  };
  EXPECT_LT(error(coarse_level<Dim>, 2), 0.05);
  EXPECT_LT(error(coarse_level<Dim> + 1, 2), 0.02);
  EXPECT_LT(error(coarse_level<Dim> + 1, 4), 0.01);
}

}  // namespace
}  // namespace shellmatch
