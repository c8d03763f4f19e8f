#pragma once
/// \file
/// First guesses of the map between two surfaces: of the functional map on few eigenfunctions, and from the ends of
/// limbs.

#include <Eigen/Core>

#include "alignment/functional_map/two_way_map.h"

#include <vector>

namespace shellmatch {

/// Tips of surface 1 with those of surface 2, as indices in SpectralShape::tips.
struct TipAssignment {
  std::vector<std::pair<int, int>> pairs;
  double cost = 0;  ///< 0 where all correspond and have the same distances from one another
};

/// The n assignments of least cost of three tips or more, ascending. What is compared are the distances between tips,
/// in ratios, so that limbs may have other lengths, and what tips are left out. A mirrored assignment costs the same.
std::vector<TipAssignment> assign_tips(const std::vector<SurfaceTip>& tips_1, const std::vector<SurfaceTip>& tips_2,
                                       std::size_t n);

/// Features of all vertices of surface s: their distances from assigned tips, each over the sum of those of the tips.
Features tip_features(const SpectralShape& shape, const TipAssignment& assignment, int s);

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
