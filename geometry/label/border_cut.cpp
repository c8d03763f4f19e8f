#include "geometry/label/border_cut.h"

#include <Eigen/LU>

#include <algorithm>
#include <cmath>

namespace shellmatch {

namespace {

// Whether a voxel next to `index` in the layer `at` across the axis is chosen.
bool is_cut(const Volume& volume, const VoxelChoice& choice, int axis, int at, const Vec<3>& index,
            const std::array<int, 3>& blocks) {
  std::array<int, 3> low, high;
  for (int a = 0; a < 3; ++a) {
    const int last = volume.grid.size[a] - 1;
    low[a] =
        a == axis ? at : static_cast<int>(std::clamp(std::floor(index[a] - blocks[a]), 0.0, static_cast<double>(last)));
    high[a] =
        a == axis ? at : static_cast<int>(std::clamp(std::ceil(index[a] + blocks[a]), 0.0, static_cast<double>(last)));
  }
  for (int k = low[2]; k <= high[2]; ++k)
    for (int j = low[1]; j <= high[1]; ++j)
      for (int i = low[0]; i <= high[0]; ++i)
        if (choice.contains(volume.values[volume.grid.number(i, j, k)])) return true;
  return false;
}

}  // namespace

std::vector<Index> facets_at_border(const Surface<3>& surface, const Volume& volume, const VoxelChoice& choice,
                                    const LabelRegion& region) {
  const VoxelGrid& grid = volume.grid;
  const Mat<3> to_index = grid.axes.inverse();
  std::array<int, 3> blocks;
  for (int a = 0; a < 3; ++a)
    blocks[a] = static_cast<int>(std::lround(region.grid.axes.col(a).norm() / grid.axes.col(a).norm()));
  std::vector<Index> found;
  for (std::size_t f = 0; f < surface.facets.size(); ++f) {
    const auto& [a, b, c] = surface.facets[f];
    const Vec<3> centre = (surface.vertices[a] + surface.vertices[b] + surface.vertices[c]) / 3;
    const Vec<3> index = to_index * (centre - grid.origin);
    for (int axis = 0; axis < 3; ++axis) {
      const double depth = blocks[axis] - 0.5;  // the border is half a voxel before the first
      const int last = grid.size[axis] - 1;
      if ((index[axis] < depth && is_cut(volume, choice, axis, 0, index, blocks)) ||
          (index[axis] > last - depth && is_cut(volume, choice, axis, last, index, blocks))) {
        found.push_back(static_cast<Index>(f));
        break;
      }
    }
  }
  return found;
}

}  // namespace shellmatch
