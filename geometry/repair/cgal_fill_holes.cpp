// Holes of a surface through CGAL's Polygon Mesh Processing.
#include "base/stop.h"
#include "geometry/repair/cgal_repair_mesh.h"
#include "geometry/repair/close_surface.h"

#include <CGAL/Polygon_mesh_processing/border.h>
#include <CGAL/Polygon_mesh_processing/orient_polygon_soup.h>
#include <CGAL/Polygon_mesh_processing/polygon_soup_to_polygon_mesh.h>
#include <CGAL/Polygon_mesh_processing/stitch_borders.h>
#include <CGAL/Polygon_mesh_processing/triangulate_hole.h>

#include <iterator>

namespace shellmatch {

namespace {

namespace PMP = CGAL::Polygon_mesh_processing;

// The search for the best triangles takes the third power of a hole's edges where the one among Delaunay triangles fails: that one alone is
// used beyond `most_searched`. Larger holes, and more edges in all, are not small ones.
constexpr std::size_t most_searched = 200, most_edges = 1200, most_edges_of_all = 20'000;

CgalMesh oriented_mesh(const Surface<3>& open) {
  CgalSoup soup(open);
  PMP::orient_polygon_soup(soup.points, soup.triangles);
  CgalMesh mesh;
  if (!PMP::is_polygon_soup_a_polygon_mesh(soup.triangles)) return mesh;
  PMP::polygon_soup_to_polygon_mesh(soup.points, soup.triangles, mesh);
  PMP::stitch_borders(mesh);
  mesh.collect_garbage();
  return mesh;
}

std::size_t length_of(CgalMesh::Halfedge_index begin, const CgalMesh& mesh) {
  std::size_t n = 0;
  for (CgalMesh::Halfedge_index h = begin; n == 0 || h != begin; h = mesh.next(h)) ++n;
  return n;
}

}  // namespace

std::optional<FilledHoles> fill_holes(const Surface<3>& open) try {
  CgalMesh mesh = oriented_mesh(open);
  const std::size_t n_before = mesh.number_of_faces();
  if (n_before == 0) return std::nullopt;
  std::vector<CgalMesh::Halfedge_index> holes;
  PMP::extract_boundary_cycles(mesh, std::back_inserter(holes));
  std::size_t n_edges = 0;
  for (const CgalMesh::Halfedge_index hole : holes) {
    const std::size_t length = length_of(hole, mesh);
    if (length > most_edges || (n_edges += length) > most_edges_of_all) return std::nullopt;
    stop_if_wanted();
    std::vector<CgalMesh::Face_index> patch;
    PMP::triangulate_hole(mesh, hole, std::back_inserter(patch), CGAL::parameters::do_not_use_cubic_algorithm(length > most_searched));
    if (patch.empty()) return std::nullopt;
  }
  if (!CGAL::is_closed(mesh)) return std::nullopt;
  FilledHoles filled{surface_of(mesh), holes.size(), mesh.number_of_faces() - n_before};
  double area = 0;
  for (std::size_t f = 0; f < filled.surface.facets.size(); ++f) {
    const double share = facet_measure(filled.surface, static_cast<Index>(f));
    area += share;
    if (f >= n_before) filled.new_share += share;
  }
  if (area > 0) filled.new_share /= area;
  return filled;
} catch (const CGAL::Failure_exception&) {  // what CGAL checks in every build
  return std::nullopt;
}

}  // namespace shellmatch
