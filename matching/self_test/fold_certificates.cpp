#include "matching/self_test/self_test.h"

#include <Eigen/LU>

#include <algorithm>
#include <cmath>
#include <random>

namespace shellmatch {

namespace {

constexpr double test_side = 0.25;

// det Dphi at a point xi of the unit cell, by the derivatives of the multilinear shape functions.
template <int Dim>
double determinant_at(const Element<Dim>& cell, std::span<const Vec<Dim>> phi, const Vec<Dim>& xi) {
  Mat<Dim> j = Mat<Dim>::Zero();
  for (int c = 0; c < n_corners<Dim>; ++c)
    for (int k = 0; k < Dim; ++k) {
      double slope = (c >> k & 1) != 0 ? 1 : -1;
      for (int m = 0; m < Dim; ++m)
        if (m != k) slope *= (c >> m & 1) != 0 ? xi[m] : 1 - xi[m];
      j.col(k) += slope / cell.side * phi[cell.nodes[c]];
    }
  return j.determinant();
}

template <int Dim>
double least_sampled(const Element<Dim>& cell, std::span<const Vec<Dim>> phi) {
  constexpr int n = 5;
  double least = determinant_at<Dim>(cell, phi, Vec<Dim>::Zero());
  for (int i = 0; i < (Dim == 2 ? n * n : n * n * n); ++i) {
    Vec<Dim> xi;
    for (int k = 0, rest = i; k < Dim; ++k, rest /= n) xi[k] = rest % n / double(n - 1);
    least = std::min(least, determinant_at<Dim>(cell, phi, xi));
  }
  return least;
}

}  // namespace

template <int Dim>
std::vector<SelfCheck> check_fold_certificates(const BoundsOfDeterminants<Dim>& bounds) {
  constexpr int n_cells = 4000, n = n_corners<Dim>;
  std::mt19937_64 random(2);
  std::uniform_real_distribution<double> unit(-1, 1);
  std::vector<Element<Dim>> cells(n_cells);
  std::vector<Vec<Dim>> phi;
  std::vector<double> affine(n_cells, std::nan(""));  // det Dphi of the cells whose map is affine
  for (int i = 0; i < n_cells; ++i) {
    const auto any_vector = [&] { return Vec<Dim>(Vec<Dim>::NullaryExpr([&] { return unit(random); })); };
    const Mat<Dim> map = Mat<Dim>::Identity() + 0.5 * Mat<Dim>::NullaryExpr([&] { return unit(random); });
    // Every third cell is moved by an affine map; the others have their corners moved, too, as far as to fold.
    const double amplitude = i % 3 == 0 ? 0 : 0.6 * test_side;
    if (i % 3 == 0) affine[i] = map.determinant();
    cells[i].side = test_side;
    for (int c = 0; c < n; ++c) {
      Vec<Dim> x;
      for (int k = 0; k < Dim; ++k) x[k] = test_side * (c >> k & 1);
      cells[i].nodes[c] = static_cast<Index>(phi.size());
      phi.push_back(map * x + amplitude * any_vector());
    }
  }
  const std::span<const Vec<Dim>> at = phi;
  const auto found = bounds(cells, at);
  double n_wrong = 0, n_missed = 0, affine_error = 0, n_folded = 0;
  for (int i = 0; i < n_cells; ++i) {
    const double sampled = least_sampled<Dim>(cells[i], at);
    n_folded += sampled <= 0;
    n_wrong += !(found[i].bound <= sampled + 1e-12);
    n_missed += found[i].bound > 0 && sampled <= 0;
    if (i % 3 == 0) affine_error = std::max(affine_error, std::abs(found[i].bound - affine[i]));
  }
  const double share = n_folded / n_cells;
  return {{"", "cells whose bound is above a value of det Dphi", n_wrong, 0},
          {"", "folded cells that are certified", n_missed, 0},
          {"", "bound against det Dphi of affine maps", affine_error, 1e-12},
          {"", "share of folded cells, against a half", std::abs(share - 0.5), 0.45}};
}

SHELLMATCH_2D_3D(check_fold_certificates);

}  // namespace shellmatch
