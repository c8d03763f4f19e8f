#pragma once
/// \file
/// Products of matrices whose columns are shapes. In parallel, with the same bits for any number of threads; compiled
/// once, as Eigen's products take seconds of every file that uses them. Nothing of the size of the points is copied.

#include <Eigen/Core>

namespace shellmatch {

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
