// The same bits whatever the number of threads.

#include "base/parallel.h"
#include "tests/energies/exact_shapes.h"
#include "tests/energies/matching_problem.h"

#include <gtest/gtest.h>

#include <bit>

namespace shellmatch {
namespace {

using namespace test;

struct Bits {
  std::vector<std::uint64_t> values, gradient;
  double measure;
};

template <int Dim>
Bits evaluate_with(int threads, const Octree<Dim>& grid, const CoefficientFields<Dim>& reference,
                   const CoefficientFields<Dim>& target) {
  set_n_threads(threads);
  ProblemOptions o;
  o.energy.terms.own("fold_threshold") = 0.9;
  const Problem<Dim> p(grid, reference, target, o);
  EXPECT_GT(p.energy.band().batches().size(), 64u) << "too few chunks to tell";
  TermValues weights, values, again;
  for (std::size_t t = 0; t < weights.size(); ++t) weights[t] = 1;
  const auto phi = deformed<Dim>(grid, 0.02, 3);
  std::vector<double> gradient(p.unknowns.size());
  EXPECT_TRUE(p.energy.evaluate(phi, weights, values, gradient));
  EXPECT_TRUE(p.energy.evaluate(phi, weights, again, {}));
  set_n_threads(0);
  Bits bits;
  for (const auto* v : {&values, &again})
    for (const double x : *v) bits.values.push_back(std::bit_cast<std::uint64_t>(x));
  for (const double x : gradient) bits.gradient.push_back(std::bit_cast<std::uint64_t>(x));
  bits.measure = p.energy.band().measure();
  return bits;
}

template <int Dim>
void check(int level) {
  Octree<Dim> grid(level);
  grid.refine([&](Index leaf) { return std::abs((grid.cell_centre(leaf) - centre<Dim>()).norm() - 0.28) < 0.06; });
  const auto reference = exact_fields<Dim>(grid, sphere<Dim>(0.28));
  const auto target = exact_fields<Dim>(grid, ellipsoid<Dim>(Vec<Dim>::LinSpaced(0.33, 0.24)));
  const Bits one = evaluate_with<Dim>(1, grid, reference, target);
  for (const int threads : {2, 3}) {
    const Bits more = evaluate_with<Dim>(threads, grid, reference, target);
    EXPECT_EQ(one.values, more.values);
    EXPECT_EQ(one.gradient, more.gradient);
    EXPECT_EQ(one.measure, more.measure);
  }
}

TEST(Reproducibility, SameBitsForAnyNumberOfThreads) {
  check<2>(7);
  check<3>(4);
}

}  // namespace
}  // namespace shellmatch
