#pragma once
/// \file
/// First guesses of the functional map on few eigenfunctions.

#include <Eigen/Core>

#include <vector>

namespace shellmatch {

/// Signed permutations of the eigenfunctions 1 to n, which agree between two isometric surfaces up to sign and, where
/// eigenvalues are close, order: all 2^n signs, each in all orders that swap disjoint neighbours of a ratio below
/// `swap_ratio` on either surface. Matrices (n + 1) x (n + 1), whose first row and column belong to the constant. The
/// signs of the identical order come first. \pre both have more than n eigenvalues, and those from the second on are positive
std::vector<Eigen::MatrixXd> start_maps(const Eigen::VectorXd& values_1, const Eigen::VectorXd& values_2, int n,
                                        double swap_ratio);

}  // namespace shellmatch
