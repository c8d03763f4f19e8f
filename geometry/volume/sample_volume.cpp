#include "geometry/volume/sample_volume.h"

#include <Eigen/LU>

#include <algorithm>
#include <array>
#include <cmath>
#include <set>

namespace shellmatch {

bool is_label_volume(const Volume& volume) {
  constexpr std::size_t most = 100;
  std::set<float> values;
  float last = -1;
  for (const float v : volume.values) {
    if (v == last) continue;
    last = v;
    if (v < 0 || v != std::round(v) || (values.insert(v), values.size() > most)) return false;
  }
  return true;
}

VolumeSampler::VolumeSampler(const Volume& volume, Sampling sampling)
    : volume_(&volume), sampling_(sampling), to_index_(volume.grid.axes.inverse()) {}

float VolumeSampler::operator()(const Vec<3>& x, float background) const {
  const VoxelGrid& grid = volume_->grid;
  Vec<3> index = to_index_ * (x - grid.origin);
  constexpr double half = 0.5 + 1e-9;
  for (int a = 0; a < 3; ++a) {
    if (!(index[a] >= -half && index[a] <= grid.size[a] - 1 + half)) return background;
    index[a] = std::clamp(index[a], 0.0, grid.size[a] - 1.0);
  }
  switch (sampling_) {
    case Sampling::label: return label_at(index);
    case Sampling::linear: return linear_at(index);
    default:
      return volume_
          ->values[grid.number(static_cast<int>(std::lround(index[0])), static_cast<int>(std::lround(index[1])),
                               static_cast<int>(std::lround(index[2])))];
  }
}

float VolumeSampler::label_at(const Vec<3>& index) const {
  const VoxelGrid& grid = volume_->grid;
  std::array<std::array<int, 4>, 3> at;
  std::array<std::array<double, 4>, 3> weight;
  for (int a = 0; a < 3; ++a) {
    const double below = std::floor(index[a]), t = index[a] - below, s = 1 - t;
    weight[a] = {s * s * s / 6, (4 - 6 * t * t + 3 * t * t * t) / 6, (4 - 6 * s * s + 3 * s * s * s) / 6,
                 t * t * t / 6};
    for (int n = 0; n < 4; ++n) at[a][n] = std::clamp(static_cast<int>(below) - 1 + n, 0, grid.size[a] - 1);
  }
  // At most 64 values, of which few differ.
  std::array<float, 64> values;
  std::array<double, 64> shares;
  std::size_t n_values = 0;
  for (int k = 0; k < 4; ++k)
    for (int j = 0; j < 4; ++j)
      for (int i = 0; i < 4; ++i) {
        const float value = volume_->values[grid.number(at[0][i], at[1][j], at[2][k])];
        const double share = weight[0][i] * weight[1][j] * weight[2][k];
        std::size_t n = 0;
        while (n < n_values && values[n] != value) ++n;
        if (n == n_values) {
          values[n_values] = value;
          shares[n_values++] = share;
        } else {
          shares[n] += share;
        }
      }
  return values[static_cast<std::size_t>(
      std::max_element(shares.begin(), shares.begin() + static_cast<std::ptrdiff_t>(n_values)) - shares.begin())];
}

float VolumeSampler::linear_at(const Vec<3>& index) const {
  const VoxelGrid& grid = volume_->grid;
  std::array<int, 3> low;
  Vec<3> t;
  for (int a = 0; a < 3; ++a) {
    low[a] = std::min(static_cast<int>(index[a]), grid.size[a] - 2);
    t[a] = index[a] - low[a];
  }
  double sum = 0;
  for (int c = 0; c < 8; ++c) {
    double weight = 1;
    for (int a = 0; a < 3; ++a) weight *= c >> a & 1 ? t[a] : 1 - t[a];
    sum += weight * volume_->values[grid.number(low[0] + (c & 1), low[1] + (c >> 1 & 1), low[2] + (c >> 2 & 1))];
  }
  return static_cast<float>(sum);
}

}  // namespace shellmatch
