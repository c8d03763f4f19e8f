#pragma once
/// \file
/// Products of matrices whose columns are shapes, and eigenvalues of their Gram matrices; compiled once, as Eigen takes
/// seconds of every file that uses them. Products run in parallel, with the same bits for any number of threads.
/// Nothing of the size of the points is copied.

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

/// Columns, each less `centre` where there is one. Refers to both, of whatever memory the columns are.
struct Shapes {
  Eigen::Ref<const Eigen::MatrixXd> columns;
  const Eigen::VectorXd* centre = nullptr;
};

/// Entry (i, j): <a_i, b_j> = sum_p w_p a_i(p) . b_j(p), where point p has rows() / weights.size() consecutive rows.
Eigen::MatrixXd inner_products(const Shapes& a, const Shapes& b, const Eigen::VectorXd& weights);

/// Gram matrix of inner products among the columns; exactly symmetric.
Eigen::MatrixXd gram_matrix(const Shapes& a, const Eigen::VectorXd& weights);

/// The columns of a times a matrix: column k is sum_i coefficients(i, k) a_i, with the same bits whatever columns
/// follow it.
Eigen::MatrixXd combinations(const Shapes& a, const Eigen::MatrixXd& coefficients);

/// a becomes a times a square matrix.
void combine_in_place(Eigen::MatrixXd& a, const Eigen::MatrixXd& coefficients);

/// c = a b, by the calling thread.
void multiply(const Eigen::MatrixXd& a, const Eigen::MatrixXd& b, Eigen::MatrixXd& c);

}  // namespace shellmatch
