#include "base/stop.h"
#include "geometry/repair/cgal_repair_mesh.h"
#include "geometry/repair/repair_steps.h"

#include <CGAL/Surface_mesh_simplification/Edge_collapse_visitor_base.h>
#include <CGAL/Surface_mesh_simplification/Policies/Edge_collapse/Edge_length_cost.h>
#include <CGAL/Surface_mesh_simplification/Policies/Edge_collapse/Midpoint_placement.h>
#include <CGAL/Surface_mesh_simplification/edge_collapse.h>
#include <CGAL/boost/graph/Euler_operations.h>
#include <CGAL/version.h>
#if CGAL_VERSION_NR >= 1050601000
#include <CGAL/Surface_mesh_simplification/Policies/Edge_collapse/Edge_count_stop_predicate.h>
#else
#include <CGAL/Surface_mesh_simplification/Policies/Edge_collapse/Count_stop_predicate.h>
#endif

#include <algorithm>
#include <cmath>

namespace shellmatch {

namespace {

namespace simplification = CGAL::Surface_mesh_simplification;

#if CGAL_VERSION_NR >= 1050601000
using StopAtEdges = simplification::Edge_count_stop_predicate<CgalMesh>;
#else
using StopAtEdges = simplification::Count_stop_predicate<CgalMesh>;
#endif

// Tells how far the collapses are, and stops them on request: each edge is taken up once, then edges go until enough
// have gone.
class CollapseVisitor : public simplification::Edge_collapse_visitor_base<CgalMesh> {
 public:
  CollapseVisitor(Activity& activity, std::size_t n_edges, std::size_t n_left)
      : activity_(activity), n_edges_(n_edges), n_left_(n_left) {}
  // The cost is optional, by Boost in CGAL 5 and by the standard library in CGAL 6.
  template <class Cost>
  void OnCollected(const Profile&, const Cost&) {
    count(++n_collected_);
  }
  template <class Cost>
  void OnSelected(const Profile&, const Cost&, std::size_t, std::size_t n_current) {
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

// A queue of all edges of a large mesh takes most of the time. As long as there are `many` times the vertices that are
// wanted, edges shorter than a length that grows from pass to pass go in the order of their numbers. Each vertex goes
// once in a pass, and no edge becomes much longer: one would else walk through the mesh and draw its edges after it.
class CollapsePasses {
 public:
  explicit CollapsePasses(CgalMesh& mesh) : mesh_(mesh) {}

  // Until there are at most so many vertices, or edges are `growth` to the power of `most_passes` as long.
  void run(std::size_t n_vertices) {
    const std::size_t n_before = mesh_.number_of_vertices();
    if (n_before <= n_vertices) return;
    Activity activity("simplifying", n_before - n_vertices);
    const auto n_slots = static_cast<CgalMesh::size_type>(mesh_.num_edges());
    double sum = 0;
    for (const auto e : mesh_.edges()) sum += std::sqrt(squared_length(e));
    double longest = growth * sum / static_cast<double>(n_slots);
    for (int pass = 0; pass < most_passes; ++pass, longest *= growth) {
      has_moved_.assign(mesh_.num_vertices(), false);
      for (CgalMesh::size_type i = 0; i < n_slots; ++i) {
        const CgalMesh::Edge_index e(i);
        if (i % 4096 == 0) activity.done(n_before - mesh_.number_of_vertices());
        if (mesh_.is_removed(e) || squared_length(e) >= longest * longest || !collapse(e, longest)) continue;
        if (mesh_.number_of_vertices() <= n_vertices) return;
      }
    }
  }

 private:
  static constexpr int most_passes = 24;
  static constexpr double growth = 1.3, stretch = 1.5;

  double squared_length(CgalMesh::Edge_index e) const {
    return CGAL::squared_distance(mesh_.point(mesh_.vertex(e, 0)), mesh_.point(mesh_.vertex(e, 1)));
  }

  // Would a facet at v, but for those at the other end, turn over, or have an edge that is longer than `most`?
  bool spoils(CgalMesh::Vertex_index v, CgalMesh::Vertex_index other, const CgalKernel::Point_3& middle,
              double most) const {
    for (const auto h : mesh_.halfedges_around_target(mesh_.halfedge(v))) {
      if (mesh_.is_border(h)) continue;
      const auto a = mesh_.source(h), b = mesh_.target(mesh_.next(h));
      if (a == other || b == other) continue;
      const auto &p = mesh_.point(a), &q = mesh_.point(b), &x = mesh_.point(v);
      if (CGAL::squared_distance(p, middle) > most * most || CGAL::squared_distance(q, middle) > most * most)
        return true;
      if (CGAL::cross_product(p - x, q - x) * CGAL::cross_product(p - middle, q - middle) <= 0) return true;
    }
    return false;
  }

  bool collapse(CgalMesh::Edge_index e, double longest) {
    const auto a = mesh_.vertex(e, 0), b = mesh_.vertex(e, 1);
    if (has_moved_[a.idx()] || has_moved_[b.idx()]) return false;
    const CgalKernel::Point_3 middle = CGAL::midpoint(mesh_.point(a), mesh_.point(b));
    // What lies on a border stays for the queue.
    if (CGAL::is_border(a, mesh_) || CGAL::is_border(b, mesh_) || spoils(a, b, middle, stretch * longest) ||
        spoils(b, a, middle, stretch * longest))
      return false;
    if (!CGAL::Euler::does_satisfy_link_condition(e, mesh_)) return false;
    const auto v = CGAL::Euler::collapse_edge(e, mesh_);
    mesh_.point(v) = middle;
    has_moved_[v.idx()] = true;
    return true;
  }

  CgalMesh& mesh_;
  std::vector<bool> has_moved_;  // in this pass
};

// So many times the vertices that are wanted are left to the queue.
constexpr std::size_t many = 4;

}  // namespace

Surface<3> simplified(const Surface<3>& surface, std::size_t n_vertices) {
  CgalMesh mesh = cgal_mesh(surface, surface.facets);
  if (mesh.number_of_vertices() > 2 * many * n_vertices) {
    CollapsePasses(mesh).run(many * n_vertices);
    mesh.collect_garbage();
  }
  // A closed triangle mesh has about three edges for each vertex.
  const std::size_t n_edges = mesh.number_of_edges(), n_left = std::min(3 * n_vertices, n_edges);
  const StopAtEdges stop(n_left);
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
