#include "geometry/repair/cgal_repair_mesh.h"
#include "geometry/repair/simplify.h"

#include <CGAL/Surface_mesh_simplification/Policies/Edge_collapse/Count_stop_predicate.h>
#include <CGAL/Surface_mesh_simplification/Policies/Edge_collapse/Edge_length_cost.h>
#include <CGAL/Surface_mesh_simplification/Policies/Edge_collapse/Midpoint_placement.h>
#include <CGAL/Surface_mesh_simplification/edge_collapse.h>

namespace shellmatch {

Surface<3> simplified(const Surface<3>& surface, std::size_t n_vertices) {
  namespace simplification = CGAL::Surface_mesh_simplification;
  CgalMesh mesh = cgal_mesh(surface, surface.facets);
  // A closed triangle mesh has about three edges for each vertex.
  const simplification::Count_stop_predicate<CgalMesh> stop(3 * n_vertices);
  simplification::edge_collapse(mesh, stop,
                                CGAL::parameters::get_cost(simplification::Edge_length_cost<CgalMesh>())
                                    .get_placement(simplification::Midpoint_placement<CgalMesh>()));
  mesh.collect_garbage();
  Surface<3> result;
  for (const auto v : mesh.vertices()) {
    const auto& x = mesh.point(v);
    result.vertices.emplace_back(x.x(), x.y(), x.z());
  }
  for (const auto f : mesh.faces()) {
    std::array<Index, 3> corners;
    std::size_t k = 0;
    for (const auto v : mesh.vertices_around_face(mesh.halfedge(f))) corners[k++] = static_cast<Index>(v.idx());
    result.facets.push_back(corners);
  }
  return result;
}

}  // namespace shellmatch
