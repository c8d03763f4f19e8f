// The model of the second derivative: exact where nothing has to be removed, positive semidefinite
// everywhere.

#include "energies/hessian/energy_hessian.h"
#include "energies/densities/stretch_hessian.h"
#include "energies/densities/tangent_hessian.h"
#include "energies/terms/term_names.h"
#include "tests/energies/exact_shapes.h"
#include "tests/energies/matching_problem.h"

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>

#include <random>

namespace shellmatch {
namespace {

using namespace test;

/// Exact second derivative of a volume density by the entries of A.
template <class VolumeTerm, int Dim>
Eigen::Matrix<double, Dim * Dim, Dim * Dim> exact_hessian(const Mat<Dim>& a, const Lame<double>& lame) {
  using Scalar = autodiff::SecondOrder<Dim * Dim>;
  SmallMat<Scalar, Dim> m;
  for (int i = 0; i < Dim; ++i)
    for (int j = 0; j < Dim; ++j) m(i, j) = Scalar::variable(a(i, j), i * Dim + j);
  const Scalar psi = VolumeTerm::template density<Scalar, double>(m, lame);
  return Eigen::Matrix<double, Dim * Dim, Dim * Dim>::NullaryExpr(
      [&](Eigen::Index i, Eigen::Index j) { return psi.h(static_cast<int>(i), static_cast<int>(j)); });
}

template <int Dim>
Mat<Dim> random_matrix(std::mt19937& random, double amplitude) {
  std::uniform_real_distribution<double> u(-amplitude, amplitude);
  return Mat<Dim>::NullaryExpr([&] { return u(random); });
}

/// h without its negative modes.
template <class Matrix>
Matrix positive_part(const Matrix& h) {
  const Eigen::SelfAdjointEigenSolver<Matrix> eigen(h);
  return eigen.eigenvectors() * eigen.eigenvalues().cwiseMax(0.0).asDiagonal() *
         eigen.eigenvectors().transpose();
}

template <class VolumeTerm, int Dim>
void check_stretch_hessian(double amplitude) {
  std::mt19937 random(Dim);
  for (int trial = 0; trial < 50; ++trial) {
    // The stretches of the first are equal, where a quotient of differences becomes a derivative.
    const Mat<Dim> change = trial == 0 ? Mat<Dim>(0.1 * Mat<Dim>::Identity()) : random_matrix<Dim>(random, amplitude);
    const Mat<Dim> a = Mat<Dim>::Identity() + change;
    const Lame<double> lame{0.7, 1.3};
    const auto exact = positive_part(exact_hessian<VolumeTerm, Dim>(a, lame));
    const auto stretches = principal_stretches<Dim>(a);
    std::array<Pack, Dim> s;  // another matrix's in the other lanes
    for (int k = 0; k < Dim; ++k) s[k] = Pack{} + 1.0 + 0.1 * k;
    for (int k = 0; k < Dim; ++k) s[k][trial % 8] = stretches.s[k];
    const auto psi = density_of_stretches<VolumeTerm, Dim>(s, lame);
    const auto model = projected_hessian<Dim>(stretches, psi, trial % 8);
    EXPECT_LT((model - exact).norm(), 1e-6 * exact.norm());
  }
}

TEST(StretchHessian, IsThePositivePartOfTheSecondDerivative) {
  check_stretch_hessian<SimplifiedVolume<2>, 2>(0.4);
  check_stretch_hessian<SimplifiedVolume<3>, 3>(0.3);
  check_stretch_hessian<SymmetricDirichletVolume<2>, 2>(0.3);
  check_stretch_hessian<SymmetricDirichletVolume<3>, 3>(0.2);
  check_stretch_hessian<FullVolume<2>, 2>(0.2);
  check_stretch_hessian<FullVolume<3>, 3>(0.1);
}

TEST(TangentHessian, IsThePositivePartOfTheSecondDerivativeInTheTangentPlane) {
  std::mt19937 random(7);
  const Lame<double> lame{0.7, 1.3};
  for (int trial = 0; trial < 100; ++trial) {
    // Far from the identity as well: the band's matrices may turn over.
    const Mat<2> y =
        random_matrix<2>(random, trial < 50 ? 0.3 : 2.0) + (trial < 50 ? 1.0 : 0.0) * Mat<2>::Identity();
    // W of Y beside a 1 differs from the plane's W by a constant: the second derivatives are the same.
    const auto exact = positive_part(exact_hessian<SimplifiedVolume<2>, 2>(y, lame));
    std::array<Pack, 4> entries;
    for (int i = 0; i < 4; ++i) entries[i] = Pack{} + y(i / 2, i % 2);
    const auto model = tangent_hessian<3>(entries, lame);
    for (int i = 0; i < 4; ++i)
      for (int j = 0; j < 4; ++j) EXPECT_NEAR(model[i][j][trial % 8], exact(i, j), 1e-9 * (1 + exact.norm()));
  }
}

// Semidefinite matrices of every rank, with the rounding of those who made them.
TEST(TangentHessian, FactorOfASemidefiniteMatrix) {
  std::mt19937 random(11);
  std::uniform_real_distribution<double> u(-1, 1);
  using Square = Eigen::Matrix<double, 7, 7>;
  for (int trial = 0; trial < 200; ++trial) {
    const Eigen::MatrixXd j = Eigen::MatrixXd::NullaryExpr(7, 1 + trial % 7, [&] { return u(random); });
    const Square noise = Square::NullaryExpr([&] { return 1e-10 * u(random); });
    const Square h = j * j.transpose() + noise + noise.transpose();
    std::array<std::array<Pack, 7>, 7> packed;
    for (int i = 0; i < 7; ++i)
      for (int k = 0; k < 7; ++k) packed[i][k] = Pack{} + h(i, k);
    const auto l = cholesky<7>(packed);
    Square factor;
    for (int i = 0; i < 7; ++i)
      for (int k = 0; k < 7; ++k) factor(i, k) = l[i][k][trial % 8];
    EXPECT_LT((factor * factor.transpose() - h).norm(), 2e-4 * h.norm()) << trial;
  }
}

template <int Dim>
void check_tangent_basis() {
  std::mt19937 random(3);
  for (int trial = 0; trial < 50; ++trial) {
    Vec<Dim> n = random_matrix<Dim>(random, 1).col(0).normalized();
    if (trial == 0) n = -Vec<Dim>::Unit(Dim - 1);
    std::array<Pack, Dim> packed;
    for (int k = 0; k < Dim; ++k) packed[k] = Pack{} + n[k];
    const auto t = tangent_basis<Dim>(packed);
    Mat<Dim> frame;
    for (int i = 0; i < Dim - 1; ++i)
      for (int k = 0; k < Dim; ++k) frame(k, i) = t[i][k][0];
    frame.col(Dim - 1) = n;
    EXPECT_LT((frame.transpose() * frame - Mat<Dim>::Identity()).norm(), 1e-12);
    EXPECT_NEAR(frame.determinant(), 1.0, 1e-12);
  }
}
TEST(TangentBasis, IsOrthonormalAndRightHanded) {
  check_tangent_basis<2>();
  check_tangent_basis<3>();
}

template <int Dim>
void check_energy_hessian() {
  const Octree<Dim> grid = hanging_grid<Dim>(0.28);
  const Problem<Dim> p(grid, exact_fields<Dim>(grid, sphere<Dim>(0.28)),
                       exact_fields<Dim>(grid, sphere<Dim>(0.28)));
  const auto phi = deformed<Dim>(grid, 0.01, 3);
  EnergyHessian<Dim> hessian(p.energy, p.unknowns, p.target, {});
  TermValues weights;
  for (double& w : weights.v) w = 1;
  hessian.assemble(phi, weights);
  std::mt19937 random(1);
  std::normal_distribution<double> normal;
  const std::size_t n = p.unknowns.size();
  std::vector<double> x(n), y(n), hx(n), hy(n), z(n);
  for (int trial = 0; trial < 5; ++trial) {
    for (std::size_t i = 0; i < n; ++i) {
      x[i] = normal(random);
      y[i] = normal(random);
    }
    hessian.apply(x, hx);
    hessian.apply(y, hy);
    double xhy = 0, yhx = 0, xhx = 0;
    for (std::size_t i = 0; i < n; ++i) {
      xhy += x[i] * hy[i];
      yhx += y[i] * hx[i];
      xhx += x[i] * hx[i];
    }
    EXPECT_NEAR(xhy, yhx, 1e-6 * xhx);
    EXPECT_GT(xhx, 0);
    hessian.precondition(x, z);
    double xz = 0;
    for (std::size_t i = 0; i < n; ++i) xz += x[i] * z[i];
    EXPECT_GT(xz, 0);
  }
}
TEST(EnergyHessian, IsSymmetricAndPositiveInThePlane) { check_energy_hessian<2>(); }
TEST(EnergyHessian, IsSymmetricAndPositiveInSpace) { check_energy_hessian<3>(); }

// A uniform stretch, for which the energy is known.
TEST(EnergyHessian, VolumePartIsTheSecondDerivative) {
  const Octree<3> grid(2);
  const Problem<3> p(grid, exact_fields<3>(grid, sphere<3>(0.28)), exact_fields<3>(grid, sphere<3>(0.28)));
  const auto phi = at_nodes<3>(grid, [](const Vec<3>& x) { return x; });
  EnergyOptions options;
  options.terms.model("volume"_term) = "simplified";
  EnergyHessian<3> hessian(p.energy, p.unknowns, p.target, options);
  const TermValues weights = only("volume"_term);
  hessian.assemble(phi, weights);
  // u = t (x, 0, 0): W(I + t e1 e1^T) = t^2 (mu + lambda/2), so u.H u = 2 (mu + lambda/2) = 3 on the unit
  // cube.
  std::vector<double> u(p.unknowns.size(), 0.0), hu(u.size());
  for (std::size_t i = 0; i < p.unknowns.nodes().size(); ++i)
    u[3 * i] = grid.node_position(p.unknowns.nodes()[i])[0];
  hessian.apply(u, hu);
  double uhu = 0;
  for (std::size_t i = 0; i < u.size(); ++i) uhu += u[i] * hu[i];
  EXPECT_NEAR(uhu, 3, 1e-5);
}

}  // namespace
}  // namespace shellmatch
