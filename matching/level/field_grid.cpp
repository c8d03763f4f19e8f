#include "matching/level/field_grid.h"

#include "base/parallel.h"
#include "grid/fields/fast_marching.h"

#include <cmath>
#include <functional>

namespace shellmatch {

template <int Dim>
void NodalDistance<Dim>::compute(const Octree<Dim>& grid, const SignedDistance<Dim>& shape, DistanceMethod method) {
  if (method == DistanceMethod::fast_marching) {
    values_ = march_distance<Dim>(grid, std::cref(shape));
    return;
  }
  const std::size_t known = values_.size();
  values_.resize(static_cast<std::size_t>(grid.n_nodes()));
  parallel_chunks(values_.size() - known, 256, [&](const Chunk& chunk) {
    std::vector<Vec<Dim>> nodes;
    for (std::size_t i = chunk.begin; i < chunk.end; ++i)
      nodes.push_back(grid.node_position(static_cast<Index>(known + i)));
    shape(nodes, std::span(values_).subspan(known + chunk.begin, nodes.size()));
  });
}

template <int Dim>
void FieldGrid<Dim>::compute(const SignedDistance<Dim>& shape, const CoefficientOptions& options) {
  distance.compute(grid, shape, options.distance);
  // Fast marching changes the distances at all nodes, so all fits have to be computed again.
  if (options.distance == DistanceMethod::fast_marching) hessians = {};
  hessians.update(grid, distance.values(), options);
}

template <int Dim>
void FieldGrid<Dim>::refine(double reach) {
  const int finest = grid.finest_level();
  grid.refine([&](Index leaf) {
    const auto& cell = grid.cell(leaf);
    if (cell.level < finest) return false;
    for (const Index node : cell.nodes)
      if (std::abs(distance.values()[node]) <= reach * cell.side()) return true;
    return false;
  });
}

template class NodalDistance<2>;
template class NodalDistance<3>;
template struct FieldGrid<2>;
template struct FieldGrid<3>;

}  // namespace shellmatch
