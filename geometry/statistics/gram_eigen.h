#pragma once
/// \file
/// Eigendecompositions of symmetric positive semidefinite matrices of any size, compiled once.

#include <Eigen/Core>

namespace shellmatch {

/// Eigenvalues of this share of the greatest, or less, are rounding.
inline constexpr double least_variance_share = 1e-12;

/// Eigenvalues, descending, and the corresponding orthonormal eigenvectors as columns.
struct GramEigen {
  Eigen::VectorXd values;
  Eigen::MatrixXd vectors;
};

/// By Householder's tridiagonal form and the QR iteration, 9 n^3 floating point operations: a minute for n = 2000.
/// \param least eigenvalues at or below it are left out, and so are those that are rounding
/// \pre gram is symmetric and finite
GramEigen gram_eigen(const Eigen::MatrixXd& gram, double least);

/// The inverse transpose of the Cholesky factor: with it, columns of which `gram` is the Gram matrix become
/// orthonormal, and the first k of them span what they have spanned before. SHELLMATCH_CHECK: gram is positive definite
Eigen::MatrixXd orthonormalising_combinations(const Eigen::MatrixXd& gram);

}  // namespace shellmatch
