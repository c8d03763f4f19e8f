#pragma once
/// \file
/// Points that correspond across shapes: the same number for each shape, in the same order.

#include "base/types.h"

#include <Eigen/Core>

#include <array>
#include <vector>

namespace shellmatch {

/// n shapes of V points each. A column is a shape: x, y(, z) of point 0, then those of point 1, and so on.
struct PointSets {
  int dimension = 3;            ///< 2 or 3
  Eigen::MatrixXd coordinates;  ///< dimension * V rows, n columns; all finite

  Eigen::Index n_points() const { return coordinates.rows() / dimension; }
  Eigen::Index n_sets() const { return coordinates.cols(); }
};

/// The weight of each point in all inner products of this folder, its share of the surface: with it means and modes
/// depend on the surface and not on how densely it is sampled. Of a point: a third of the areas of its triangles (half
/// of the lengths of its segments), over the whole; V entries, whose sum is 1. Points of no facet weigh nothing. \param
/// points dimension * V coordinates \param facets dimension indices each \throws InputError for facets that name no
/// point, points that are not finite, and where all facets together have no area
template <int Dim>
Eigen::VectorXd area_weights(const Eigen::VectorXd& points, const std::vector<std::array<Index, Dim>>& facets);

/// The same weight for each of V points: for points that lie on no surface.
Eigen::VectorXd uniform_weights(Eigen::Index n_points);

/// \throws InputError unless there are points, all finite, and a weight for each, not negative, with sum 1 to rounding.
/// Messages count shapes and points from 0.
void check_point_sets(const PointSets& sets, const Eigen::VectorXd& weights);

/// By how much coordinates may differ that would be equal without rounding, as after rotations: 64 units in the last
/// place of the greatest. Differences below it are no variation.
double rounding_of(const PointSets& sets);

/// The mean shape, dimension * V; without shapes NaN. Exact where all shapes are equal.
Eigen::VectorXd mean_of(const PointSets& sets);

}  // namespace shellmatch
