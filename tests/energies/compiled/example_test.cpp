// The examples of docs/autodiff.md and docs/adding-an-energy.md.

#include "docs/examples/normal_alignment.h"
#include "tests/energies/autodiff/compiled_against_jets.h"
#include "tests/energies/cost/element_sums.h"
#include "tests/energies/exact_shapes.h"
#include "tests/energies/densities/random_matrices.h"
#include "tests/energies/terms/band_density.h"
#include "tests/support/taylor.h"

namespace shellmatch {
namespace {

using namespace test;
using example::NormalAlignment;

// docs/autodiff.md: (x y + p)^2 / 2. Active inputs x, y; passive input p.
struct HalfSquare {
  static constexpr int n_active = 2, n_passive = 1;
  template <class T, class P>
  static constexpr T evaluate(const T* active, const P* passive) {
    const T s = active[0] * active[1] + passive[0];
    return 0.5 * (s * s);
  }
};

TEST(Example, HowARecordedFunctorBecomesCode) {
  // What was recorded: three inputs, then one node for each operation, s only once.
  constexpr auto tape = autodiff::record<HalfSquare>();
  using autodiff::Op;
  const Op expected[] = {Op::active, Op::active,   Op::passive,  Op::multiply,
                         Op::add,    Op::multiply, Op::constant, Op::multiply};
  ASSERT_EQ(tape.size, std::size(expected));
  for (std::size_t i = 0; i < tape.size; ++i) EXPECT_EQ(tape.nodes[i].op, expected[i]) << "node " << i;

  // The code made from it, on numbers ...
  using Code = autodiff::Compiled<HalfSquare>;
  const double xy[] = {2, 3}, p[] = {4}, seed = 1;
  double derivative[2];
  EXPECT_EQ(Code::value(xy, p), 50);
  EXPECT_EQ(Code::gradient(xy, p, seed, derivative), 50);
  EXPECT_EQ(derivative[0], 30);  // s y
  EXPECT_EQ(derivative[1], 20);  // s x

  // ... and on eight points at once.
  using autodiff::Pack;
  const Pack eight_xy[] = {{0, 1, 2, 3, 4, 5, 6, 7}, Pack{} + 3.0}, eight_p[] = {Pack{} + 4.0};
  Pack eight[2];
  Code::gradient(eight_xy, eight_p, Pack{} + 1.0, eight);
  EXPECT_EQ(eight[0][2], 30);

  // The same functor on ceres::Jet.
  const ceres::Jet<double, 2> jets[] = {{2, 0}, {3, 1}};
  EXPECT_EQ((HalfSquare::evaluate<ceres::Jet<double, 2>, double>(jets, p).v[0]), 30);
}

// docs/adding-an-energy.md: |Dphi n1 - s n2|^2.
//
// 1. It vanishes where it should: here, for rotations.
TEST(Example, ANewTermVanishesForRotations) {
  std::mt19937 random(1);
  const Mat<3> q = random_rotation<3>(random);
  const Vec<3> n1 = random_matrix<3, 1>(random).normalized();
  const TargetPoint<3, double> y{0, small<3>(q * n1), {}};
  const ReferencePoint<3, double> x{0, small<3>(n1), {}};
  const auto density = [&](const Mat<3>& a, double stretch) {
    return band_density<NormalAlignment<3>>(y, small<double, 3>(a), x, Material<double>{1, 1, &stretch});
  };
  EXPECT_NEAR(density(q, 1), 0, 1e-15);
  EXPECT_NEAR(density(2 * q, 1), 1, 1e-14);
  EXPECT_NEAR(density(3 * q, 1), 4, 1e-14);
  EXPECT_NEAR(density(2 * q, 2), 0, 1e-14);
}

// 2. The fast code is the functor.
TEST(Example, ANewTermIsRecordedAsItIs) {
  using Functor = PointFunctor<NormalAlignment<3>>;
  std::array<Inputs<Functor>, autodiff::pack_size> points;
  std::mt19937 random(2);
  std::uniform_real_distribution<double> uniform(-1, 1);
  for (auto& p : points) {
    for (double& v : p.active) v = uniform(random);
    for (double& v : p.passive) v = uniform(random);
  }
  expect_as_jets<Functor>(points);
  expect_good_tape<Functor>();
  using Argument = PointArgument<NormalAlignment<3>>;
  std::array<Inputs<Argument>, autodiff::pack_size> same;
  for (std::size_t lane = 0; lane < points.size(); ++lane) same[lane] = {points[lane].active, points[lane].passive};
  expect_jacobian_as_jets<Argument>(same);
}

// 3. Summed over the band, its gradient is the derivative of its value.
TEST(Example, ANewTermOnAGrid) {
  const Octree<2> grid = hanging_grid<2>(0.28);
  const Problem<2> problem(grid, exact_fields<2>(grid, sphere<2>(0.28)), exact_fields<2>(grid, sphere<2>(0.3)));
  const auto start = deformed<2>(grid, 0.1 * grid.finest_side(), 1);
  const auto direction = at_nodes<2>(grid, smooth_field<2>(2));
  const auto sum_at = [&](double t) {
    auto phi = start;
    for (std::size_t i = 0; i < phi.size(); ++i) phi[i] += t * direction[i];
    ElementSum<2> sum{problem, phi};
    sum.add_term<NormalAlignment<2>>({1.2});
    double derivative = 0;
    for (std::size_t i = 0; i < phi.size(); ++i) derivative += sum.nodal[i].dot(direction[i]);
    return std::pair(sum.value, derivative);
  };
  EXPECT_TRUE(has_derivative([&](double t) { return sum_at(t).first; }, sum_at(0).second));
}

}  // namespace
}  // namespace shellmatch
