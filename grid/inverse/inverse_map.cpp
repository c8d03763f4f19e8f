#include "grid/inverse/inverse_map.h"

#include "grid/fields/interpolation.h"

#include <Eigen/LU>

#include <array>
#include <cmath>

namespace shellmatch {

namespace {

/// Images of a cell's corners.
template <int Dim>
using Corners = std::array<Vec<Dim>, n_corners<Dim>>;

template <int Dim>
Corners<Dim> corners_of(const Octree<Dim>& grid, std::span<const Vec<Dim>> phi, Index leaf) {
  Corners<Dim> corners;
  const auto& nodes = grid.cell(leaf).nodes;
  for (int c = 0; c < n_corners<Dim>; ++c) corners[c] = phi[nodes[c]];
  return corners;
}

/// The image of a cell lies in the box of its corners, because shape functions are not negative and add up to 1.
template <int Dim>
std::pair<Vec<Dim>, Vec<Dim>> box_of(const Corners<Dim>& corners, double margin) {
  Vec<Dim> low = corners[0], high = corners[0];
  for (const Vec<Dim>& p : corners) {
    low = low.cwiseMin(p);
    high = high.cwiseMax(p);
  }
  return {low.array() - margin, high.array() + margin};
}

// Positions are of the size of the domain, so that this is a few thousand times their rounding.
constexpr double box_margin = 1e-12;

template <int Dim>
Vec<Dim> image(const Corners<Dim>& corners, const Vec<Dim>& xi) {
  const auto w = shape_values<Dim>(xi);
  Vec<Dim> y = Vec<Dim>::Zero();
  for (int c = 0; c < n_corners<Dim>; ++c) y += w[c] * corners[c];
  return y;
}

template <int Dim>
Mat<Dim> jacobian(const Corners<Dim>& corners, const Vec<Dim>& xi) {
  const auto g = shape_gradients<Dim>(xi);
  Mat<Dim> j = Mat<Dim>::Zero();
  for (int c = 0; c < n_corners<Dim>; ++c) j += corners[c] * g[c].transpose();
  return j;
}

/// Newton's method in one cell from its centre; none where it leaves the cell or does not converge.
template <int Dim>
std::optional<Vec<Dim>> newton(const Corners<Dim>& corners, const Vec<Dim>& y) {
  constexpr double inside = 1e-10;  // of a cell's side, on either side of a face
  Vec<Dim> xi = Vec<Dim>::Constant(0.5);
  for (int iteration = 0; iteration < 20; ++iteration) {
    const Vec<Dim> step = jacobian(corners, xi).partialPivLu().solve(Vec<Dim>(y - image(corners, xi)));
    if (!step.allFinite()) return std::nullopt;
    xi += step;
    if ((xi.array() < -1).any() || (xi.array() > 2).any()) return std::nullopt;
    if (step.norm() > 1e-13) continue;
    if ((xi.array() < -inside).any() || (xi.array() > 1 + inside).any()) return std::nullopt;
    return Vec<Dim>(xi.cwiseMax(0.0).cwiseMin(1.0));
  }
  return std::nullopt;
}

/// Local coordinates of y in a cell, or none if it is not in its image.
template <int Dim>
std::optional<Vec<Dim>> preimage_in_cell(const Corners<Dim>& corners, const Vec<Dim>& y, int depth = 0) {
  constexpr int most_bisections = 12;
  const auto [low, high] = box_of<Dim>(corners, box_margin);
  if ((y.array() < low.array()).any() || (y.array() > high.array()).any()) return std::nullopt;
  if (const auto xi = newton(corners, y)) return xi;
  if (depth == most_bisections) return std::nullopt;
  for (int child = 0; child < n_corners<Dim>; ++child) {
    Vec<Dim> offset;
    for (int k = 0; k < Dim; ++k) offset[k] = 0.5 * ((child >> k) & 1);
    Corners<Dim> half;
    for (int c = 0; c < n_corners<Dim>; ++c) {
      Vec<Dim> xi = offset;
      for (int k = 0; k < Dim; ++k) xi[k] += 0.5 * ((c >> k) & 1);
      half[c] = image(corners, xi);
    }
    if (const auto xi = preimage_in_cell(half, y, depth + 1)) return Vec<Dim>(offset + 0.5 * *xi);
  }
  return std::nullopt;
}

}  // namespace

template <int Dim>
InverseMap<Dim>::InverseMap(const Octree<Dim>& grid, std::span<const Vec<Dim>> phi)
    : grid_(&grid), phi_(phi), tree_([&] {
        std::vector<std::pair<Vec<Dim>, Vec<Dim>>> boxes;
        boxes.reserve(grid.leaves().size());
        for (const Index leaf : grid.leaves()) boxes.push_back(box_of<Dim>(corners_of(grid, phi, leaf), box_margin));
        return BoxTree<Dim>(boxes);
      }()) {}

template <int Dim>
std::optional<Vec<Dim>> InverseMap<Dim>::operator()(const Vec<Dim>& y) const {
  // Bisecting the cells beside the right one takes longest: where Newton's method finds the point, it is spared.
  const auto cells = tree_.containing(y);
  for (const bool is_bisected : {false, true})
    for (const Index i : cells) {
      const Index leaf = grid_->leaves()[i];
      const Corners<Dim> corners = corners_of(*grid_, phi_, leaf);
      if (const auto xi = is_bisected ? preimage_in_cell(corners, y) : newton(corners, y))
        return Vec<Dim>(grid_->cell_corner(leaf) + grid_->cell(leaf).side() * *xi);
    }
  return outside(y);
}

// Solves phi(c) + x - c = y for x outside the domain, c being its nearest point there, by Newton's method with the
// derivative of the side on which x lies, and halved steps.
template <int Dim>
std::optional<Vec<Dim>> InverseMap<Dim>::outside(const Vec<Dim>& y) const {
  const auto residual = [&](const Vec<Dim>& x, LocalPoint<Dim>& at, Corners<Dim>& corners) {
    const Vec<Dim> inside = x.cwiseMax(0.0).cwiseMin(1.0);
    at = locate_local(*grid_, inside);
    corners = corners_of(*grid_, phi_, at.cell);
    return Vec<Dim>(y - image(corners, at.xi) - (x - inside));
  };
  const double tolerance = 1e-13 * (1 + y.norm());
  Vec<Dim> x = y;
  LocalPoint<Dim> at;
  Corners<Dim> corners;
  Vec<Dim> r = residual(x, at, corners);
  for (int iteration = 0; iteration < 100; ++iteration) {
    if (r.norm() <= tolerance) return x;
    Mat<Dim> j = jacobian(corners, at.xi) / grid_->cell(at.cell).side();
    for (int k = 0; k < Dim; ++k)
      if (x[k] < 0 || x[k] > 1) j.col(k) = Vec<Dim>::Unit(k);
    const Vec<Dim> step = j.partialPivLu().solve(r);
    if (!step.allFinite()) return std::nullopt;
    double t = 1;
    Vec<Dim> trial = x, trial_r = r;
    for (; t > 1e-6; t /= 2) {
      trial = x + t * step;
      trial_r = residual(trial, at, corners);
      if (trial_r.norm() < (1 - 0.1 * t) * r.norm()) break;
    }
    if (t <= 1e-6) return std::nullopt;
    x = trial;
    r = trial_r;
  }
  return std::nullopt;
}

template class InverseMap<2>;
template class InverseMap<3>;

}  // namespace shellmatch
