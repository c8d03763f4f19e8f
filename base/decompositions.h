#pragma once
/// \file
/// Decompositions of small matrices, compiled once: Eigen's solvers take seconds of every file that uses them.

#include "base/types.h"

namespace shellmatch {

/// a = u diag(values) v^T with orthogonal u and v. `Matrix` is Mat<3> or Eigen::MatrixXd.
template <class Matrix>
struct Svd {
  Matrix u, v;
  Eigen::Matrix<double, Matrix::RowsAtCompileTime, 1> values;  ///< descending, not negative
};

/// By Jacobi rotations, which suit matrices of at most a few dozen rows. \pre a is finite; SHELLMATCH_CHECK: it is
/// square
template <class Matrix>
Svd<Matrix> jacobi_svd(const Matrix& a);

extern template Svd<Mat<3>> jacobi_svd(const Mat<3>&);
extern template Svd<Eigen::MatrixXd> jacobi_svd(const Eigen::MatrixXd&);

/// U V^T, where U S V^T is the singular value decomposition of `a`: the orthogonal factor of its polar decomposition,
/// by Newton's iteration (N. J. Higham, 'Computing the polar decomposition - with applications', SIAM J. Sci. Stat.
/// Comput. 7, 1986), which takes a tenth of the time of the decomposition. That is taken where `a` is nearly singular.
/// \pre a is square (checked) and finite
Eigen::MatrixXd nearest_orthogonal(const Eigen::MatrixXd& a);

/// Eigenvalues, ascending, and the corresponding eigenvectors as columns.
template <int Dim>
struct Eigenpairs {
  Vec<Dim> values;
  Mat<Dim> vectors;
};

/// Eigendecomposition of a symmetric matrix by the QR iteration. The matrix must be finite (SHELLMATCH_CHECK).
template <int Dim>
Eigenpairs<Dim> eigenpairs(const Mat<Dim>& a);

/// Sets the negative eigenvalues of a symmetric matrix of n rows to 0, in place.
void remove_negative_eigenvalues(int n, double* matrix);

/// Largest eigenvalue of a symmetric matrix of n rows; NaN if an entry is not finite.
double largest_eigenvalue(int n, const double* matrix);

}  // namespace shellmatch
