#include "geometry/label/smoothed_label.h"

#include "base/parallel.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace shellmatch {

namespace {

// Half the variance that the discrete step adds: sqrt(1/3 + 2 step) is label_smoothing.
constexpr float step = 0.1f;

// Values of the four cubic B-splines around a point, at the fraction t of the way from the second to the third.
std::array<double, 4> spline_weights(double t) {
  const double s = 1 - t;
  return {s * s * s / 6, (4 - 6 * t * t + 3 * t * t * t) / 6, (4 - 6 * s * s + 3 * s * s * s) / 6, t * t * t / 6};
}

// One direction of the discrete step. \pre the first and the last value of every line are 0
void smooth_lines(const std::array<int, 3>& size, int axis, std::vector<float>& values) {
  const std::array<std::size_t, 3> steps{1, static_cast<std::size_t>(size[0]),
                                         static_cast<std::size_t>(size[0]) * size[1]};
  const int u = (axis + 1) % 3, v = (axis + 2) % 3;
  const std::size_t next = steps[axis];
  parallel_for(
      static_cast<std::size_t>(size[u]) * size[v],
      [&](std::size_t line) {
        float* const first = values.data() + line % size[u] * steps[u] + line / size[u] * steps[v];
        float before = 0;
        for (int i = 0; i < size[axis]; ++i) {
          float& value = first[i * next];
          const float here = value, after = i + 1 < size[axis] ? first[(i + 1) * next] : 0;
          value = (1 - 2 * step) * here + step * (before + after);
          before = here;
        }
      },
      256);
}

}  // namespace

SmoothedLabel::SmoothedLabel(const LabelRegion& region) : size_(region.grid.size), coefficients_(region.shares) {
  for (int axis = 0; axis < 3; ++axis) smooth_lines(size_, axis, coefficients_);
  // Rounding must not hide what is constant.
  for (float& c : coefficients_)
    if (c < 1e-6f) c = 0;
    else if (c > 1 - 1e-6f) c = 1;
  find_clearance();
  find_level(region);
}

double SmoothedLabel::share(const Vec<3>& index) const {
  std::array<std::array<double, 4>, 3> weights;
  std::array<int, 3> first;
  for (int a = 0; a < 3; ++a) {
    const double below = std::floor(index[a]);
    if (!(below >= -2 && below <= size_[a])) return 0;
    first[a] = static_cast<int>(below) - 1;
    weights[a] = spline_weights(index[a] - below);
  }
  double sum = 0;
  for (int k = 0; k < 4; ++k) {
    if (first[2] + k < 0 || first[2] + k >= size_[2]) continue;
    double plane = 0;
    for (int j = 0; j < 4; ++j) {
      if (first[1] + j < 0 || first[1] + j >= size_[1]) continue;
      const std::ptrdiff_t line =
          (static_cast<std::ptrdiff_t>(first[2] + k) * size_[1] + first[1] + j) * size_[0] + first[0];
      double part = 0;
      for (int i = 0; i < 4; ++i)
        if (first[0] + i >= 0 && first[0] + i < size_[0])
          part += weights[0][i] * coefficients_[static_cast<std::size_t>(line + i)];
      plane += weights[1][j] * part;
    }
    sum += weights[2][k] * plane;
  }
  return sum;
}

double SmoothedLabel::largest_share() const {
  double largest = 0;
  for (int k = 0; k < size_[2]; ++k)
    for (int j = 0; j < size_[1]; ++j)
      for (int i = 0; i < size_[0]; ++i)
        if (coefficients_[(static_cast<std::size_t>(k) * size_[1] + j) * size_[0] + i] > 0)
          largest = std::max(largest, share(Vec<3>(i, j, k)));
  return largest;
}

// The distance along the axes' greatest difference, by two sweeps over the 26 neighbours.
void SmoothedLabel::find_clearance() {
  constexpr int most = 255;
  clearance_.resize(coefficients_.size());
  for (std::size_t v = 0; v < clearance_.size(); ++v)
    clearance_[v] = coefficients_[v] == 0 || coefficients_[v] == 1 ? most : 0;
  const auto sweep = [&](bool forward) {
    for (int n = 0; n < size_[2]; ++n)
      for (int m = 0; m < size_[1]; ++m)
        for (int l = 0; l < size_[0]; ++l) {
          const int i = forward ? l : size_[0] - 1 - l, j = forward ? m : size_[1] - 1 - m,
                    k = forward ? n : size_[2] - 1 - n;
          std::uint8_t& here = clearance_[(static_cast<std::size_t>(k) * size_[1] + j) * size_[0] + i];
          for (int neighbour = 0; neighbour < 13 && here > 0; ++neighbour) {
            // The 13 of 26 that come before in the order of the sweep.
            const int sign = forward ? 1 : -1;
            const int x = i + sign * (neighbour % 3 - 1), y = j + sign * (neighbour / 3 % 3 - 1),
                      z = k + sign * (neighbour / 9 - 1);
            if (x < 0 || y < 0 || z < 0 || x >= size_[0] || y >= size_[1] || z >= size_[2]) continue;
            const int there = clearance_[(static_cast<std::size_t>(z) * size_[1] + y) * size_[0] + x];
            here = static_cast<std::uint8_t>(std::min<int>(here, std::min(there + 1, most)));
          }
        }
  };
  sweep(true);
  sweep(false);
}

double SmoothedLabel::clearance(const Vec<3>& index) const {
  std::array<int, 3> nearest;
  double outside = 0;
  for (int a = 0; a < 3; ++a) {
    const double inside = std::clamp(index[a], 0.0, size_[a] - 1.0);
    outside = std::max(outside, std::abs(index[a] - inside));
    nearest[a] = static_cast<int>(std::lround(inside));
  }
  const double there =
      clearance_[(static_cast<std::size_t>(nearest[2]) * size_[1] + nearest[1]) * size_[0] + nearest[0]];
  // A coefficient reaches two voxels, and the nearest voxel is up to half of one away.
  return std::max({0.0, there - 3, outside - 3});
}

// Shares are sampled at 27 points between neighbouring voxels and counted in classes, which is exact enough and takes
// no memory.
void SmoothedLabel::find_level(const LabelRegion& region) {
  constexpr int n_samples = 3, n_classes = 1 << 14;
  using Counts = std::vector<std::int64_t>;
  const auto count_slice = [&](const Chunk& chunk) {
    Counts counts(n_classes + 1, 0);
    for (int k = static_cast<int>(chunk.begin); k < static_cast<int>(chunk.end); ++k)
      for (int j = 0; j < size_[1] - 1; ++j)
        for (int i = 0; i < size_[0] - 1; ++i) {
          const std::size_t v = (static_cast<std::size_t>(k) * size_[1] + j) * size_[0] + i;
          if (clearance_[v] > 3) {
            counts[coefficients_[v] > 0 ? n_classes : 0] += n_samples * n_samples * n_samples;
            continue;
          }
          for (int s = 0; s < n_samples * n_samples * n_samples; ++s) {
            const Vec<3> offset(s % n_samples + 0.5, s / n_samples % n_samples + 0.5,
                                s / (n_samples * n_samples) + 0.5);
            ++counts[static_cast<std::size_t>(
                std::lround(n_classes * std::clamp(share(Vec<3>(i, j, k) + offset / n_samples), 0.0, 1.0)))];
          }
        }
    return counts;
  };
  std::vector<Counts> parts(n_chunks(static_cast<std::size_t>(size_[2]) - 1, 16));
  parallel_chunks(static_cast<std::size_t>(size_[2]) - 1, 16,
                  [&](const Chunk& chunk) { parts[chunk.index] = count_slice(chunk); });
  double left = 0;
  for (const float share : region.shares) left += share;
  left *= n_samples * n_samples * n_samples;
  for (int c = n_classes; c > 0; --c) {
    double n = 0;
    for (const Counts& counts : parts) n += static_cast<double>(counts[static_cast<std::size_t>(c)]);
    if (left <= n) {
      level_ = (c + 0.5 - left / n) / n_classes;
      break;
    }
    left -= n;
  }
  // Of a sheet a voxel thick nothing but a low level leaves anything, and near 0 and 1 there is no surface.
  level_ = std::clamp(level_, 0.15, 0.6);
}

}  // namespace shellmatch
