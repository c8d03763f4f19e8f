// The library used from another program: two meshes in; deformed vertices, map and summary out, as values.
// Sample output:
//   level 3 is done
//   level 4 is done
//   level 5 is done
//   1802 vertices moved, the north pole from z = 10.0 to 13.0
//   the centre, which is no vertex, moves from z = 0.0 to -1.8
//   mean distance 1e-04 there, 1e-04 back, in diagonals of the pear; 0 folded cells
#include "base/error.h"
#include "geometry/repair/make_shape.h"
#include "matching/match_shapes.h"

#include <cmath>
#include <cstdio>
#include <numbers>

using namespace shellmatch;

// A mesh as any program has it, vertices and polygons in its own unit: a globe of triangles at the poles and quads
// between, with every point moved by `shape`.
OriginalShape<3> globe(int n_rings, Vec<3> (*shape)(const Vec<3>&)) {
  OriginalShape<3> mesh;
  const Index n = 2 * n_rings;  // points of a ring
  const auto add = [&](double latitude, double longitude) {
    const double r = 10 * std::cos(latitude);
    mesh.vertices.push_back(shape({r * std::cos(longitude), r * std::sin(longitude), 10 * std::sin(latitude)}));
  };
  add(-std::numbers::pi / 2, 0);
  for (int ring = 1; ring <= n_rings; ++ring)
    for (Index k = 0; k < n; ++k) add(std::numbers::pi * (ring / (n_rings + 1.0) - 0.5), 2 * std::numbers::pi * k / n);
  add(std::numbers::pi / 2, 0);
  const Index north = n_rings * n + 1;
  for (Index k = 1, next; k <= n; ++k) {
    next = k % n + 1;
    mesh.polygons.push_back({0, next, k});
    for (Index low = 0; low + n + 1 < north; low += n)
      mesh.polygons.push_back({low + k, low + next, low + n + next, low + n + k});
    mesh.polygons.push_back({north, north - n - 1 + k, north - n - 1 + next});
  }
  return mesh;
}

// Told on the way; whoever returns false in iterated() stops the matching.
struct Progress : Observer {
  void minimisation_finished(const LevelStart& start, const MinimizerSummary&) override {
    if (start.substep == start.n_substeps) std::printf("level %d is done\n", start.level);
  }
};

int main() {
  try {
    const Shape<3> ball = make_shape(globe(30, [](const Vec<3>& x) { return x; }), "ball");
    const Shape<3> pear = make_shape(globe(45,
                                           [](const Vec<3>& x) -> Vec<3> {
                                             const double width = 1 - 0.03 * x.z();
                                             return {width * x.x(), width * x.y(), 1.3 * x.z()};
                                           }),
                                     "pear");

    ExperimentOptions options = profile_defaults(Profile::standard);  // docs/options.md lists them all
    options.cascade.max_level = 5;
    Progress progress;
    const MatchResult<3> result = match_shapes(ball, pear, options, progress);

    const Vec<3>& north = result.deformed.vertices.back();
    const Vec<3> centre = result.map.apply(Vec<3>::Zero());
    std::printf("%zu vertices moved, the north pole from z = 10.0 to %.1f\n", result.deformed.vertices.size(),
                north.z());
    std::printf("the centre, which is no vertex, moves from z = 0.0 to %.1f\n", centre.z());
    const MatchSummary& summary = result.summary;
    std::printf("mean distance %.0e there, %.0e back, in diagonals of the pear; %ld folded cells\n",
                summary.distance->deformed_to_template.mean, summary.distance->template_to_deformed.mean,
                static_cast<long>(summary.levels.back().folds.n_folded_cells));
    return summary.interrupted ? 1 : 0;
  } catch (const InputError& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
  }
}
