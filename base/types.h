#pragma once
/// \file
/// Vectors, matrices and indices that every folder shares.

#include <Eigen/Core>
#include <cstdint>

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

/// Corners of a cell: 4 or 8. Bit k of a corner's number says on which side of the cell it lies along axis k.
template <int Dim>
inline constexpr int n_corners = 1 << Dim;

}  // namespace shellmatch
