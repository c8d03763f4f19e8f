#include "geometry/implicit/mesh_implicit.h"

#include "base/error.h"
#include "base/parallel.h"
#include "geometry/implicit/lattice.h"
#include "geometry/implicit/mesh_quality.h"

#include <vector>

namespace shellmatch {

namespace {

// Lattice points that were moved onto the surface where two sheets of it are close have joined these; they are left
// where they were.
Surface<3> closed_in_any_case(const ImplicitFunction& f, double spacing) {
  Lattice lattice(f, spacing);
  for (int round = 0; round < 12; ++round) {
    Surface<3> surface = lattice.triangulate();
    std::vector<Vec<3>> places;
    for (const Index v : vertices_without_a_fan(surface)) places.push_back(surface.vertices[v]);
    if (places.empty()) return surface;
    lattice.keep_points_near(places);
  }
  lattice.keep_all_points();
  return lattice.triangulate();
}

}  // namespace

Surface<3> mesh_implicit(const ImplicitFunction& f, double edge_length, std::string_view name, Details details) {
  // The average edge is 0.78 times the spacing of the lattice. Where two sheets of the surface are close, the
  // lattice may connect them; slightly finer lattices are then tried.
  Surface<3> surface;
  bool closed = false;
  for (const double finer : {1.0, 0.93, 0.86, 0.8}) {
    surface = Lattice(f, finer * edge_length / 0.78).triangulate();
    closed = is_closed_manifold(surface);
    if (closed) break;
  }
  if (!closed && details == Details::as_they_come) {
    surface = closed_in_any_case(f, edge_length / 0.78);
    closed = is_closed_manifold(surface);
  }
  const Box<3> box = bounding_box(surface.vertices);
  if (!surface.vertices.empty() && (box.min.minCoeff() < 0.05 || box.max.maxCoeff() > 0.95))
    throw_input_error("{}: with these parameters the body leaves [0.05, 0.95]^3; choose less extreme ones", name);
  if (!closed)
    throw_input_error("{}: an edge length of {:g} is too coarse for the details of this body; choose a smaller one",
                      name, edge_length);
  const auto project = [&](std::size_t v) { surface.vertices[v] = project_to_zero(f, surface.vertices[v]); };
  parallel_for(surface.vertices.size(), project);
  for (int round = 0; round < 3; ++round) {
    swap_to_delaunay(surface);
    smooth_tangentially(f, 2, surface);
  }
  parallel_for(surface.vertices.size(), project);
  swap_to_delaunay(surface);
  return surface;
}

}  // namespace shellmatch
