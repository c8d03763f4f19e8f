#pragma once
// A small problem for the examples: two outlines on a uniform grid of the unit square, and the energy there.
#include "geometry/generate/generate_shape.h"
#include "geometry/repair/make_shape.h"
#include "matching/level/level_energy.h"
#include "matching/level/shape_fields.h"

namespace example {

using namespace shellmatch;

inline SignedDistance<2> outline(const char* name, const char* variant) {
  return SignedDistance<2>(make_shape(std::get<OriginalShape<2>>(generate_shape(name, variant)), name).surface);
}

// A circle and an ellipse; cells of side 2^-level, no node of which hangs, until refine(): every node is an unknown.
struct SmallProblem {
  explicit SmallProblem(int grid_level) : grid(grid_level) { shapes.compute_distances(grid); }

  SignedDistance<2> reference = outline("circle", ""), target = outline("ellipse", "long");
  ExperimentOptions options = profile_defaults(Profile::standard);
  Octree<2> grid;
  ShapeFields<2> shapes{reference, target, options};
  std::vector<Vec<2>> identity = identity_map(grid);
  TermValues weights = term_weights(options.energy, 0.001, 0.2);  // nu and c_vol

  // At the shapes, by one level.
  void refine() {
    shapes.refine(grid);
    shapes.compute_distances(grid);
    identity = identity_map(grid);
  }
  LevelEnergy<2> level() { return LevelEnergy<2>(grid, shapes.geometry(grid), options); }
};

}  // namespace example
