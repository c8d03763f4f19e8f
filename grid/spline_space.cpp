#include "grid/spline_space.h"

#include <algorithm>

namespace shellmatch {

namespace {

// Step to neighbour `number` of the 3^Dim around a cell, -1, 0 or 1 along each axis.
template <int Dim>
std::array<int, Dim> step_to(int number) {
  std::array<int, Dim> step;
  for (int k = 0; k < Dim; ++k, number /= 3) step[k] = number % 3 - 1;
  return step;
}

// One number for each place of each level, those next to the domain included.
template <int Dim>
std::uint64_t key_of(int level, const std::array<std::int32_t, Dim>& corner) {
  std::uint64_t first = 0, within = 0;
  for (int l = 0; l < level; ++l) {
    std::uint64_t places = 1;
    for (int k = 0; k < Dim; ++k) places *= (std::uint64_t{1} << l) + 2;
    first += places;
  }
  for (int k = 0; k < Dim; ++k)
    within = within * ((std::uint64_t{1} << level) + 2) + static_cast<std::uint64_t>(corner[k] + 1);
  return first + within;
}

}  // namespace

template <int Dim>
SplineSpace<Dim>::SplineSpace(const Octree<Dim>& grid)
    : grid_(&grid),
      n_coefficients_(grid.n_cells()),
      leaves_(static_cast<std::size_t>(grid.n_cells())),
      made_(static_cast<std::size_t>(grid.n_cells()), 0) {
  const auto leaves = grid.leaves();
  parallel_for(
      leaves.size(),
      [&](std::size_t i) {
        const auto& cell = grid.cell(leaves[i]);
        leaves_[leaves[i]] = {find_neighbours(cell.level, cell.corner), cell.corner, cell.level};
      },
      256);
  for (const Index cell : leaves) {
    Leaf& leaf = leaves_[cell];
    if (!made_[cell]) make_cell(cell, leaf.coefficients);
    for (int n = 0; n < n_local; ++n) {
      Index& c = leaf.coefficients[n];
      if (c != no_index && made_[c]) continue;
      Coord neighbour;
      const auto step = step_to<Dim>(n);
      for (int k = 0; k < Dim; ++k) neighbour[k] = leaf.corner[k] + step[k];
      c = coefficient_at(leaf.level, neighbour);
    }
  }
  made_ = {};
  others_ = {};
}

template <int Dim>
typename SplineSpace<Dim>::Local SplineSpace<Dim>::find_neighbours(int level, const Coord& corner) const {
  Local found;
  for (int n = 0; n < n_local; ++n) {
    Coord neighbour;
    const auto step = step_to<Dim>(n);
    for (int k = 0; k < Dim; ++k) neighbour[k] = corner[k] + step[k];
    found[n] = grid_->find_cell(level, neighbour);
  }
  return found;
}

template <int Dim>
Index SplineSpace<Dim>::coefficient_at(int level, const Coord& corner) {
  if (const Index cell = grid_->find_cell(level, corner); cell != no_index) {
    if (!made_[cell]) make_cell(cell, find_neighbours(level, corner));
    return cell;
  }
  const auto key = key_of<Dim>(level, corner);
  if (const Index known = others_.find(key); known != no_index) return known;
  const Index coefficient = n_coefficients_++;
  others_.insert(key, coefficient);
  derive(coefficient, level, corner);
  return coefficient;
}

// The cell's own coefficient: sampled where the spline of its level is wanted all around it.
template <int Dim>
void SplineSpace<Dim>::make_cell(Index cell, const Local& neighbours) {
  made_[cell] = 1;
  const auto& c = grid_->cell(cell);
  const std::int32_t last = (1 << c.level) - 1;
  for (int n = 0; n < n_local; ++n) {
    if (neighbours[n] != no_index) continue;
    const auto step = step_to<Dim>(n);
    bool outside = false;
    for (int k = 0; k < Dim; ++k)
      outside = outside || c.corner[k] + step[k] < 0 || c.corner[k] + step[k] > last;
    if (!outside) return derive(cell, c.level, c.corner);
  }
  Sampled s{cell, {}};
  for (int k = 0, stride = 1; k < Dim; ++k, stride *= 3)
    for (int side = 0; side < 2; ++side) {
      const Index neighbour = neighbours[n_local / 2 + (side ? stride : -stride)];
      s.neighbours[2 * k + side] = neighbour == no_index ? cell : neighbour;
    }
  sampled_.push_back(s);
}

template <int Dim>
void SplineSpace<Dim>::derive(Index coefficient, int level, const Coord& corner) {
  Derived d{coefficient, false, {}};
  const std::int32_t last = (1 << level) - 1;
  for (int k = 0; k < Dim && !d.outside; ++k) {
    if (corner[k] >= 0 && corner[k] <= last) continue;
    d.outside = true;
    Coord inside = corner;
    for (int i = 0; i < 2; ++i) {
      inside[k] =
          std::clamp(inside[k] + (corner[k] < 0 ? 1 : -1), 0, last);  // a domain of one cell has no second
      d.source[i] = coefficient_at(level, inside);
    }
  }
  for (int c = 0; c < n_corners<Dim> && !d.outside; ++c) {
    Coord coarse;
    for (int k = 0; k < Dim; ++k) {
      coarse[k] = corner[k] >> 1;
      if ((c >> k) & 1) coarse[k] += corner[k] & 1 ? 1 : -1;
    }
    d.source[c] = coefficient_at(level - 1, coarse);
  }
  derived_.push_back(d);
}

template class SplineSpace<2>;
template class SplineSpace<3>;

}  // namespace shellmatch
