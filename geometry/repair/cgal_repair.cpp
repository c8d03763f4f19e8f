// Consistent orientation through CGAL's Polygon Mesh Processing.
#include "geometry/repair/cgal_repair_mesh.h"
#include "geometry/repair/repair_steps.h"
#include "geometry/surface/facet_edges.h"

#include <CGAL/Polygon_mesh_processing/orient_polygon_soup.h>

namespace shellmatch {
namespace {

using Kernel = CgalKernel;

// Do two triangles with the same corners run the same way round? New copies of vertices count as the old.
bool same_turn(const std::array<Index, 3>& before, const std::array<std::size_t, 3>& after,
               const std::vector<Kernel::Point_3>& points) {
  const auto at = [&](Index v) { return points[static_cast<std::size_t>(v)]; };
  for (std::size_t k = 0; k < 3; ++k)
    if (points[after[k]] == at(before[0]))
      return points[after[(k + 1) % 3]] == at(before[1]) && points[after[(k + 2) % 3]] == at(before[2]);
  return false;
}

}  // namespace

Orientation orient_consistently(Surface<3>& surface) {
  if (is_oriented_manifold(surface.facets, surface.vertices.size())) return {};
  auto [points, triangles] = CgalSoup(surface);
  CGAL::Polygon_mesh_processing::orient_polygon_soup(points, triangles);
  Orientation result;
  result.n_split = points.size() - surface.vertices.size();
  for (std::size_t k = surface.vertices.size(); k < points.size(); ++k)
    surface.vertices.emplace_back(points[k].x(), points[k].y(), points[k].z());
  for (std::size_t t = 0; t < triangles.size(); ++t) {
    result.n_turned += same_turn(surface.facets[t], triangles[t], points) ? 0 : 1;
    for (std::size_t k = 0; k < 3; ++k) surface.facets[t][k] = static_cast<Index>(triangles[t][k]);
  }
  return result;
}

}  // namespace shellmatch
