#pragma once
/// \file
/// Grids that the tests of this folder share.

#include "grid/octree/octree.h"

#include <functional>
#include <random>

namespace shellmatch::test {

/// A uniform grid of `start` whose leaves were split `steps` times, each with probability `share`.
template <int Dim>
Octree<Dim> random_grid(int start, int steps, double share, unsigned seed) {
  Octree<Dim> grid(start);
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> uniform(0, 1);
  for (int s = 0; s < steps; ++s) {
    // `mark` is called in parallel: draw first.
    std::vector<char> chosen(grid.n_cells(), 0);
    for (const Index leaf : grid.leaves()) chosen[leaf] = uniform(random) < share;
    grid.refine([&](Index leaf) { return chosen[leaf] != 0; });
  }
  return grid;
}

/// A uniform grid of `start` refined to `finest` wherever it may meet the surface of this distance.
template <int Dim>
Octree<Dim> shape_grid(int start, int finest, const std::function<double(const Vec<Dim>&)>& distance) {
  Octree<Dim> grid(start);
  for (int l = start; l < finest; ++l)
    grid.refine([&](Index leaf) {
      return std::abs(distance(grid.cell_centre(leaf))) <= 0.5 * std::sqrt(double(Dim)) * grid.cell(leaf).side();
    });
  return grid;
}

/// The same for a sphere.
template <int Dim>
Octree<Dim> sphere_grid(int start, int finest, double radius, const Vec<Dim>& centre) {
  return shape_grid<Dim>(start, finest, [=](const Vec<Dim>& x) { return (x - centre).norm() - radius; });
}

template <int Dim>
Vec<Dim> random_point(std::mt19937& random, double low = 0, double high = 1) {
  std::uniform_real_distribution<double> uniform(low, high);
  Vec<Dim> x;
  for (int k = 0; k < Dim; ++k) x[k] = uniform(random);
  return x;
}

}  // namespace shellmatch::test
