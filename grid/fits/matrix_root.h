#pragma once
/// \file
/// Roots of symmetric positive definite matrices of two and three dimensions.

#include "base/types.h"

namespace shellmatch {

/// The symmetric positive definite U with U U = A, without eigenvectors: L. P. Franca, 'An algorithm to
/// compute the square root of a 3x3 positive definite matrix', Computers & Mathematics with Applications
/// 18(5), 1989; in the plane U = (A + sqrt(det A) I)/sqrt(tr A + 2 sqrt(det A)). By the theorem of Cayley and
/// Hamilton, U is a polynomial in A whose coefficients depend on the invariants of U, which follow in closed
/// form from the largest eigenvalue of A. That is computed from the deviator of A, which avoids cancellation
/// where eigenvalues nearly agree. The relative error is the rounding unit over the determinant of A/(tr
/// A/Dim). Where this determinant is below 1e-6, A is nearly singular and the root is computed by the
/// eigendecomposition. A must be positive definite (SHELLMATCH_CHECK).
template <int Dim>
Mat<Dim> franca_root(const Mat<Dim>& a);

/// The inverse of franca_root(a), from the same invariants.
template <int Dim>
Mat<Dim> franca_inverse_root(const Mat<Dim>& a);

}  // namespace shellmatch
