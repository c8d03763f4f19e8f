// Eigenvalues of eight small symmetric matrices at once, against Eigen's.

#include "energies/densities/pack_eigen.h"

#include <gtest/gtest.h>

#include <limits>
#include <random>

#include "base/decompositions.h"

namespace shellmatch {
namespace {

using autodiff::Pack;
using autodiff::pack_size;

// Random ones beside those that are easy to get wrong: zero, a multiple of the identity, diagonal, of rank one, of
// equal and of very different eigenvalues.
template <int Dim>
Mat<Dim> symmetric_matrix(int kind, std::mt19937& random) {
  std::normal_distribution<double> normal;
  const Mat<Dim> any = Mat<Dim>::NullaryExpr([&] { return normal(random); });
  const Vec<Dim> v = any.col(0);
  switch (kind) {
    case 0: return Mat<Dim>::Zero();
    case 1: return 3 * Mat<Dim>::Identity();
    case 2: return v.asDiagonal();
    case 3: return v * v.transpose();
    case 4: return 2 * Mat<Dim>::Identity() + v * v.transpose();
    case 5: return Mat<Dim>::Identity() + 1e6 * v * v.transpose();
    default: return any + any.transpose();
  }
}

template <int Dim>
void check_pairs() {
  std::mt19937 random(Dim);
  for (int trial = 0; trial < 100; ++trial) {
    SmallMat<Pack, Dim> packed;
    std::array<Mat<Dim>, pack_size> matrices;
    for (int lane = 0; lane < pack_size; ++lane) {
      matrices[lane] = symmetric_matrix<Dim>((trial + lane) % 8, random);
      for (int i = 0; i < Dim; ++i)
        for (int j = i; j < Dim; ++j) packed(i, j)[lane] = matrices[lane](i, j);  // the lower triangle is not read
    }
    const PackEigenpairs<Dim> found = pack_eigenpairs<Dim>(packed);
    for (int lane = 0; lane < pack_size; ++lane) {
      const Mat<Dim>& a = matrices[lane];
      const Vec<Dim> exact = eigenpairs<Dim>(a).values;
      Mat<Dim> q;
      Vec<Dim> values;
      for (int i = 0; i < Dim; ++i) values[i] = found.values[i][lane];
      for (int i = 0; i < Dim * Dim; ++i) q(i / Dim, i % Dim) = found.vectors.v[i][lane];
      EXPECT_LE((values - exact).norm(), 1e-14 * a.norm());
      EXPECT_LE((q.transpose() * q - Mat<Dim>::Identity()).norm(), 1e-14);
      EXPECT_LE((a * q - q * values.asDiagonal()).norm(), 1e-14 * a.norm());
    }
  }
}

TEST(PackEigen, PairsInThePlane) { check_pairs<2>(); }
TEST(PackEigen, PairsInSpace) { check_pairs<3>(); }

TEST(PackEigen, ALaneThatIsNotFiniteSpoilsNoOther) {
  SmallMat<Pack, 3> a;
  for (int i = 0; i < 3; ++i) {
    a(i, i) += 1.0 + i;
    a(0, i)[2] = std::numeric_limits<double>::quiet_NaN();
    a(0, i)[5] = std::numeric_limits<double>::infinity();
  }
  a(0, 1)[0] = 0.5;
  const auto found = pack_eigenpairs<3>(a);
  EXPECT_NEAR(found.values[0][0], 1.5 - std::sqrt(0.5), 1e-14);
  EXPECT_EQ(found.values[2][7], 3.0);
}

}  // namespace
}  // namespace shellmatch
