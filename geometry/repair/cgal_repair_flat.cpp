#include "geometry/repair/cgal_repair_mesh.h"
#include "geometry/repair/repair_steps.h"

#include <CGAL/Polygon_mesh_processing/repair_degeneracies.h>

#include <algorithm>
#include <utility>

namespace shellmatch {
namespace {

// Flips may fold two triangles onto each other, with the same corners and opposite normals: both go. Returns whether every edge
// then runs once in each direction.
bool unfold(Triangles& facets) {
  const auto corners = [](std::array<Index, 3> facet) {
    std::sort(facet.begin(), facet.end());
    return facet;
  };
  const auto is_even = [](const std::array<Index, 3>& f) { return (f[0] < f[1]) + (f[1] < f[2]) + (f[2] < f[0]) == 2; };
  std::vector<std::size_t> order(facets.size());
  for (std::size_t f = 0; f < order.size(); ++f) order[f] = f;
  std::stable_sort(order.begin(), order.end(), [&](std::size_t f, std::size_t g) { return corners(facets[f]) < corners(facets[g]); });
  std::vector<bool> goes(facets.size(), false);
  for (std::size_t i = 1; i < order.size(); ++i) {
    const std::size_t f = order[i - 1], g = order[i];
    if (!goes[f] && corners(facets[f]) == corners(facets[g]) && is_even(facets[f]) != is_even(facets[g])) goes[f] = goes[g] = true;
  }
  Triangles kept;
  for (std::size_t f = 0; f < facets.size(); ++f)
    if (!goes[f]) kept.push_back(facets[f]);
  facets = std::move(kept);
  std::vector<std::pair<Index, Index>> edges, reverse;
  for (const auto& facet : facets)
    for (std::size_t k = 0; k < 3; ++k) {
      edges.emplace_back(facet[k], facet[(k + 1) % 3]);
      reverse.emplace_back(facet[(k + 1) % 3], facet[k]);
    }
  std::sort(edges.begin(), edges.end());
  std::sort(reverse.begin(), reverse.end());
  return edges == reverse && std::adjacent_find(edges.begin(), edges.end()) == edges.end();
}

}  // namespace

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
  return unfold(surface.facets);
}

}  // namespace shellmatch
