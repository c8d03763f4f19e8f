#pragma once
/// \file
/// Families of shapes for the tests, and distances computed point by point.

#include "geometry/statistics/point_sets.h"

#include <array>
#include <cstdint>
#include <vector>

namespace shellmatch::testing {

/// Coordinates of independent normal numbers about `offset`.
PointSets random_sets(int dimension, Eigen::Index n_points, Eigen::Index n_sets, std::uint64_t seed, double offset = 0);

/// Positive, uneven, with sum 1.
Eigen::VectorXd random_weights(Eigen::Index n_points, std::uint64_t seed);

/// Root mean square distance of two shapes.
double distance(const Eigen::VectorXd& a, const Eigen::VectorXd& b, const Eigen::VectorXd& weights);

/// Scores of n shapes: columns of mean 0, with exactly these variances and exactly uncorrelated. \pre at most (n - 1) /
/// 2 variances
Eigen::MatrixXd prescribed_scores(Eigen::Index n, const std::vector<double>& variances);

/// n_points points of the corners of a box and copies of it, symmetric about all coordinate planes, with sides 6, 4 and
/// 2: `mean`; stretches along the axes as modes, orthonormal in the inner product of equal weights.
struct BoxFamily {
  int dimension;
  Eigen::VectorXd mean, weights;
  Eigen::MatrixXd modes;
  PointSets shapes(const Eigen::MatrixXd& scores) const;
};
BoxFamily box_family(int dimension, int n_shells);

/// A sphere of radius 1 of rings of points about the z-axis. With `crowding` 1 rings are as far from each other
/// everywhere; with more they crowd at one pole.
struct Sphere {
  Eigen::VectorXd points;
  std::vector<std::array<Index, 3>> triangles;
};
Sphere sphere(int n_rings, double crowding);

}  // namespace shellmatch::testing
