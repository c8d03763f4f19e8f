#include "grid/fields/spline_space.h"

#include "base/parallel.h"

#include <algorithm>

namespace shellmatch {

namespace {

// The corner of neighbour `number` of the 3^Dim around a cell; the middle one is the cell itself.
template <int Dim>
std::array<std::int32_t, Dim> stepped(std::array<std::int32_t, Dim> corner, int number) {
  for (int k = 0; k < Dim; ++k, number /= 3) corner[k] += number % 3 - 1;
  return corner;
}

// A unique key for each cell position of each level, including the layer around the domain.
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
      locator_(grid.locator()),
      finest_level_(grid.finest_level()),
      siblings_(static_cast<std::size_t>(grid.n_cells() + n_siblings - 2) / n_siblings + 1),
      n_of_cells_(static_cast<Index>(siblings_.size()) * n_siblings),
      n_coefficients_(n_of_cells_),
      made_(static_cast<std::size_t>(n_coefficients_), Made::no) {
  parallel_for(
      siblings_.size(),
      [&](std::size_t group) {
        const auto& cell = grid.cell(cell_of(static_cast<Index>(group) * n_siblings));
        Siblings& s = siblings_[group];
        s.level = cell.level;
        for (int k = 0; k < Dim; ++k) s.corner[k] = cell.corner[k] >> 1;
        for (int n = 0; n < n_local; ++n) s.first[n] = group_in_grid(s.level, stepped<Dim>(s.corner, n));
      },
      256);
  for (const Index cell : grid.leaves()) ask_for_neighbours(number_of(cell));
  others_ = decltype(others_)();  // as in forget_grid()
}

template <int Dim>
void SplineSpace<Dim>::forget_grid() {
  grid_ = nullptr;
  // Assigning {} would keep the capacity.
  made_ = std::vector<Made>();
  derived_ = std::vector<Derived>();
}

// The first coefficient of the children of the cell `parent`; no_index where the grid has no such children.
template <int Dim>
Index SplineSpace<Dim>::group_in_grid(int level, const Coord& parent) const {
  if (level == 0) return parent == Coord{} ? 0 : no_index;
  const Index cell = grid_->find_cell(level - 1, parent);
  if (cell == no_index || grid_->cell(cell).is_leaf()) return no_index;
  return number_of(grid_->cell(cell).first_child);
}

template <int Dim>
void SplineSpace<Dim>::ask_for_neighbours(Index leaf) {
  const int level = level_of(leaf);
  const Coord corner = corner_of(leaf);
  make(leaf, level, corner);
  for (int n = 0; n < n_local; ++n) {
    const Index known = neighbour(leaf, n);
    if (known != no_index && made_[known] != Made::no) continue;
    const Coord there = stepped<Dim>(corner, n);
    if (known != no_index) {
      make(known, level, there);
      continue;
    }
    const Index c = coefficient_at(level, there);
    int group = 0;  // among the 3^Dim around
    for (int k = 0, stride = 1; k < Dim; ++k, stride *= 3) group += stride * ((there[k] >> 1) - (corner[k] >> 1) + 1);
    siblings_[leaf / n_siblings].first[group] = c - c % n_siblings;
  }
}

template <int Dim>
Index SplineSpace<Dim>::coefficient_at(int level, const Coord& corner) {
  Coord parent;
  int child = 0;
  for (int k = 0; k < Dim; ++k) {
    parent[k] = corner[k] >> 1;
    child |= (corner[k] & 1) << k;
  }
  Index first = group_in_grid(level, parent);
  if (first == no_index) {
    const auto [entry, is_new] = others_.try_emplace(key_of<Dim>(level, parent), n_coefficients_);
    first = entry->second;
    if (is_new) {
      n_coefficients_ += n_siblings;
      made_.resize(static_cast<std::size_t>(n_coefficients_), Made::no);
    }
  }
  make(first + child, level, corner);
  return first + child;
}

// A cell's coefficient is computed from nodal values where all its neighbours in the domain exist on its
// level, and derived from other coefficients elsewhere.
template <int Dim>
void SplineSpace<Dim>::make(Index coefficient, int level, const Coord& corner) {
  if (made_[coefficient] != Made::no) return;
  const bool sampled = is_of_cell(coefficient) && is_among_its_size(coefficient, level, corner);
  made_[coefficient] = sampled ? Made::sampled : Made::derived;
  if (!sampled) derive(coefficient, level, corner);
}

template <int Dim>
bool SplineSpace<Dim>::is_among_its_size(Index coefficient, int level, const Coord& corner) const {
  for (int n = 0; n < n_local; ++n) {
    if (is_of_cell(neighbour(coefficient, n))) continue;
    const auto there = stepped<Dim>(corner, n);
    if (std::ranges::all_of(there, [&](std::int32_t v) { return v >= 0 && v < (1 << level); })) return false;
  }
  return true;
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
      inside[k] = std::clamp(inside[k] + (corner[k] < 0 ? 1 : -1), 0, last);  // clamped for a domain of one cell
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
