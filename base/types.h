#pragma once
/// \file
/// Types of vectors, matrices and indices used everywhere.

#include <Eigen/Core>
#include <cstdint>
#include <limits>

namespace shellmatch {

/// A point or vector of the plane or of space.
template <int Dim>
using Vec = Eigen::Matrix<double, Dim, 1>;

/// A square matrix; Dphi(i, j) is the derivative of component i in direction j.
template <int Dim>
using Mat = Eigen::Matrix<double, Dim, Dim>;

/// Index of a vertex, facet, node or cell within its own array; -1 where there is none.
using Index = std::int32_t;
inline constexpr Index no_index = -1;

inline constexpr double infinity = std::numeric_limits<double>::infinity();

/// Number of corners of a cell: 4 or 8. Bit k of a corner's number is its side along axis k: 0 lower, 1
/// upper.
template <int Dim>
inline constexpr int n_corners = 1 << Dim;

}  // namespace shellmatch

/// Instantiates a function template, whose body is in this source, for the plane and for space.
#define SHELLMATCH_2D_3D(function)            \
  template decltype(function<2>) function<2>; \
  template decltype(function<3>) function<3>
