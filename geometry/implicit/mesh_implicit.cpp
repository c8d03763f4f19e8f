#include "geometry/implicit/mesh_implicit.h"

#include "base/error.h"
#include "base/parallel.h"
#include "geometry/implicit/lattice.h"
#include "geometry/implicit/mesh_quality.h"

namespace shellmatch {

Surface<3> mesh_implicit(const ImplicitFunction& f, double edge_length, std::string_view name) {
  // The average edge is 0.78 times the spacing of the lattice. Where two sheets of the surface are close, the
  // lattice may connect them; slightly finer lattices are then tried.
  Surface<3> surface;
  bool closed = false;
  for (const double finer : {1.0, 0.93, 0.86, 0.8}) {
    surface = triangulate_on_lattice(f, finer * edge_length / 0.78);
    closed = is_closed_manifold(surface);
    if (closed) break;
  }
  const Box<3> box = bounding_box(surface.vertices);
  if (!surface.vertices.empty() && (box.min.minCoeff() < 0.05 || box.max.maxCoeff() > 0.95))
    throw_input_error("{}: with these parameters the body leaves [0.05, 0.95]^3; choose less extreme ones",
                      name);
  if (!closed)
    throw_input_error(
        "{}: an edge length of {:g} is too coarse for the details of this body; choose a smaller one", name,
        edge_length);
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
