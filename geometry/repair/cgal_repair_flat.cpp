#include "geometry/repair/cgal_repair_mesh.h"
#include "geometry/repair/repair_steps.h"

#include <CGAL/Polygon_mesh_processing/repair_degeneracies.h>

namespace shellmatch {

bool remove_flat_triangles(Surface<3>& surface) {
  CgalMesh mesh = cgal_mesh(surface, surface.facets);
  if (mesh.number_of_faces() != surface.facets.size()) return false;
  if (!CGAL::Polygon_mesh_processing::remove_degenerate_faces(mesh)) return false;
  std::vector<Index> new_index(mesh.number_of_vertices() + mesh.number_of_removed_vertices(), no_index);
  Surface<3> mended;
  for (const auto face : mesh.faces()) {
    std::array<Index, 3> facet{};
    std::size_t k = 0;
    for (const auto v : mesh.vertices_around_face(mesh.halfedge(face))) {
      Index& index = new_index[v.idx()];
      if (index == no_index) {
        index = static_cast<Index>(mended.vertices.size());
        const CgalKernel::Point_3& p = mesh.point(v);
        mended.vertices.emplace_back(p.x(), p.y(), p.z());
      }
      facet[k++] = index;
    }
    mended.facets.push_back(facet);
  }
  surface = std::move(mended);
  return true;
}

}  // namespace shellmatch
