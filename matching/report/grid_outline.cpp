#include "matching/report/grid_outline.h"

#include <algorithm>
#include <utility>

namespace shellmatch {

namespace {

// A corner, with its place in the order of the outline.
struct Corner {
  std::uint64_t key;
  Index node;
};

template <int Dim>
class Traversal {
 public:
  Traversal(const Octree<Dim>& grid, int finest_level, GridOutline<Dim>& outline)
      : grid_(grid), finest_level_(finest_level), outline_(outline) {}

  std::vector<Corner> corners() && {
    descend(0);
    std::ranges::sort(corners_, {}, &Corner::key);
    const auto rest = std::ranges::unique(corners_, {}, &Corner::key);
    corners_.erase(rest.begin(), rest.end());
    return std::move(corners_);
  }

 private:
  void descend(Index number) {
    const auto cell = grid_.cell(number);
    if (!cell.is_leaf() && cell.level < finest_level_) {
      for (int c = 0; c < n_corners<Dim>; ++c) descend(cell.first_child + c);
      return;
    }
    outline_.levels.push_back(static_cast<std::uint8_t>(cell.level));
    for (const Index node : cell.nodes) {
      std::uint64_t key = 0;
      for (int k = Dim - 1; k >= 0; --k)
        key = key << 21 | static_cast<std::uint64_t>(grid_.node_coord(node)[static_cast<std::size_t>(k)]);
      corners_.push_back({key, node});
    }
  }

  const Octree<Dim>& grid_;
  int finest_level_;
  GridOutline<Dim>& outline_;
  std::vector<Corner> corners_;
};

}  // namespace

template <int Dim>
GridOutline<Dim> grid_outline(const Octree<Dim>& grid, std::size_t most_corners) {
  static_assert(Octree<Dim>::max_level < 21, "a coordinate has 21 bits of a key");
  for (int level = grid.finest_level();; --level) {
    GridOutline<Dim> outline;
    outline.finest_level = level;
    const std::vector<Corner> corners = Traversal<Dim>(grid, level, outline).corners();
    if (corners.size() > most_corners && level > 0) continue;
    for (const Corner& corner : corners) outline.corners.push_back(corner.node);
    return outline;
  }
}

SHELLMATCH_2D_3D(grid_outline);

}  // namespace shellmatch
