#include "energies/densities/isotropic_hessian.h"

#include "base/symmetric_eigen.h"

#include <Eigen/Geometry>
#include <Eigen/LU>

#include <algorithm>
#include <array>
#include <cmath>

namespace shellmatch {

template <int Dim>
Stretches<Dim> principal_stretches(const Mat<Dim>& a) {
  // Singular vectors from A^T A; the decomposition need not be accurate where stretches coincide, as any
  // basis serves there.
  Mat<Dim> v = eigenpairs_in_closed_form<Dim>(a.transpose() * a).vectors;
  if (v.determinant() < 0) v.col(0) = -v.col(0);
  Mat<Dim> u;
  Vec<Dim> s;
  for (int i = Dim - 1; i > 0; --i) {  // ascending eigenvalues: the smallest is column 0
    u.col(i) = a * v.col(i);
    for (int j = i + 1; j < Dim; ++j) u.col(i) -= u.col(j).dot(u.col(i)) * u.col(j);
    s[i] = u.col(i).norm();
    u.col(i) = s[i] > 1e-12 ? Vec<Dim>(u.col(i) / s[i]) : Vec<Dim>(Vec<Dim>::Unit(i));
  }
  if constexpr (Dim == 3)
    u.col(0) = u.col(1).cross(u.col(2));
  else
    u.col(0) = Vec<2>(u(1, 1), -u(0, 1));
  s[0] = u.col(0).dot(a * v.col(0));
  return {u, v, s};
}

template <int Dim>
Eigen::Matrix<double, Dim * Dim, Dim * Dim> projected_hessian(
    const Stretches<Dim>& a, const autodiff::SecondOrder<Dim, autodiff::Pack>& psi, int lane) {
  Vec<Dim> first;
  Mat<Dim> second;
  for (int i = 0; i < Dim; ++i) {
    first[i] = psi.g[i][lane];
    for (int j = 0; j < Dim; ++j) second(i, j) = psi.h(i, j)[lane];
  }
  constexpr int n = Dim * Dim;
  Eigen::Matrix<double, n, n> h = Eigen::Matrix<double, n, n>::Zero();
  const auto add = [&](const Mat<Dim>& mode, double value) {
    if (!(value > 0)) return;
    const Mat<Dim> q = a.u * mode * a.v.transpose();
    std::array<double, n> flat, scaled;
    for (int i = 0; i < n; ++i) flat[i] = q(i / Dim, i % Dim), scaled[i] = value * flat[i];
    // Eigen would form the product in a matrix of its own and add that, out of line.
    double* entry = h.data();
    for (int j = 0; j < n; ++j)
      for (int i = 0; i < n; ++i) *entry++ += scaled[i] * flat[j];
  };
  for (int i = 0; i < Dim; ++i)
    for (int j = i + 1; j < Dim; ++j) {
      Mat<Dim> twist = Mat<Dim>::Zero(), flip = Mat<Dim>::Zero();
      twist(i, j) = flip(i, j) = flip(j, i) = std::sqrt(0.5);
      twist(j, i) = -twist(i, j);
      const double sum = a.s[i] + a.s[j], gap = a.s[i] - a.s[j];
      if (std::abs(sum) > 1e-9) add(twist, (first[i] + first[j]) / sum);
      add(flip, std::abs(gap) > 1e-4 ? (first[i] - first[j]) / gap
                                     : 0.5 * (second(i, i) + second(j, j)) - second(i, j));
    }
  const Eigenpairs<Dim> stretch = eigenpairs<Dim>(second);
  for (int m = 0; m < Dim; ++m) add(stretch.vectors.col(m).asDiagonal(), stretch.values[m]);
  return h;
}

#define SHELLMATCH_INSTANTIATE(Dim)                                                   \
  template Stretches<Dim> principal_stretches(const Mat<Dim>&);                       \
  template Eigen::Matrix<double, Dim * Dim, Dim * Dim> projected_hessian(             \
      const Stretches<Dim>&, const autodiff::SecondOrder<Dim, autodiff::Pack>&, int);
SHELLMATCH_INSTANTIATE(2)
SHELLMATCH_INSTANTIATE(3)
#undef SHELLMATCH_INSTANTIATE

}  // namespace shellmatch
