#include "geometry/surface/topology.h"

#include "base/disjoint_sets.h"
#include "geometry/surface/facet_edges.h"

#include <vector>

namespace shellmatch {

namespace {

std::size_t count_edges(const Surface<3>& s) {
  std::size_t n = 0;
  for_each_edge(sorted_edges(s.facets, s.vertices.size()), [&](const FacetEdge*, const FacetEdge*) { ++n; });
  return n;
}

}  // namespace

template <int Dim>
Topology topology(const Surface<Dim>& s) {
  DisjointSets sets(s.vertices.size());
  std::vector<bool> used(s.vertices.size());
  for (const auto& facet : s.facets)
    for (const Index v : facet) {
      used[v] = true;
      sets.join(v, facet[0]);
    }
  Topology result;
  for (Index v = 0; v < static_cast<Index>(s.vertices.size()); ++v)
    if (used[v]) {
      ++result.n_vertices;
      result.n_components += sets.find(v) == v;
    }
  if constexpr (Dim == 3) {
    const long euler = static_cast<long>(result.n_vertices + s.facets.size()) - static_cast<long>(count_edges(s));
    result.genus = static_cast<int>(static_cast<long>(result.n_components) - euler / 2);
  }
  return result;
}

template Topology topology(const Surface<2>&);
template Topology topology(const Surface<3>&);

}  // namespace shellmatch
