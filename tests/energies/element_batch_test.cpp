#include "energies/element_batch.h"

#include <gtest/gtest.h>

#include <random>

namespace shellmatch {
namespace {

using autodiff::Pack;

template <class T>
class ElementBatchOf : public testing::Test {};
using Dimensions = testing::Types<std::integral_constant<int, 2>, std::integral_constant<int, 3>>;
TYPED_TEST_SUITE(ElementBatchOf, Dimensions);

/// Elements of different sizes, all nodes moved at random.
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
  for (const int n_gauss : {1, 2, 3})
    for (const auto& q : ShapeTable<Dim>(n_gauss).points) {
      std::array<Pack, Dim> y;
      std::array<Pack, Dim * Dim> dphi, alone;
      m.batch.evaluate(q, y, dphi.data());
      m.batch.jacobian(q, alone.data());
      for (int lane = 0; lane < autodiff::pack_size; ++lane)
        for (int k = 0; k < Dim; ++k) {
          double position = 0;
          std::array<double, Dim> derivative{};
          for (int c = 0; c < n_corners<Dim>; ++c) {
            position += q.n[c] * m.batch.u[c * Dim + k][lane];
            for (int j = 0; j < Dim; ++j)
              derivative[j] += q.dn[c][j] * m.batch.u[c * Dim + k][lane] * m.batch.inverse_side[lane];
          }
          EXPECT_NEAR(y[k][lane], position, 1e-14);
          for (int j = 0; j < Dim; ++j) {
            EXPECT_NEAR(dphi[k * Dim + j][lane], derivative[j], 1e-13);
            EXPECT_EQ(alone[k * Dim + j][lane], dphi[k * Dim + j][lane]);
          }
        }
    }
}

TYPED_TEST(ElementBatchOf, AddsTheTransposeOfWhatItEvaluates) {
  constexpr int Dim = TypeParam::value;
  Moved<Dim> m;
  Pack expected{}, found{};  // by lane: sum over the points of <evaluate(u), a> and <u, transpose(a)>
  for (const auto& q : ShapeTable<Dim>(2).points) {
    std::array<Pack, Dim> y, by_y;
    std::array<Pack, Dim * Dim> dphi, by_dphi, by_dphi_alone;
    m.batch.evaluate(q, y, dphi.data());
    for (Pack& a : by_y) a = m.any();
    for (Pack& a : by_dphi) a = m.any();
    for (Pack& a : by_dphi_alone) a = m.any();
    m.batch.add_adjoint(q, by_y, by_dphi.data());
    m.batch.add_jacobian_adjoint(q, by_dphi_alone.data());
    for (int k = 0; k < Dim; ++k) expected += y[k] * by_y[k];
    for (int i = 0; i < Dim * Dim; ++i) expected += dphi[i] * (by_dphi[i] + by_dphi_alone[i]);
  }
  for (int i = 0; i < m.batch.n_dofs; ++i) found += m.batch.u[i] * m.batch.gradient[i];
  for (int lane = 0; lane < autodiff::pack_size; ++lane) EXPECT_NEAR(found[lane], expected[lane], 1e-11);
}

}  // namespace
}  // namespace shellmatch
