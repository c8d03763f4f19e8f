// Holes of a surface through CGAL's Polygon Mesh Processing.
#include "base/stop.h"
#include "geometry/repair/cgal_repair_mesh.h"
#include "geometry/repair/close_surface.h"
#include "geometry/surface/facet_edges.h"
#include "geometry/surface/topology.h"

#include <CGAL/Polygon_mesh_processing/orient_polygon_soup.h>
#include <CGAL/Polygon_mesh_processing/polygon_soup_to_polygon_mesh.h>
#include <CGAL/Polygon_mesh_processing/stitch_borders.h>
#include <CGAL/Polygon_mesh_processing/triangulate_hole.h>
#include <CGAL/version.h>
#if __has_include(<CGAL/boost/graph/border.h>)
#include <CGAL/boost/graph/border.h>
#else
#include <CGAL/Polygon_mesh_processing/border.h>
#endif

#include <iterator>
#include <utility>
#include <vector>

namespace shellmatch {

namespace {

namespace PMP = CGAL::Polygon_mesh_processing;
// CGAL 6.2 moves the cycles of a border, and its old header makes stitch_borders() ambiguous.
#if __has_include(<CGAL/boost/graph/border.h>)
namespace borders = CGAL;
#else
namespace borders = PMP;
#endif

// The search for the best triangles takes the third power of a hole's edges where the one among Delaunay triangles
// fails: that one alone is used beyond `most_searched`. It takes seconds for some thousand edges.
constexpr std::size_t most_searched = 200, most_edges = 10'000, most_edges_of_all = 100'000;

// Counts the edges of holes, and says whether they can be filled.
class EdgeBudget {
 public:
  bool allows(std::size_t length) { return length <= most_edges && (n_ += length) <= most_edges_of_all; }

 private:
  std::size_t n_ = 0;
};

// CGAL's is_polygon_soup_a_polygon_mesh(), which takes a quarter of the time of reading a scan.
bool is_mesh(const CgalSoup& soup) {
  std::vector<std::array<Index, 3>> facets;
  facets.reserve(soup.triangles.size());
  for (const auto& [a, b, c] : soup.triangles)
    facets.push_back({static_cast<Index>(a), static_cast<Index>(b), static_cast<Index>(c)});
  return is_oriented_manifold(facets, soup.points.size(), Border::allowed);
}

CgalMesh oriented_mesh(const Surface<3>& open) {
  CgalSoup soup(open);
  CgalMesh mesh;
  if (!is_oriented_manifold(open.facets, open.vertices.size(), Border::allowed)) {
    PMP::orient_polygon_soup(soup.points, soup.triangles);
    if (!is_mesh(soup)) return mesh;
  }
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

// Fills the hole and returns its triangles; none where that fails.
std::vector<CgalMesh::Face_index> fill_hole(CgalMesh& mesh, CgalMesh::Halfedge_index hole, bool quickly) {
  std::vector<CgalMesh::Face_index> patch;
#if CGAL_VERSION_NR >= 1050601000
  PMP::triangulate_hole(
      mesh, hole,
      CGAL::parameters::do_not_use_cubic_algorithm(quickly).face_output_iterator(std::back_inserter(patch)));
#else
  PMP::triangulate_hole(mesh, hole, std::back_inserter(patch), CGAL::parameters::do_not_use_cubic_algorithm(quickly));
#endif
  return patch;
}

FilledHoles with_share(FilledHoles filled) {
  const std::size_t n_before = filled.surface.facets.size() - filled.n_new;
  double area = 0;
  for (std::size_t f = 0; f < filled.surface.facets.size(); ++f) {
    const double measure = facet_measure(filled.surface, static_cast<Index>(f));
    area += measure;
    if (f >= n_before) filled.new_share += measure;
  }
  if (area > 0) filled.new_share /= area;
  return filled;
}

// By the loops alone, without a mesh of CGAL's: patches may then have an edge that is there, so that the result is not
// closed.
std::optional<FilledHoles> fill_loops(const Surface<3>& open) {
  const std::optional<std::vector<BorderLoop>> loops = border_loops(open);
  if (!loops || loops->empty()) return std::nullopt;
  FilledHoles filled{open, loops->size()};
  EdgeBudget budget;
  const auto points = [&](const std::vector<Index>& vertices) {
    std::vector<CgalKernel::Point_3> result;
    for (const Index v : vertices)
      result.emplace_back(open.vertices[v].x(), open.vertices[v].y(), open.vertices[v].z());
    return result;
  };
  for (const BorderLoop& loop : *loops) {
    const std::size_t length = loop.vertices.size();
    if (!budget.allows(length)) return std::nullopt;
    stop_if_wanted();
    std::vector<CGAL::Triple<int, int, int>> patch;
    PMP::triangulate_hole_polyline(points(loop.vertices), points(loop.opposite), std::back_inserter(patch),
                                   CGAL::parameters::do_not_use_cubic_algorithm(length > most_searched));
    if (patch.empty()) return std::nullopt;
    for (const auto& t : patch)
      filled.surface.facets.push_back({loop.vertices[t.first], loop.vertices[t.second], loop.vertices[t.third]});
  }
  filled.n_new = filled.surface.facets.size() - open.facets.size();
  if (!is_oriented_manifold(filled.surface.facets, filled.surface.vertices.size())) return std::nullopt;
  return with_share(std::move(filled));
}

std::optional<FilledHoles> fill_mesh(const Surface<3>& open) {
  CgalMesh mesh = oriented_mesh(open);
  const std::size_t n_before = mesh.number_of_faces();
  if (n_before == 0) return std::nullopt;
  std::vector<CgalMesh::Halfedge_index> holes;
  borders::extract_boundary_cycles(mesh, std::back_inserter(holes));
  EdgeBudget budget;
  for (const CgalMesh::Halfedge_index hole : holes) {
    const std::size_t length = length_of(hole, mesh);
    if (!budget.allows(length)) return std::nullopt;
    stop_if_wanted();
    if (fill_hole(mesh, hole, length > most_searched).empty()) return std::nullopt;
  }
  if (!CGAL::is_closed(mesh)) return std::nullopt;
  return with_share({surface_of(mesh), holes.size(), mesh.number_of_faces() - n_before});
}

}  // namespace

std::optional<FilledHoles> fill_holes(const Surface<3>& open) try {
  if (std::optional<FilledHoles> filled = fill_loops(open)) return filled;
  return fill_mesh(open);
} catch (const CGAL::Failure_exception&) {  // what CGAL checks in every build
  return std::nullopt;
}

}  // namespace shellmatch
