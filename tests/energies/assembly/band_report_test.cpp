// What the band report says of maps for which it is known.

#include "energies/assembly/energy_report.h"
#include "energies/terms/term_names.h"
#include "tests/energies/exact_shapes.h"
#include "tests/energies/matching_problem.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace shellmatch {
namespace {

using namespace test;

template <class T>
struct BandReports : ::testing::Test {};
using Dimensions = ::testing::Types<std::integral_constant<int, 2>, std::integral_constant<int, 3>>;
TYPED_TEST_SUITE(BandReports, Dimensions);

template <int Dim>
BandReport means_of(const Problem<Dim>& p, const std::vector<Vec<Dim>>& phi, const TermValues& weights) {
  TermValues values;
  BandSums sums;
  const bool is_possible = p.energy.report(phi, weights, values, sums);
  const BandReport means = sums.means();
  EXPECT_EQ(is_possible, weights["barrier"_term] == 0 || means.folded_share == 0);
  return means;
}

template <int Dim>
BandReport report(const std::function<Vec<Dim>(const Vec<Dim>&)>& map, const TermValues& weights = {}) {
  const Octree<Dim> grid(Dim == 2 ? 6 : 5);
  const auto fields = exact_fields<Dim>(grid, sphere<Dim>(0.3));
  const Problem<Dim> p(grid, fields, fields);
  const auto phi = at_nodes<Dim>(grid, map);
  return means_of(p, phi, weights);
}

TYPED_TEST(BandReports, IdenticalShapesHaveNoAngleAndARotationOfTheSphereNeither) {
  constexpr int Dim = TypeParam::value;
  const BandReport same = report<Dim>([](const Vec<Dim>& x) { return x; });
  EXPECT_LT(same.normal_angle, 1e-4);
  EXPECT_EQ(same.folded_share, 0);
  const double c = std::cos(0.5), s = std::sin(0.5);
  const BandReport turned = report<Dim>([=](const Vec<Dim>& x) {
    Vec<Dim> y = x - centre<Dim>();
    y.template head<2>() = Vec<2>(c * y[0] - s * y[1], s * y[0] + c * y[1]);
    return Vec<Dim>(y + centre<Dim>());
  });
  EXPECT_LT(turned.normal_angle, 0.3);
  EXPECT_EQ(turned.folded_share, 0);
}

TYPED_TEST(BandReports, AMirrorImageIsFoldedThroughout) {
  constexpr int Dim = TypeParam::value;
  for (const Term term : {"match"_term, "barrier"_term}) {  // told also where the energy cannot be evaluated
    const auto mirror = [](const Vec<Dim>& x) {
      Vec<Dim> y = x;
      y[0] = 1 - x[0];
      return y;
    };
    const BandReport mirrored = report<Dim>(mirror, only(term));
    EXPECT_NEAR(mirrored.folded_share, 1, 1e-12);
    // cof of the reflection turns normals to the opposite of the mirrored sphere's.
    EXPECT_NEAR(mirrored.normal_angle, 180, 0.5);
  }
}

// A = I + t e1 e2^T turns the normal n = (cos a, sin a) by -t cos^2 a to first order, and moves the place so
// that n2 turns by -t sin^2 a: what is left is t |cos 2a|, whose mean is 2 t / pi.
TEST(BandReports2d, AShearOfTheCircle) {
  const double t = 0.02;
  const BandReport sheared = report<2>([=](const Vec<2>& x) { return Vec<2>(x[0] + t * (x[1] - 0.5), x[1]); });
  EXPECT_NEAR(sheared.normal_angle, t * 2 / std::numbers::pi * 180 / std::numbers::pi, 0.06);
}

// A grid of more elements than are worked on at a time, with a shape that lies in all of its parts.
TEST(EnergyReport, PiecesMakeTheWhole) {
  const Octree<3> grid(5);
  const auto fields = exact_fields<3>(grid, sphere<3>(0.3)), others = exact_fields<3>(grid, sphere<3>(0.33));
  const Problem<3> p(grid, fields, others, {.points_per_direction = 3});
  const auto phi = deformed<3>(grid, 0.01, 5);
  TermValues weights;
  for (std::size_t t = 0; t < weights.size(); ++t) weights[t] = 1.0 + static_cast<double>(t);
  const double sigma = 2 * grid.finest_side();
  const EnergyReport report = report_energy<3>(p.unknowns, p.geometry, p.options, sigma, 3, phi, weights);
  const TermValues whole = *p.values(phi, weights);
  for (std::size_t t = 0; t < whole.size(); ++t)
    EXPECT_NEAR(report.values[t], whole[t], 1e-12 * whole.sum()) << term_names()[t];
  EXPECT_GT(whole["match"_term], 0);
  const BandReport band = means_of(p, phi, {});
  EXPECT_NEAR(report.band.normal_angle, band.normal_angle, 1e-12);
  // Nothing is claimed of what cannot be evaluated: one cell turned inside out, in the last piece.
  auto folded = phi;
  folded[grid.cell(grid.leaves().back()).nodes[0]].array() += 0.2;
  const EnergyReport none = report_energy<3>(p.unknowns, p.geometry, p.options, sigma, 3, folded, weights);
  for (const double value : none.values) EXPECT_TRUE(std::isnan(value));
  EXPECT_GT(none.band.normal_angle, 0) << "but the band can be looked at";
}

}  // namespace
}  // namespace shellmatch
