#include "grid/fits/nearest_nodes.h"

#include <nanoflann.hpp>

#include <algorithm>

namespace shellmatch {

namespace {

// nanoflann 1.5 has types of its own where 1.4 has pairs.
#if NANOFLANN_VERSION >= 0x150
using FoundNode = nanoflann::ResultItem<Index, double>;
const nanoflann::SearchParameters in_any_order(0, false);
#else
using FoundNode = std::pair<Index, double>;
const nanoflann::SearchParams in_any_order(0, 0, false);
#endif

template <int Dim>
struct NodePoints {
  std::vector<std::array<double, Dim>> points;
  explicit NodePoints(const Octree<Dim>& grid) : points(grid.free_nodes().size()) {
    for (std::size_t i = 0; i < points.size(); ++i)
      for (int k = 0; k < Dim; ++k) points[i][k] = grid.node_coord(grid.free_nodes()[i])[k];
  }
  std::size_t kdtree_get_point_count() const { return points.size(); }
  double kdtree_get_pt(std::size_t i, std::size_t k) const { return points[i][k]; }
  template <class Box>
  bool kdtree_get_bbox(Box&) const {
    return false;
  }
};

}  // namespace

template <int Dim>
struct NearestNodes<Dim>::Tree {
  explicit Tree(const Octree<Dim>& grid)
      : points(grid), index(Dim, points, nanoflann::KDTreeSingleIndexAdaptorParams(12)) {}
  NodePoints<Dim> points;
  nanoflann::KDTreeSingleIndexAdaptor<nanoflann::L2_Simple_Adaptor<double, NodePoints<Dim>>, NodePoints<Dim>, Dim,
                                      Index>
      index;
};

template <int Dim>
NearestNodes<Dim>::NearestNodes(const Octree<Dim>& grid) : tree_(std::make_unique<const Tree>(grid)) {}
template <int Dim>
NearestNodes<Dim>::~NearestNodes() = default;

template <int Dim>
std::pair<double, double> NearestNodes<Dim>::find(const std::array<double, Dim>& centre, std::size_t n,
                                                  Scratch& scratch) const {
  thread_local std::vector<FoundNode> found;  // kept for its memory alone
  auto& [ball, squares, guess] = scratch;
  // Squared distances are integers, and the search returns what is strictly nearer.
  while (tree_->index.radiusSearch(centre.data(), guess + 0.5, found, in_any_order) <= n) guess = 2 * guess + 1;
  squares.clear();
  for (const auto& node : found) squares.push_back(node.second);
  std::ranges::nth_element(squares, squares.begin() + static_cast<std::ptrdiff_t>(n));  // squares[0] is the node itself
  const double farthest = guess = squares[n];
  double nearest = farthest;
  ball.clear();
  for (const auto& [position, square] : found) {
    if (square > farthest) continue;
    ball.push_back({position, square});
    if (square > 0) nearest = std::min(nearest, square);
  }
  std::ranges::sort(ball, {}, &Member::position);
  return {nearest, farthest};
}

template class NearestNodes<2>;
template class NearestNodes<3>;

}  // namespace shellmatch
