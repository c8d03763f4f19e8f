#pragma once
/// \file
/// Dense linear least squares, compiled by itself: the decomposition takes as long to compile as the jets that call it.

#include <Eigen/Core>

namespace shellmatch {

/// Replaces b, of m.rows() entries, by the x of m.cols() entries that minimises |m x - b|, the shortest where there are
/// several, and returns the ratio of the largest to the smallest singular value of m (infinite or NaN where m does not
/// have full rank). Singular value decomposition by Jacobi rotations.
double solve_least_squares(const Eigen::MatrixXd& m, Eigen::VectorXd& b);

}  // namespace shellmatch
