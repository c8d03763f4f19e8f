#include "grid/octree/rebuild_grid.h"

#include <algorithm>
#include <cstdint>
#include <utility>

namespace shellmatch {

template <int Dim>
std::optional<Octree<Dim>> rebuild_grid(const std::vector<LeafPlace<Dim>>& leaves) {
  using Coord = typename Octree<Dim>::Coord;
  // The cells must fill the domain. Volumes are in units of the smallest possible cell, at most 2^57 in total.
  constexpr int finest = Octree<Dim>::max_level;
  std::uint64_t volume = 0;
  const std::uint64_t domain = std::uint64_t{1} << (Dim * finest);
  int coarsest_level = finest, finest_level = 0;
  for (const LeafPlace<Dim>& leaf : leaves) {
    volume += std::uint64_t{1} << (Dim * (finest - leaf.level));
    if (volume > domain) return std::nullopt;
    coarsest_level = std::min(coarsest_level, leaf.level);
    finest_level = std::max(finest_level, leaf.level);
  }
  if (volume != domain) return std::nullopt;

  // The ancestors of the leaves, by level: the cells to split.
  std::vector<std::vector<Coord>> inner(static_cast<std::size_t>(finest_level) + 1);
  for (const LeafPlace<Dim>& leaf : leaves)
    if (leaf.level > 0) {
      Coord parent = leaf.corner;
      for (std::int32_t& c : parent) c >>= 1;
      inner[leaf.level - 1].push_back(parent);
    }
  for (int level = finest_level; level-- > 0;) {
    std::vector<Coord>& here = inner[level];
    std::sort(here.begin(), here.end());
    here.erase(std::unique(here.begin(), here.end()), here.end());
    if (level > 0)
      for (Coord parent : here) {
        for (std::int32_t& c : parent) c >>= 1;
        inner[level - 1].push_back(parent);
      }
  }

  Octree<Dim> grid(0);
  for (int level = 0; level < finest_level; ++level) {
    const std::vector<Coord>& to_split = inner[level];
    grid.refine([&](Index c) {
      const auto& cell = grid.cell(c);
      return cell.level == level && std::binary_search(to_split.begin(), to_split.end(), cell.corner);
    });
    // Enforcing the balance splits more cells only if the list is not balanced.
    if (grid.leaves().size() > leaves.size()) return std::nullopt;
  }
  // With as many leaves as listed cells, and every listed cell found once among them, both sets are equal.
  if (grid.leaves().size() != leaves.size()) return std::nullopt;
  std::vector<char> is_met(static_cast<std::size_t>(grid.n_cells()), 0);
  for (const LeafPlace<Dim>& leaf : leaves) {
    const Index c = grid.find_cell(leaf.level, leaf.corner);
    if (c == no_index || !grid.cell(c).is_leaf() || std::exchange(is_met[c], char{1})) return std::nullopt;
  }
  return grid;
}

SHELLMATCH_2D_3D(rebuild_grid);

}  // namespace shellmatch
