#pragma once
/// \file
/// Eigenvalues of small symmetric matrices, compiled once: Eigen's solvers take seconds of every file that uses them.

#include "base/types.h"

namespace shellmatch {

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
