#include "base/stop.h"
#include "geometry/repair/cgal_repair_mesh.h"
#include "geometry/repair/simplify.h"

#include <CGAL/Surface_mesh_simplification/Edge_collapse_visitor_base.h>
#include <CGAL/Surface_mesh_simplification/Policies/Edge_collapse/Count_stop_predicate.h>
#include <CGAL/Surface_mesh_simplification/Policies/Edge_collapse/Edge_length_cost.h>
#include <CGAL/Surface_mesh_simplification/Policies/Edge_collapse/Midpoint_placement.h>
#include <CGAL/Surface_mesh_simplification/edge_collapse.h>

#include <algorithm>

namespace shellmatch {

namespace {

namespace simplification = CGAL::Surface_mesh_simplification;

// Tells how far the collapses are, and stops them on request: each edge is taken up once, then edges go until enough have gone.
class CollapseVisitor : public simplification::Edge_collapse_visitor_base<CgalMesh> {
 public:
  CollapseVisitor(Activity& activity, std::size_t n_edges, std::size_t n_left) : activity_(activity), n_edges_(n_edges), n_left_(n_left) {}
  void OnCollected(const Profile&, const boost::optional<FT>&) { count(++n_collected_); }
  void OnSelected(const Profile&, const boost::optional<FT>&, std::size_t, std::size_t n_current) {
    count(n_edges_ + share_of_collapses * (n_edges_ - std::max(n_current, n_left_)));
  }
  // A collapse takes about so many times as long as taking an edge up.
  static constexpr std::size_t share_of_collapses = 4;

 private:
  void count(std::size_t n) {
    if (n_calls_++ % 1024 == 0) activity_.done(n);
  }
  Activity& activity_;
  std::size_t n_edges_, n_left_, n_collected_ = 0, n_calls_ = 0;
};

}  // namespace

Surface<3> simplified(const Surface<3>& surface, std::size_t n_vertices) {
  CgalMesh mesh = cgal_mesh(surface, surface.facets);
  // A closed triangle mesh has about three edges for each vertex.
  const std::size_t n_edges = mesh.number_of_edges(), n_left = std::min(3 * n_vertices, n_edges);
  const simplification::Count_stop_predicate<CgalMesh> stop(n_left);
  Activity simplifying("simplifying", n_edges + CollapseVisitor::share_of_collapses * (n_edges - n_left));
  CollapseVisitor visitor(simplifying, n_edges, n_left);
  simplification::edge_collapse(mesh, stop,
                                CGAL::parameters::get_cost(simplification::Edge_length_cost<CgalMesh>())
                                    .get_placement(simplification::Midpoint_placement<CgalMesh>())
                                    .visitor(visitor));
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
