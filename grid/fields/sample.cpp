#include "grid/fields/sample.h"

#include "base/parallel.h"
#include "grid/octree/constraints.h"

namespace shellmatch {

template <int Dim>
std::vector<double> sample_nodes(const Octree<Dim>& grid, const std::function<double(const Vec<Dim>&)>& function,
                                 HangingValues hanging) {
  std::vector<double> nodal(grid.n_nodes(), 0.0);
  const bool interpolate = hanging == HangingValues::interpolated;
  // One distance may take microseconds, so small chunks balance the load of the threads.
  parallel_for(
      nodal.size(),
      [&](std::size_t n) {
        const Index node = static_cast<Index>(n);
        if (!interpolate || grid.free_index(node) != no_index) nodal[n] = function(grid.node_position(node));
      },
      256);
  if (interpolate) distribute(grid, nodal);
  return nodal;
}

SHELLMATCH_2D_3D(sample_nodes);

}  // namespace shellmatch
