#pragma once
/// \file
/// Point distribution models (Cootes, Taylor, Cooper and Graham 1995): a mean shape and its principal modes of
/// variation.

#include "geometry/statistics/point_sets.h"

#include <cstdint>

namespace shellmatch {

/// x = mean + sum_k b_k mode_k, where b_k has variance variances[k]. With the inner product <u, v> = sum_p w_p u_p .
/// v_p the modes are orthonormal; a score is thus a root mean square displacement of points, in the unit of the shapes.
/// Signs: positive scores make the mean larger; of a mode that leaves its size alone to a hundredth, the first entry of
/// greatest magnitude (to a hundredth) is positive.
struct ShapeModel {
  int dimension = 3;
  Eigen::VectorXd weights;    ///< V, sum 1
  Eigen::VectorXd mean;       ///< dimension * V
  Eigen::MatrixXd modes;      ///< dimension * V rows, K columns, variances descending
  Eigen::VectorXd variances;  ///< K, of scores, with n - 1 in the denominator; > 0
  Eigen::MatrixXd scores;     ///< n rows, K columns, of the shapes that made the model
  double total_variance = 0;  ///< also of modes that were left out; 0 where the shapes are equal to rounding

  /// Scores of shapes (one for each column), which must be aligned to the mean: n rows, K columns.
  /// \throws InputError for other sizes
  Eigen::MatrixXd transform(const Eigen::MatrixXd& shapes) const;
  /// Shapes of scores, one for each row, at most K columns: the columns of the result. Scores that are absent are 0.
  /// \throws InputError for more
  Eigen::MatrixXd inverse_transform(const Eigen::MatrixXd& scores) const;
  /// Scores of `n` shapes drawn from the normal distribution of the model, n rows: the first n of the sequence that the
  /// seed stands for, on any machine the same to rounding.
  Eigen::MatrixXd sample_scores(int n, std::uint64_t seed) const;
};

/// Normal numbers with these variances: n rows, one column for each variance. Row by row, so that more rows begin with
/// the same ones.
Eigen::MatrixXd normal_scores(const Eigen::VectorXd& variances, int n, std::uint64_t seed);

/// From the n x n Gram matrix of the shapes about their mean: V n^2 operations, and 9 n^3 for its eigenvectors. Memory
/// beyond the points: that of the modes and of three n x n matrices. Equal shapes have no modes. \param aligned as
/// procrustes() returns them, at least 2 sets \param max_modes 0: all, at most n - 1; those whose variance is rounding
/// (1e-12 of the greatest) are never there \throws InputError for fewer than two sets, a negative max_modes, and as
/// check_point_sets()
ShapeModel fit_shape_model(const PointSets& aligned, const Eigen::VectorXd& weights, int max_modes = 0);

}  // namespace shellmatch
