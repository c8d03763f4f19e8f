#pragma once
/// \file
/// The curvature classification C, which makes shape operators positive definite, and its matrix roots
/// (paper, section 3, bending energy).

#include "base/types.h"
#include "grid/options.h"

namespace shellmatch {

/// C as a function of eigenvalues. A curvature k is first limited to |k| <= cap; then
/// absolute: C(k) = max(|k|, tau), shift: C(k) = k + shift.
struct Classifier {
  Classification kind = Classification::absolute;
  double tau = 1;    ///< 1/length, positive
  double cap = 0;    ///< 1/length; 0: none
  double shift = 0;  ///< 1/length; -shift lies below every curvature of both surfaces
  RootMethod root = RootMethod::eigen;

  double operator()(double curvature) const;
};

/// S^ext = P S P + n n^T with P = I - n n^T. n is a unit vector, or zero where the normal is undefined; then
/// S^ext = S.
template <int Dim>
Mat<Dim> extended_shape_operator(const Mat<Dim>& hessian, const Vec<Dim>& normal);

/// C(S)^exponent, where the exponent is 1, 1/2 or -1/2. Computed by a symmetric eigendecomposition, or, for
/// the roots and where classifier.root selects it, by Franca's formula (grid/fits/matrix_root.h).
template <int Dim>
Mat<Dim> classified_power(const Mat<Dim>& extended_shape, const Classifier& classifier, double exponent);

/// The same for an extended shape operator, which has the unit vector `normal` as eigenvector with eigenvalue 1, from
/// its tangential part, by the eigendecomposition whatever classifier.root: a fraction of the time.
template <int Dim>
Mat<Dim> classified_power(const Mat<Dim>& extended_shape, const Vec<Dim>& normal, const Classifier& classifier,
                          double exponent);

}  // namespace shellmatch
