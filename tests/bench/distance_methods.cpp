// Distances by fast marching against exact ones: errors and orders on uniform grids of a sphere and a torus, on both
// sides of the surface, and the time both take on the adaptive grids of a mesh.
//
// Usage: distance_methods [FINEST_LEVEL]        4 to 8; 7 if not given, as level 8 takes 6 GB and minutes

#include "geometry/generate/exact_shape.h"
#include "geometry/generate/generate_shape.h"
#include "geometry/distance/signed_distance.h"
#include "grid/octree/surface_cells.h"
#include "grid/fields/fast_marching.h"
#include "grid/fields/sample.h"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <string>

namespace {

using namespace shellmatch;

// The least of three, as others may use the machine.
double seconds_of(const auto& work) {
  double least = std::numeric_limits<double>::infinity();
  for (int i = 0; i < 3; ++i) {
    const auto begin = std::chrono::steady_clock::now();
    work();
    least = std::min(least, std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count());
  }
  return least;
}

std::string order(double before, double after) {
  return before > 0 ? fmt::format("{:.2f}", std::log2(before / after)) : std::string();
}

// Mean error inside and outside over the nodes at these distances from the surface.
void print_orders(const char* name, const ExactShape<3>& shape, double near, double far, int finest) {
  fmt::print("{}, nodes at distances {} to {}\n{:>6}{:>14}{:>8}{:>14}{:>8}\n", name, near, far, "level", "inside",
             "order", "outside", "order");
  std::array<double, 2> before{};
  for (int level = 4; level <= finest; ++level) {
    const Octree<3> grid(level);
    const auto marched = march_distance<3>(grid, shape.distance);
    std::array<double, 2> sum{}, n{};
    for (const Index node : grid.free_nodes()) {
      const double exact = shape.distance(grid.node_position(node));
      if (std::abs(exact) < near || std::abs(exact) > far) continue;
      sum[exact > 0] += std::abs(marched[node] - exact);
      n[exact > 0] += 1;
    }
    const std::array<double, 2> mean{sum[0] / n[0], sum[1] / n[1]};
    fmt::print("{:>6}{:>14.3g}{:>8}{:>14.3g}{:>8}\n", level, mean[0], order(before[0], mean[0]), mean[1],
               order(before[1], mean[1]));
    before = mean;
  }
}

void print_times(const std::string& name, int finest) {
  const auto original = std::get<OriginalShape<3>>(generate_shape(name));
  Surface<3> surface{original.vertices, {}};
  for (const auto& p : original.polygons) surface.facets.push_back({p[0], p[1], p[2]});
  const SignedDistance<3> distance(surface);
  fmt::print("{}, {} triangles, adaptive grids from level 3\n{:>6}{:>10}{:>10}{:>12}{:>8}{:>26}\n", name,
             surface.facets.size(), "level", "nodes", "exact s", "marching s", "ratio", "largest error/h in band");
  Octree<3> grid(3);
  for (int level = 3;; ++level) {
    std::vector<double> exact, marched;
    const double exact_seconds = seconds_of([&] { exact = sample_nodes<3>(grid, std::cref(distance)); });
    const double marched_seconds = seconds_of([&] { marched = march_distance<3>(grid, std::cref(distance)); });
    double worst = 0;
    for (const Index n : grid.free_nodes())
      if (std::abs(exact[n]) < 2 * grid.finest_side()) worst = std::max(worst, std::abs(exact[n] - marched[n]));
    fmt::print("{:>6}{:>10}{:>10.3f}{:>12.3f}{:>8.2f}{:>26.3f}\n", level, grid.n_nodes(), exact_seconds,
               marched_seconds, marched_seconds / exact_seconds, worst / grid.finest_side());
    if (level == finest) return;
    grid.refine([&](Index leaf) { return meets_surface<3>(grid, exact, std::cref(distance), leaf); });
  }
}

}  // namespace

int main(int argc, char** argv) {
  const int finest = argc > 1 ? std::atoi(argv[1]) : 7;
  if (argc > 2 || finest < 4 || finest > 8) {
    fmt::print(stderr, "usage: distance_methods [FINEST_LEVEL]   from 4 to 8\n");
    return 2;
  }
  const Vec<3> centre = Vec<3>::Constant(0.5);
  print_orders("sphere of radius 0.3", exact_ellipsoid<3>(Vec<3>::Constant(0.3), centre), 0.1, 0.2, finest);
  fmt::print("\n");
  print_orders("torus with radii 0.27 and 0.14", exact_torus(0.27, 0.14, centre), 0.08, 0.12, finest);
  for (const char* name : {"sphere", "hand"}) {
    fmt::print("\n");
    print_times(name, finest);
  }
}
