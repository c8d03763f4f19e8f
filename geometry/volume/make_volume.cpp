#include "geometry/volume/make_volume.h"

#include "base/error.h"
#include "geometry/volume/volume_header.h"

#include <cmath>
#include <utility>

namespace shellmatch {

Volume make_volume(const std::string& source, const std::array<std::int64_t, 3>& size, const Mat<4>& to_space,
                   Space space, VoxelType type, std::vector<float> values) {
  Volume volume{{}, type, std::move(values)};
  VoxelGrid& grid = volume.grid;
  set_size(source, size, grid);
  if (to_space.row(3) != Mat<4>::Identity().row(3))
    throw_input_error("{}: the last row of the affine matrix is {:g} {:g} {:g} {:g}; expected 0 0 0 1", source,
                      to_space(3, 0), to_space(3, 1), to_space(3, 2), to_space(3, 3));
  grid.axes = to_space.topLeftCorner<3, 3>();
  grid.origin = to_space.topRightCorner<3, 1>();
  check_frame(source, grid);
  if (space == Space::lps) grid = exchange_space(grid);
  if (volume.values.size() != grid.n_voxels())
    throw_input_error("{}: {} values for {} x {} x {} voxels", source, volume.values.size(), size[0], size[1], size[2]);
  for (std::size_t i = 0; i < volume.values.size(); ++i) {
    const double value = volume.values[i];
    if (std::isfinite(value) && std::abs(value) <= (is_integer(type) ? largest_label : 1e30)) continue;
    throw_input_error(
        "{}: voxel {} {} {} (counted from 0) is {:g}, no number that can be used; replace such voxels, by the "
        "background say",
        source, i % grid.size[0], i / grid.size[0] % grid.size[1], i / grid.size[0] / grid.size[1], value);
  }
  return volume;
}

}  // namespace shellmatch
