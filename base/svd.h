#pragma once
/// \file
/// Singular value decomposition of square matrices, compiled once: Eigen's takes seconds of every file that uses it.

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

}  // namespace shellmatch
