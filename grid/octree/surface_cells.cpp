#include "grid/octree/surface_cells.h"

#include <algorithm>
#include <cmath>

namespace shellmatch {

template <int Dim>
bool changes_sign(const Octree<Dim>& grid, const std::vector<double>& nodal_distance, Index leaf) {
  bool negative = false, positive = false;
  for (const Index node : grid.cell(leaf).nodes) {
    negative = negative || nodal_distance[node] <= 0;
    positive = positive || nodal_distance[node] >= 0;
  }
  return negative && positive;
}

template <int Dim>
bool cube_meets_surface(const std::function<double(const Vec<Dim>&)>& distance, const Vec<Dim>& centre, double side,
                        int depth) {
  const double d = std::abs(distance(centre));
  if (d <= 0.5 * side) return true;
  if (d > 0.5 * std::sqrt(double(Dim)) * side) return false;
  if (depth == 0) return true;
  for (int c = 0; c < n_corners<Dim>; ++c) {
    Vec<Dim> part = centre;
    for (int k = 0; k < Dim; ++k) part[k] += ((c >> k) & 1 ? 0.25 : -0.25) * side;
    if (cube_meets_surface<Dim>(distance, part, 0.5 * side, depth - 1)) return true;
  }
  return false;
}

template <int Dim>
bool meets_surface(const Octree<Dim>& grid, const std::vector<double>& nodal_distance,
                   const std::function<double(const Vec<Dim>&)>& distance, Index leaf) {
  const auto& cell = grid.cell(leaf);
  double least = 1, greatest = -1, farthest = 0;
  for (const Index node : cell.nodes) {
    if (grid.free_index(node) == no_index) continue;  // interpolated values are not distances
    least = std::min(least, nodal_distance[node]);
    greatest = std::max(greatest, nodal_distance[node]);
    farthest = std::max(farthest, std::abs(nodal_distance[node]));
  }
  if (least <= 0 && greatest >= 0) return true;
  if (farthest > std::sqrt(double(Dim)) * cell.side())
    return false;  // the leaf lies within a ball that the surface does not meet
  return cube_meets_surface<Dim>(distance, grid.cell_centre(leaf), cell.side());
}

SHELLMATCH_2D_3D(changes_sign);
SHELLMATCH_2D_3D(cube_meets_surface);
SHELLMATCH_2D_3D(meets_surface);

}  // namespace shellmatch
