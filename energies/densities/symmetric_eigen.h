#pragma once
/// \file
/// Eigenvalues of small symmetric matrices of any size, compiled once.

namespace shellmatch {

/// Sets the negative eigenvalues of a symmetric matrix of n rows to 0, in place.
void remove_negative_eigenvalues(int n, double* matrix);

/// Largest eigenvalue of a symmetric matrix of n rows; NaN if an entry is not finite.
double largest_eigenvalue(int n, const double* matrix);

}  // namespace shellmatch
