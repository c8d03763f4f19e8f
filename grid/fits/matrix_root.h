#pragma once
/// \file
/// Roots of symmetric positive definite matrices of two and three dimensions.

#include "base/types.h"

namespace shellmatch {

/// Eigenvalues, ascending, and the eigenvectors in their order as columns.
template <int Dim>
struct Eigenpairs {
  Vec<Dim> values;
  Mat<Dim> vectors;
};

/// Of a symmetric matrix; a matrix that is not finite stops the program.
template <int Dim>
Eigenpairs<Dim> eigenpairs(const Mat<Dim>& a);

/// The symmetric positive definite U with U U = A, without eigenvectors: L. P. Franca, 'An algorithm to compute
/// the square root of a 3x3 positive definite matrix', Computers & Mathematics with Applications 18(5), 1989; in
/// the plane U = (A + sqrt(det A) I)/sqrt(tr A + 2 sqrt(det A)). By the theorem of Cayley and Hamilton U is a
/// polynomial in A whose coefficients depend on the invariants of U, and these come from the largest eigenvalue in
/// closed form, which is taken from the deviator of A here, so that no digits are lost where eigenvalues nearly agree.
/// Relative error: rounding over the determinant of A/(tr A/Dim). Where that is below 1e-6, A is nearly singular and
/// the invariants are of little use: there the root comes from the eigendecomposition.
/// A that is not positive definite stops the program.
template <int Dim>
Mat<Dim> franca_root(const Mat<Dim>& a);

/// The inverse of franca_root(a), from the same invariants.
template <int Dim>
Mat<Dim> franca_inverse_root(const Mat<Dim>& a);

}  // namespace shellmatch
