#pragma once
/// \file
/// Random matrices of a kind, and the way from Eigen's matrices to those of the energies.

#include "base/types.h"
#include "energies/small_matrix.h"

#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <Eigen/QR>

#include <random>

namespace shellmatch::test {

/// Entries uniform in [-1, 1].
template <int Rows, int Columns = Rows>
Eigen::Matrix<double, Rows, Columns> random_matrix(std::mt19937& random) {
  std::uniform_real_distribution<double> uniform(-1, 1);
  Eigen::Matrix<double, Rows, Columns> a;
  for (int i = 0; i < Rows; ++i)
    for (int j = 0; j < Columns; ++j) a(i, j) = uniform(random);
  return a;
}

/// An orthogonal matrix of determinant 1. Its columns serve as an orthonormal basis, too.
template <int Dim>
Mat<Dim> random_rotation(std::mt19937& random) {
  if constexpr (Dim == 1) {
    return Mat<1>::Ones();
  } else {
    Mat<Dim> q = Eigen::HouseholderQR<Mat<Dim>>(random_matrix<Dim>(random)).householderQ();
    if (q.determinant() < 0) q.col(0) = -q.col(0);
    return q;
  }
}

/// Symmetric with eigenvalues in [low, high].
template <int Dim>
Mat<Dim> random_symmetric(std::mt19937& random, double low, double high) {
  std::uniform_real_distribution<double> uniform(low, high);
  const Mat<Dim> q = random_rotation<Dim>(random);
  Vec<Dim> l;
  for (int i = 0; i < Dim; ++i) l[i] = uniform(random);
  return q * l.asDiagonal() * q.transpose();
}

/// Singular values in [low, high], determinant positive.
template <int Dim>
Mat<Dim> random_orientation_preserving(std::mt19937& random, double low, double high) {
  return random_rotation<Dim>(random) * random_symmetric<Dim>(random, low, high);
}

/// S^exponent of a symmetric positive definite S.
template <int Dim>
Mat<Dim> power(const Mat<Dim>& s, double exponent) {
  const Eigen::SelfAdjointEigenSolver<Mat<Dim>> e(s);
  const Vec<Dim> l = e.eigenvalues().array().pow(exponent);
  return e.eigenvectors() * l.asDiagonal() * e.eigenvectors().transpose();
}

template <class T = double, int Dim>
SmallMat<T, Dim> small(const Eigen::Matrix<double, Dim, Dim>& a) {
  SmallMat<T, Dim> s;
  for (int i = 0; i < Dim; ++i)
    for (int j = 0; j < Dim; ++j) s(i, j) = T(a(i, j));
  return s;
}

template <int Dim>
SmallVec<double, Dim> small(const Eigen::Matrix<double, Dim, 1>& a) {
  SmallVec<double, Dim> s;
  for (int i = 0; i < Dim; ++i) s[i] = a[i];
  return s;
}

template <int Dim>
SmallSym<double, Dim> small_symmetric(const Mat<Dim>& a) {
  SmallSym<double, Dim> s;
  for (int i = 0; i < Dim; ++i)
    for (int j = i; j < Dim; ++j) s.v[s.slot(i, j)] = 0.5 * (a(i, j) + a(j, i));
  return s;
}

}  // namespace shellmatch::test
