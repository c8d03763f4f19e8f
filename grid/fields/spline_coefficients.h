#pragma once
/// \file
/// The coefficients of splines from values at the nodes: SplineSpace::coefficients().

#include "base/error.h"
#include "base/parallel.h"
#include "grid/fields/spline_space.h"

#include <algorithm>
#include <type_traits>
#include <utility>

namespace shellmatch {

/// The numbers that a store of coefficients keeps.
template <class At>
using Kept = std::remove_reference_t<std::invoke_result_t<const At&, Index, std::size_t>>;

template <int Dim>
template <std::size_t begin, std::size_t n, class Nodal>
std::array<double, n> SplineSpace<Dim>::mean(Index cell, const Nodal& nodal) const {
  std::array<double, n> sum{};
  for (const Index node : grid_->cell(cell).nodes)
    for (std::size_t i = 0; i < n; ++i) sum[i] += 1.0 / n_corners<Dim> * nodal(node, begin + i);
  return sum;
}

template <int Dim>
template <std::size_t begin, std::size_t n, class Nodal, class At>
void SplineSpace<Dim>::quasi_interpolate(const Nodal& nodal, const At& at) const {
  std::vector<std::array<double, n>> means(static_cast<std::size_t>(grid_->n_cells()));
  parallel_for(means.size(), [&](std::size_t cell) { means[cell] = mean<begin, n>(static_cast<Index>(cell), nodal); });
  parallel_for(means.size(), [&](std::size_t cell) {
    const Index c = number_of(static_cast<Index>(cell));
    if (made_[c] != Made::sampled) return;
    std::array<double, n> row = means[cell];
    for (int k = 0, stride = 1; k < Dim; ++k, stride *= 3) {
      const Index below = neighbour(c, n_local / 2 - stride), above = neighbour(c, n_local / 2 + stride);
      if (!is_of_cell(below) || !is_of_cell(above)) continue;  // the mean alone, exact for linear functions
      for (std::size_t i = 0; i < n; ++i) {
        row[i] += 0.5 * means[cell][i];
        row[i] += -0.25 * means[cell_of(below)][i];
        row[i] += -0.25 * means[cell_of(above)][i];
      }
    }
    for (std::size_t i = 0; i < n; ++i) at(c, begin + i) = static_cast<Kept<At>>(row[i]);
  });
}

template <int Dim>
template <std::size_t n, std::size_t n_quasi_interpolated, class Nodal, class At>
void SplineSpace<Dim>::coefficients(const Nodal& nodal, const At& at) const {
  SHELLMATCH_CHECK(grid_ != nullptr, "the grid of the splines is forgotten");
  // Four components at a time limit the memory of the means of all cells.
  [&]<std::size_t... part>(std::index_sequence<part...>) {
    (quasi_interpolate<4 * part, std::min<std::size_t>(4, n_quasi_interpolated - 4 * part)>(nodal, at), ...);
  }
  (std::make_index_sequence<(n_quasi_interpolated + 3) / 4>());
  if constexpr (n > n_quasi_interpolated)
    parallel_for(static_cast<std::size_t>(grid_->n_cells()), [&](std::size_t cell) {
      const Index c = number_of(static_cast<Index>(cell));
      if (made_[c] != Made::sampled) return;
      const auto row = mean<n_quasi_interpolated, n - n_quasi_interpolated>(static_cast<Index>(cell), nodal);
      for (std::size_t i = 0; i < row.size(); ++i) at(c, n_quasi_interpolated + i) = static_cast<Kept<At>>(row[i]);
    });
  for (const Derived& d : derived_) {
    if (d.outside) {
      for (std::size_t i = 0; i < n; ++i) {
        const double first = at(d.source[0], i), second = at(d.source[1], i);
        at(d.coefficient, i) = static_cast<Kept<At>>(i < n_quasi_interpolated ? first + first - second : first);
      }
      continue;
    }
    std::array<double, n> sum{};
    for (int c = 0; c < n_corners<Dim>; ++c) {
      double weight = 1;
      for (int k = 0; k < Dim; ++k) weight *= (c >> k) & 1 ? 0.25 : 0.75;
      for (std::size_t i = 0; i < n; ++i) sum[i] += weight * static_cast<double>(at(d.source[c], i));
    }
    for (std::size_t i = 0; i < n; ++i) at(d.coefficient, i) = static_cast<Kept<At>>(sum[i]);
  }
}

}  // namespace shellmatch
