#pragma once
/// \file
/// Dense linear least squares, compiled by itself: the decomposition takes as long to compile as the jets that call it.

#include <Eigen/Core>

namespace shellmatch {

/// Replaces b, of m.rows() entries, by the x of m.cols() entries that minimises |m x - b|, the shortest where there are
/// several, and returns an estimate of the condition number of m (infinite or NaN where m does not have full rank). By
/// Householder reflections: a singular value decomposition takes ten times as long.
double solve_least_squares(const Eigen::MatrixXd& m, Eigen::VectorXd& b);

}  // namespace shellmatch
