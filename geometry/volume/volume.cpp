#include "geometry/volume/volume.h"

#include <Eigen/LU>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <utility>

namespace shellmatch {

double VoxelGrid::voxel_volume() const { return std::abs(axes.determinant()); }

double VoxelGrid::least_spacing() const {
  // The rows of the inverse are the normals of the planes, of the length 1/distance.
  return 1 / axes.inverse().rowwise().norm().maxCoeff();
}

VoxelGrid exchange_space(VoxelGrid grid) {
  grid.origin = exchange_space(grid.origin);
  for (int k = 0; k < 3; ++k) grid.axes.col(k) = exchange_space(Vec<3>(grid.axes.col(k)));
  return grid;
}

std::optional<double> millimetres_of(std::string_view unit) {
  struct Name {
    double millimetres;
    std::initializer_list<std::string_view> names;
  };
  static const Name table[] = {{1, {"mm", "millimetre", "millimeter", "millimetres", "millimeters"}},
                               {10, {"cm", "centimetre", "centimeter", "centimetres", "centimeters"}},
                               {1000, {"m", "metre", "meter", "metres", "meters"}},
                               {1e-3, {"um", "\u00b5m", "\u03bcm", "micron", "microns"}},
                               {1e-3, {"micrometre", "micrometer", "micrometres", "micrometers"}},
                               {1e-6, {"nm", "nanometre", "nanometer", "nanometres", "nanometers"}},
                               {25.4, {"in", "inch", "inches"}}};
  for (const auto& [millimetres, names] : table)
    if (std::ranges::find(names, unit) != names.end()) return millimetres;
  return std::nullopt;
}

bool is_integer(VoxelType type) { return type != VoxelType::float32 && type != VoxelType::float64; }

Volume canonical(Volume volume) {
  const VoxelGrid& grid = volume.grid;
  // The axes are assigned one by one, the clearest first.
  std::array<int, 3> axis_along{-1, -1, -1};
  const Mat<3> cosines = grid.axes.colwise().normalized().cwiseAbs();
  std::array<bool, 3> is_taken{};
  for (int n = 0; n < 3; ++n) {
    int best_row = -1, best_column = -1;
    for (int row = 0; row < 3; ++row)
      for (int column = 0; column < 3; ++column)
        if (axis_along[row] < 0 && !is_taken[column] &&
            (best_row < 0 || cosines(row, column) > cosines(best_row, best_column)))
          best_row = row, best_column = column;
    axis_along[best_row] = best_column;
    is_taken[best_column] = true;
  }
  Volume result{{}, volume.type, {}};
  VoxelGrid& to = result.grid;
  to.unit = grid.unit;
  std::array<std::ptrdiff_t, 3> step{};
  std::ptrdiff_t first = 0;
  Vec<3> first_index = Vec<3>::Zero();
  const std::array<std::ptrdiff_t, 3> steps{1, grid.size[0], static_cast<std::ptrdiff_t>(grid.size[0]) * grid.size[1]};
  for (int row = 0; row < 3; ++row) {
    const int from = axis_along[row];
    const bool turned = grid.axes(row, from) < 0;
    to.size[row] = grid.size[from];
    to.axes.col(row) = turned ? Vec<3>(-grid.axes.col(from)) : Vec<3>(grid.axes.col(from));
    step[row] = turned ? -steps[from] : steps[from];
    if (turned) {
      first_index[from] = grid.size[from] - 1;
      first += (grid.size[from] - 1) * steps[from];
    }
  }
  to.origin = grid.position(first_index);
  if (step == steps) {
    result.values = std::move(volume.values);
    return result;
  }
  result.values.reserve(volume.values.size());
  for (int k = 0; k < to.size[2]; ++k)
    for (int j = 0; j < to.size[1]; ++j)
      for (int i = 0; i < to.size[0]; ++i)
        result.values.push_back(
            volume.values[static_cast<std::size_t>(first + i * step[0] + j * step[1] + k * step[2])]);
  return result;
}

std::string spacing_text(const VoxelGrid& grid) {
  const Vec<3> spacing = grid.axes.colwise().norm();
  return fmt::format("{:.4g} x {:.4g} x {:.4g}", spacing[0], spacing[1], spacing[2]);
}

}  // namespace shellmatch
