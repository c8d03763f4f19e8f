#include "energies/elements/sum_factorised_evaluator.h"

#include <gtest/gtest.h>

#include <random>
#include <vector>

namespace shellmatch {
namespace {

using autodiff::Pack;

template <class T>
class ElementBatchOf : public testing::Test {};
using Dimensions = testing::Types<std::integral_constant<int, 2>, std::integral_constant<int, 3>>;
TYPED_TEST_SUITE(ElementBatchOf, Dimensions);

/// Elements of different sizes with random nodal positions.
template <int Dim>
struct Moved {
  ElementBatch<Dim> batch;
  std::mt19937 random{5};
  std::uniform_real_distribution<double> uniform{-1, 1};
  Pack any() {
    Pack p;
    for (int lane = 0; lane < autodiff::pack_size; ++lane) p[lane] = uniform(random);
    return p;
  }
  Moved() {
    for (Pack& u : batch.u) u = any();
    for (int lane = 0; lane < autodiff::pack_size; ++lane) batch.inverse_side[lane] = 1 << (lane % 3 + 2);
    batch.clear_gradient();
  }
};

TYPED_TEST(ElementBatchOf, GivesPositionsAndTheirDerivativesByTheShapeFunctions) {
  constexpr int Dim = TypeParam::value;
  const Moved<Dim> m;
  for (int n_gauss = 1; n_gauss <= max_gauss_points; ++n_gauss) {
    const ShapeTable<Dim> shape(n_gauss);
    SumFactorisedEvaluator<Dim> evaluator(shape);
    SumFactorisedEvaluator<Dim, false> derivatives(shape);
    evaluator.evaluate(m.batch);
    derivatives.evaluate(m.batch);
    for (std::size_t i = 0; i < shape.points.size(); ++i) {
      const auto& q = shape.points[i];
      const std::array<Pack, Dim> y = evaluator.position(i);
      std::array<Pack, Dim * Dim> dphi, alone;
      evaluator.jacobian(i, dphi.data());
      derivatives.jacobian(i, alone.data());
      for (int lane = 0; lane < autodiff::pack_size; ++lane)
        for (int k = 0; k < Dim; ++k) {
          double position = 0;
          std::array<double, Dim> derivative{};
          for (int c = 0; c < n_corners<Dim>; ++c) {
            position += q.n[c] * m.batch.u[c * Dim + k][lane];
            for (int j = 0; j < Dim; ++j)
              derivative[j] += q.dn[c][j] * m.batch.u[c * Dim + k][lane] * m.batch.inverse_side[lane];
          }
          EXPECT_NEAR(y[k][lane], position, 1e-14) << n_gauss;
          for (int j = 0; j < Dim; ++j) {
            EXPECT_NEAR(dphi[k * Dim + j][lane], derivative[j], 1e-13) << n_gauss;
            EXPECT_EQ(alone[k * Dim + j][lane], dphi[k * Dim + j][lane]);
          }
        }
    }
  }
}

// In each lane <evaluate(u), a> = <u, transpose(a)>. Adjoints are added up, and clear_adjoint() discards them.
template <int Dim, bool WithPosition>
void check_transpose(int n_gauss) {
  Moved<Dim> m;
  const ShapeTable<Dim> shape(n_gauss);
  SumFactorisedEvaluator<Dim, WithPosition> evaluator(shape);
  evaluator.evaluate(m.batch);
  Pack expected{}, found{};
  for (const bool counts : {false, true}) {
    evaluator.clear_adjoint();
    for (std::size_t q = 0; q < shape.points.size(); ++q)
      for (int times = 0; times < 2; ++times) {
        std::array<Pack, Dim * Dim> dphi, by_dphi;
        for (Pack& a : by_dphi) a = m.any();
        evaluator.add_by_jacobian(q, by_dphi.data());
        evaluator.jacobian(q, dphi.data());
        if (counts)
          for (int i = 0; i < Dim * Dim; ++i) expected += dphi[i] * by_dphi[i];
        if constexpr (WithPosition) {
          std::array<Pack, Dim> by_y;
          for (Pack& a : by_y) a = m.any();
          evaluator.add_by_position(q, by_y);
          if (counts)
            for (int k = 0; k < Dim; ++k) expected += evaluator.position(q)[k] * by_y[k];
        }
      }
  }
  evaluator.add_to_gradient(m.batch);
  for (int i = 0; i < m.batch.n_dofs; ++i) found += m.batch.u[i] * m.batch.gradient[i];
  for (int lane = 0; lane < autodiff::pack_size; ++lane) EXPECT_NEAR(found[lane], expected[lane], 1e-10) << n_gauss;
  evaluator.add_to_gradient(m.batch);
  for (int i = 0; i < m.batch.n_dofs; ++i) found -= 0.5 * m.batch.u[i] * m.batch.gradient[i];
  for (int lane = 0; lane < autodiff::pack_size; ++lane) EXPECT_NEAR(found[lane], 0, 1e-10) << "added, not set";
}
TYPED_TEST(ElementBatchOf, AddsTheTransposeOfWhatItEvaluates) {
  for (int n_gauss = 1; n_gauss <= max_gauss_points; ++n_gauss) {
    check_transpose<TypeParam::value, true>(n_gauss);
    check_transpose<TypeParam::value, false>(n_gauss);
  }
}

TYPED_TEST(ElementBatchOf, GivesEveryLaneItsGradient) {
  constexpr int Dim = TypeParam::value, n_dofs = ElementBatch<Dim>::n_dofs, n = 5;
  Moved<Dim> m;
  for (Pack& g : m.batch.gradient) g = m.any();
  std::vector<double> stored((n + 1) * n_dofs, 7), added = stored;
  m.batch.store_gradients(n, stored.data());
  m.batch.add_gradients(n, [&](int lane) { return added.data() + (n - 1 - lane) * n_dofs; });
  for (int lane = 0; lane < n; ++lane)
    for (int i = 0; i < n_dofs; ++i) {
      EXPECT_EQ(stored[lane * n_dofs + i], m.batch.gradient[i][lane]);
      EXPECT_EQ(added[(n - 1 - lane) * n_dofs + i], 7 + m.batch.gradient[i][lane]);
    }
  for (int i = 0; i < n_dofs; ++i) {
    EXPECT_EQ(stored[n * n_dofs + i], 7) << "beyond the first n lanes";
    EXPECT_EQ(added[n * n_dofs + i], 7);
  }
}

}  // namespace
}  // namespace shellmatch
