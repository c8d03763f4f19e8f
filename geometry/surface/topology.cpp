#include "geometry/surface/topology.h"

#include "base/disjoint_sets.h"
#include "geometry/surface/facet_edges.h"

#include <utility>
#include <vector>

namespace shellmatch {

std::optional<std::vector<BorderLoop>> border_loops(const Surface<3>& surface) {
  // Against the direction of the facets: what fills a hole runs through its edges the other way.
  struct Way {
    Index next = no_index, opposite = no_index;
  };
  std::vector<Way> ways(surface.vertices.size());
  std::vector<Index> starts;
  bool is_simple = true;
  const auto corner = [&](const FacetEdge& e, int k) { return surface.facets[e.facet][(e.begin + k) % 3]; };
  for_each_edge(sorted_edges(surface.facets, surface.vertices.size()),
                [&](const FacetEdge* begin, const FacetEdge* end) {
                  if (end - begin == 2 && corner(begin[0], 0) != corner(begin[1], 0)) return;
                  is_simple = is_simple && end - begin == 1 && ways[corner(*begin, 1)].next == no_index;
                  if (!is_simple) return;
                  ways[corner(*begin, 1)] = {corner(*begin, 0), corner(*begin, 2)};
                  starts.push_back(corner(*begin, 1));
                });
  if (!is_simple) return std::nullopt;
  std::vector<BorderLoop> loops;
  for (const Index start : starts) {
    if (ways[start].next == no_index) continue;  // of a loop before
    BorderLoop& loop = loops.emplace_back();
    for (Index v = start; ways[v].next != no_index;) {
      loop.vertices.push_back(v);
      loop.opposite.push_back(ways[v].opposite);
      v = std::exchange(ways[v].next, no_index);
      if (ways[v].next == no_index && v != start) return std::nullopt;
    }
  }
  return loops;
}

template <int Dim>
Topology topology(const Surface<Dim>& s, double least_share) {
  DisjointSets sets(s.vertices.size());
  for (const auto& facet : s.facets)
    for (const Index v : facet) sets.join(v, facet[0]);
  std::vector<double> area(s.vertices.size(), 0.0);  // of the component for which a vertex stands
  double total = 0;
  for (std::size_t f = 0; f < s.facets.size(); ++f) {
    const double share = facet_measure(s, static_cast<Index>(f));
    area[sets.find(s.facets[f][0])] += share;
    total += share;
  }
  const auto counts = [&](const auto& facet) { return !(area[sets.find(facet[0])] < least_share * total); };
  std::vector<bool> used(s.vertices.size());
  std::size_t n_facets = 0;
  for (const auto& facet : s.facets)
    if (counts(facet)) {
      ++n_facets;
      for (const Index v : facet) used[v] = true;
    }
  Topology result;
  for (Index v = 0; v < static_cast<Index>(s.vertices.size()); ++v)
    if (used[v]) {
      ++result.n_vertices;
      result.n_components += sets.find(v) == v;
    }
  if constexpr (Dim == 3) {
    std::size_t n_edges = 0;
    for_each_edge(sorted_edges(s.facets, s.vertices.size()),
                  [&](const FacetEdge* edge, const FacetEdge*) { n_edges += counts(s.facets[edge->facet]); });
    const long euler = static_cast<long>(result.n_vertices + n_facets) - static_cast<long>(n_edges);
    result.genus = static_cast<int>(static_cast<long>(result.n_components) - euler / 2);
  }
  return result;
}

SHELLMATCH_2D_3D(topology);

}  // namespace shellmatch
