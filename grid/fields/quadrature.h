#pragma once
/// \file
/// Tensor Gauss rules on the reference cell [0, 1]^Dim.

#include "base/types.h"

#include <vector>

namespace shellmatch {

template <int Dim>
struct QuadraturePoint {
  Vec<Dim> point;  ///< in (0, 1)^Dim
  double weight;   ///< positive; the weights of a rule sum to 1; multiply by side^Dim on a cell
};

inline constexpr int max_gauss_points = 5;

/// The rule with `n` Gauss-Legendre points per direction, exact for polynomials of degree 2n - 1 in each
/// variable. The first coordinate runs fastest. \pre 1 <= n <= max_gauss_points
template <int Dim>
std::vector<QuadraturePoint<Dim>> gauss_rule(int n);

}  // namespace shellmatch
