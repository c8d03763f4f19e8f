#pragma once
/// \file
/// The multilinear finite element on a cube: its nodes, and its shape functions at the points of a quadrature rule.

#include "grid/fields/quadrature.h"
#include "grid/octree/octree.h"

#include <array>
#include <vector>

namespace shellmatch {

/// A leaf of the grid as a finite element. Lengths are in units of the domain's side.
template <int Dim>
struct Element {
  std::array<Index, n_corners<Dim>> nodes;  ///< by corner (docs/conventions.md, numbering)
  double side;
  Vec<Dim> corner = Vec<Dim>::Zero();  ///< position of corner 0
};

/// Multilinear shape functions and their derivatives at the points of a tensor Gauss rule on the unit cell [0,1]^Dim.
template <int Dim>
struct ShapeTable {
  struct Point {
    double weight;                                           ///< of the quadrature rule; the weights sum to 1
    Vec<Dim> xi;                                             ///< on the unit cell
    std::array<double, n_corners<Dim>> n;                    ///< shape functions, by corner
    std::array<std::array<double, Dim>, n_corners<Dim>> dn;  ///< their derivatives by xi
  };
  int points_per_direction;
  std::vector<Point> points;  ///< the index along axis 0 runs fastest

  /// \pre 1 <= points_per_direction <= max_gauss_points
  explicit ShapeTable(int points_per_direction);
};

}  // namespace shellmatch
