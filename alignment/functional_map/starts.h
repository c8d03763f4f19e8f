#pragma once
/// \file
/// First guesses of the functional map on few eigenfunctions.

#include <Eigen/Core>

#include <vector>

namespace shellmatch {

/// Signed permutations of the eigenfunctions 1 to n, which agree between two isometric surfaces up to sign and, where
/// eigenvalues are close, order: all 2^n signs, each in all orders that swap disjoint neighbours of a ratio below
/// `swap_ratio` on either surface. Matrices (n + 1) x (n + 1), whose first row and column belong to the constant. The
/// signs of the identical order come first. \pre both have more than n eigenvalues, and those from the second on are
/// positive
std::vector<Eigen::MatrixXd> start_maps(const Eigen::VectorXd& values_1, const Eigen::VectorXd& values_2, int n,
                                        double swap_ratio);

/// Whether the first three eigenvalues of a surface behind the constant's nearly agree, as those of a sphere or a cube
/// do. Any rotation of space then turns its first eigenfunctions into others as good, and no start of start_maps() is
/// near most of them. \pre more than three eigenvalues, ascending
bool has_no_axes(const Eigen::VectorXd& values);

}  // namespace shellmatch
