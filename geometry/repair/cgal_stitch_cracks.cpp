// Which vertices lie on which border edges is found by CGAL's intersection of boxes.
#include "base/disjoint_sets.h"
#include "geometry/repair/repair_steps.h"
#include "geometry/surface/facet_edges.h"

#include <CGAL/Bbox_3.h>
#include <CGAL/box_intersection_d.h>

#include <algorithm>
#include <map>
#include <utility>
#include <vector>

namespace shellmatch {

namespace {

using Facet = std::array<Index, 3>;
using Edge = std::pair<Index, Index>;  // the lower vertex first
using NearBox = CGAL::Box_intersection_d::Box_with_info_d<double, 3, Index>;

Edge edge_of(const Facet& facet, int k) { return std::minmax({facet[k], facet[(k + 1) % 3]}); }

// Edges with an odd number of triangles: those that the surface leaves open.
std::vector<Edge> border(const Surface<3>& surface) {
  std::vector<Edge> odd;
  for_each_edge(sorted_edges(surface.facets, surface.vertices.size()), [&](const FacetEdge* e, const FacetEdge* end) {
    if ((end - e) % 2 == 1) odd.emplace_back(e->low, e->high);
  });
  return odd;
}

std::vector<Index> vertices_of(const std::vector<Edge>& edges) {
  std::vector<Index> all;
  for (const auto& [a, b] : edges) {
    all.push_back(a);
    all.push_back(b);
  }
  std::sort(all.begin(), all.end());
  all.erase(std::unique(all.begin(), all.end()), all.end());
  return all;
}

NearBox box_around(const Vec<3>& a, const Vec<3>& b, double distance, Index info) {
  const Vec<3> low = a.cwiseMin(b).array() - distance, high = a.cwiseMax(b).array() + distance;
  return {CGAL::Bbox_3(low.x(), low.y(), low.z(), high.x(), high.y(), high.z()), info};
}

void weld_near(Surface<3>& surface, const std::vector<Index>& vertices, double distance) {
  std::vector<NearBox> boxes;
  for (const Index v : vertices)
    boxes.push_back(box_around(surface.vertices[v], surface.vertices[v], 0.5 * distance, v));
  DisjointSets sets(surface.vertices.size());
  CGAL::box_self_intersection_d(boxes.begin(), boxes.end(), [&](const NearBox& one, const NearBox& two) {
    if ((surface.vertices[one.info()] - surface.vertices[two.info()]).norm() <= distance)
      sets.join(one.info(), two.info());
  });
  for (Facet& facet : surface.facets)
    for (Index& v : facet) v = sets.find(v);
  std::erase_if(surface.facets, [](const Facet& f) { return f[0] == f[1] || f[1] == f[2] || f[2] == f[0]; });
}

// The border's vertices inside each of its edges, from the lower vertex to the higher.
std::map<Edge, std::vector<Index>> vertices_on(const Surface<3>& surface, const std::vector<Edge>& edges,
                                               double distance) {
  const std::vector<Vec<3>>& x = surface.vertices;
  std::vector<NearBox> edge_boxes, vertex_boxes;
  for (std::size_t e = 0; e < edges.size(); ++e)
    edge_boxes.push_back(box_around(x[edges[e].first], x[edges[e].second], distance, static_cast<Index>(e)));
  for (const Index v : vertices_of(edges)) vertex_boxes.push_back(box_around(x[v], x[v], 0, v));
  std::map<Edge, std::vector<std::pair<double, Index>>> found;
  const auto look = [&](const NearBox& one, const NearBox& two) {
    const Edge& edge = edges[one.info()];
    const Index v = two.info();
    if (v == edge.first || v == edge.second) return;
    const Vec<3> e = x[edge.second] - x[edge.first];
    const double t = (x[v] - x[edge.first]).dot(e) / e.squaredNorm();
    if (t > 0 && t < 1 && (x[edge.first] + t * e - x[v]).norm() <= distance) found[edge].emplace_back(t, v);
  };
  CGAL::box_intersection_d(edge_boxes.begin(), edge_boxes.end(), vertex_boxes.begin(), vertex_boxes.end(), look);
  std::map<Edge, std::vector<Index>> result;
  for (auto& [edge, points] : found) {
    std::sort(points.begin(), points.end());
    for (const auto& [t, v] : points) result[edge].push_back(v);
  }
  return result;
}

// Splits triangles at the vertices on their edges, one at a time.
void split(Surface<3>& surface, std::map<Edge, std::vector<Index>> on_edge) {
  std::vector<Facet> todo = std::move(surface.facets);
  surface.facets.clear();
  std::reverse(todo.begin(), todo.end());  // taken from the end: whole triangles keep their order
  while (!todo.empty()) {
    const Facet facet = todo.back();
    todo.pop_back();
    int k = 0;
    auto at = on_edge.end();
    for (; k < 3; ++k) {
      at = on_edge.find(edge_of(facet, k));
      if (at != on_edge.end() && std::ranges::find(facet, at->second.front()) == facet.end()) break;
    }
    if (k == 3) {
      surface.facets.push_back(facet);
      continue;
    }
    const auto [edge, points] = *at;
    const Index v = points.front(), c = facet[(k + 2) % 3];
    std::vector<Index> rest(points.begin() + 1, points.end());
    if (v > edge.second) std::reverse(rest.begin(), rest.end());
    if (!rest.empty()) on_edge[std::minmax({v, edge.second})] = std::move(rest);
    todo.push_back({facet[k], v, c});
    todo.push_back({v, facet[(k + 1) % 3], c});
  }
}

}  // namespace

std::size_t stitch_cracks(Surface<3>& surface, double distance) {
  const std::vector<Edge> before = border(surface);
  if (before.empty()) return 0;
  Surface<3> stitched = surface;
  weld_near(stitched, vertices_of(before), distance);
  split(stitched, vertices_on(stitched, border(stitched), distance));
  const auto length = [](const Surface<3>& s, const std::vector<Edge>& edges) {
    double sum = 0;
    for (const auto& [a, b] : edges) sum += (s.vertices[a] - s.vertices[b]).norm();
    return sum;
  };
  const std::vector<Edge> after = border(stitched);
  if (!(length(stitched, after) < (1 - 1e-9) * length(surface, before))) return 0;
  surface = std::move(stitched);
  return before.size() - std::min(before.size(), after.size());
}

}  // namespace shellmatch
