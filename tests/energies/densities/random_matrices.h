#pragma once
/// \file
/// Random matrices of a kind, and the way from Eigen's matrices to those of the energies.

#include "base/types.h"
#include "energies/densities/small_matrix.h"

#include <Eigen/LU>

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

// For Dim 1 (tangent spaces in the plane), 2 and 3.

/// An orthogonal matrix of determinant 1. Its columns serve as an orthonormal basis, too.
template <int Dim>
Mat<Dim> random_rotation(std::mt19937& random);

/// Symmetric with eigenvalues in [low, high].
template <int Dim>
Mat<Dim> random_symmetric(std::mt19937& random, double low, double high);

/// Singular values in [low, high], determinant positive.
template <int Dim>
Mat<Dim> random_orientation_preserving(std::mt19937& random, double low, double high);

/// S^exponent of a symmetric positive definite S.
template <int Dim>
Mat<Dim> power(const Mat<Dim>& s, double exponent);

// By Eigen, compiled once.

/// A symmetric matrix without its negative modes.
Eigen::MatrixXd positive_part(const Eigen::MatrixXd& symmetric);

double least_eigenvalue(const Eigen::MatrixXd& symmetric);

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
