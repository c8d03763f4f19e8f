// Weights of the band's terms by a mask.

#include "energies/assembly/energy_report.h"
#include "energies/terms/term_names.h"
#include "tests/energies/exact_shapes.h"
#include "tests/energies/matching_problem.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <functional>
#include <numeric>

namespace shellmatch {
namespace {

using namespace test;

// Of two functions of a point, one in the reference's domain and one in the template's.
template <int Dim>
struct FunctionMask : BandMask<Dim> {
  using Function = std::function<double(const Vec<Dim>&)>;
  FunctionMask(Function r, Function t) : of_reference(std::move(r)), of_template(std::move(t)) {}
  void reference_weights(std::span<const Vec<Dim>> x, std::span<double> weights) const override {
    std::ranges::transform(x, weights.begin(), of_reference);
    ++n_references;
  }
  void template_weights(std::span<const Vec<Dim>> y, std::span<double> weights) const override {
    std::ranges::transform(y, weights.begin(), of_template);
  }
  Function of_reference, of_template;
  mutable std::atomic<int> n_references = 0;
};

// A product of a ramp in the reference's domain and one in the template's.
template <int Dim>
struct RampMask final : FunctionMask<Dim> {
  RampMask() : FunctionMask<Dim>([](const Vec<Dim>& x) { return x[0]; }, [](const Vec<Dim>& y) { return 1 - y[1]; }) {}
};

template <class T>
struct BandMasks : ::testing::Test {
  const Octree<T::value> grid = hanging_grid<T::value>(0.28);
  Problem<T::value> problem{grid,
                            exact_fields<T::value>(grid, sphere<T::value>(0.28)),
                            exact_fields<T::value>(grid, sphere<T::value>(0.31)),
                            {.smooth = true}};
  const std::vector<Vec<T::value>> phi = deformed<T::value>(grid, 0.01, 3);
  TermValues all() const {
    TermValues weights;
    for (std::size_t t = 0; t < weights.size(); ++t) weights[t] = 1;
    return weights;
  }
};
using Dimensions = ::testing::Types<std::integral_constant<int, 2>, std::integral_constant<int, 3>>;
TYPED_TEST_SUITE(BandMasks, Dimensions);

TYPED_TEST(BandMasks, ScaleTheTermsOfTheBandAndNoOthers) {
  constexpr int Dim = TypeParam::value;
  auto& p = this->problem;
  const TermValues whole = *p.values(this->phi, this->all());
  double factor = 1;
  const FunctionMask<Dim> mask([](const Vec<Dim>&) { return 0.5; }, [&](const Vec<Dim>&) { return factor; });
  p.energy.set_mask(mask);
  for (const double f : {0.25, 0.0, 1.0}) {  // each in place of the one before
    factor = f;
    p.energy.refresh_mask(this->phi);
    const TermValues masked = *p.values(this->phi, this->all());
    for (const Term band : {"match"_term, "membrane"_term, "bending"_term})
      EXPECT_DOUBLE_EQ(masked[band], 0.5 * f * whole[band]);
    EXPECT_EQ(masked["volume"_term], whole["volume"_term]);
  }
}

TYPED_TEST(BandMasks, AskForTheReferenceOnceAndNotWhereTheBandIsNot) {
  constexpr int Dim = TypeParam::value;
  auto& p = this->problem;
  std::atomic<std::size_t> n_asked = 0;
  const FunctionMask<Dim> mask([](const Vec<Dim>& x) { return x[0] < 0.5 ? 1 : 0; },
                               [&](const Vec<Dim>&) { return ++n_asked, 1.0; });
  p.energy.set_mask(mask);
  const int n_references = mask.n_references;
  p.energy.refresh_mask(this->phi);
  EXPECT_EQ(mask.n_references, n_references);
  EXPECT_GT(n_asked, 0u);
  EXPECT_LT(n_asked, 0.6 * static_cast<double>(p.energy.band().n_active_points()));
}

// The mask is that of x and of phi(x): the identity and a shift see another part of the template's ramp.
TYPED_TEST(BandMasks, AreTakenAtThePointAndAtItsImage) {
  constexpr int Dim = TypeParam::value;
  auto& p = this->problem;
  const auto identity = at_nodes<Dim>(this->grid, [](const Vec<Dim>& x) { return x; });
  const auto shifted =
      at_nodes<Dim>(this->grid, [](const Vec<Dim>& x) { return Vec<Dim>(x + 0.25 * Vec<Dim>::Unit(1)); });
  const RampMask<Dim> mask;
  p.energy.set_mask(mask);
  const auto mean_weight = [&](const std::vector<Vec<Dim>>& at) {
    p.energy.refresh_mask(at);
    double sum = 0;
    const Band<Dim>& band = p.energy.band();
    for (std::size_t b = 0; b < band.batches().size(); ++b)
      for (std::size_t q = 0; q < p.energy.shape().points.size(); ++q)
        sum += autodiff::sum_lanes(band.point(b, q).weight);
    return sum / band.measure();
  };
  // A sphere in the middle: the mean of x0 (1 - x1) is 1/4, as the mean of the product of both deviations is 0.
  EXPECT_NEAR(mean_weight(identity), 0.25, 1e-3);
  EXPECT_NEAR(mean_weight(shifted), 0.125, 1e-3);
}

TYPED_TEST(BandMasks, GradientAndModelAreThoseOfTheMaskedEnergy) {
  constexpr int Dim = TypeParam::value;
  auto& p = this->problem;
  const RampMask<Dim> mask;
  p.energy.set_mask(mask);
  p.energy.refresh_mask(this->phi);
  const std::vector<double> g = p.gradient(this->phi, this->all());
  std::vector<double> v(p.unknowns.size()), x(v.size());
  p.unknowns.restrict_to(at_nodes<Dim>(this->grid, smooth_field<Dim>(8)), v);
  p.unknowns.restrict_to(this->phi, x);
  const auto value = [&](double t) {
    std::vector<double> y(x);
    for (std::size_t i = 0; i < y.size(); ++i) y[i] += t * v[i];
    auto moved = this->phi;
    p.unknowns.expand(y, moved);
    return p.values(moved, this->all())->sum();
  };
  const double h = 1e-5, difference = (value(h) - value(-h)) / (2 * h);
  EXPECT_NEAR(std::inner_product(g.begin(), g.end(), v.begin(), 0.0), difference, 1e-6 * std::abs(difference));
}

TYPED_TEST(BandMasks, AreThoseOfTheReport) {
  constexpr int Dim = TypeParam::value;
  auto& p = this->problem;
  const RampMask<Dim> mask;
  p.energy.set_mask(mask);
  p.energy.refresh_mask(this->phi);
  const TermValues own = *p.values(this->phi, this->all());
  const EnergyReport same =
      report_energy<Dim>(p.unknowns, p.geometry, p.options, p.sigma, 2, this->phi, this->all(), &mask);
  const EnergyReport unmasked =
      report_energy<Dim>(p.unknowns, p.geometry, p.options, p.sigma, 2, this->phi, this->all());
  EXPECT_NEAR(same.values["match"_term], own["match"_term], 1e-12 * own["match"_term]);
  EXPECT_GT(unmasked.values["match"_term], 2 * own["match"_term]);
}

}  // namespace
}  // namespace shellmatch
