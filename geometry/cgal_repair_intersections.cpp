#include "geometry/cgal_repair_mesh.h"
#include "geometry/repair_steps.h"

#include <CGAL/Polygon_mesh_processing/self_intersections.h>

namespace shellmatch {

std::size_t count_self_intersections(const Surface<3>& surface) {
  const CgalMesh mesh = cgal_mesh(surface, surface.facets);
  std::vector<std::pair<CgalMesh::Face_index, CgalMesh::Face_index>> pairs;
  CGAL::Polygon_mesh_processing::self_intersections(mesh, std::back_inserter(pairs));
  return pairs.size();
}

}  // namespace shellmatch
