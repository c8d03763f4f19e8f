#include "alignment/spectrum/edge_graph.h"

#include "base/parallel.h"

#include <algorithm>
#include <limits>
#include <queue>
#include <tuple>
#include <unordered_set>

namespace shellmatch {

EdgeGraph::EdgeGraph(const Surface<3>& surface) : begin_(surface.vertices.size() + 1, 0) {
  std::vector<std::pair<Index, Index>> pairs;
  pairs.reserve(6 * surface.facets.size());
  for (const auto& facet : surface.facets)
    for (int k = 0; k < 3; ++k) {
      pairs.emplace_back(facet[k], facet[(k + 1) % 3]);
      pairs.emplace_back(facet[(k + 1) % 3], facet[k]);
    }
  std::sort(pairs.begin(), pairs.end());
  pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
  edges_.reserve(pairs.size());
  for (const auto& [from, to] : pairs) {
    ++begin_[from + 1];
    edges_.push_back({to, (surface.vertices[from] - surface.vertices[to]).norm()});
  }
  for (std::size_t v = 1; v < begin_.size(); ++v) begin_[v] += begin_[v - 1];
}

double EdgeGraph::mean_edge_length() const {
  double sum = 0;
  for (const Edge& edge : edges_) sum += edge.length;
  return edges_.empty() ? 0 : sum / static_cast<double>(edges_.size());
}

// Dijkstra's algorithm: vertices are final in the order of their distances.
void EdgeGraph::lower_distances_up_to(Index goal, Index source, std::vector<double>& distances) const {
  using Entry = std::pair<double, Index>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> open;
  distances[source] = 0;
  open.emplace(0, source);
  while (!open.empty()) {
    const auto [distance, v] = open.top();
    open.pop();
    if (v == goal) return;
    if (distance > distances[v]) continue;
    for (std::size_t e = begin_[v]; e < begin_[v + 1]; ++e) {
      const double next = distance + edges_[e].length;
      if (next >= distances[edges_[e].to]) continue;
      distances[edges_[e].to] = next;
      open.emplace(next, edges_[e].to);
    }
  }
}

void EdgeGraph::for_each_within(Index source, double reach, const std::function<bool(Index, double)>& f) const {
  using Entry = std::pair<double, Index>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> open;
  std::unordered_set<Index> done;
  for (open.emplace(0, source); !open.empty();) {
    const auto [distance, v] = open.top();
    open.pop();
    if (!done.insert(v).second) continue;
    if (!f(v, distance)) return;
    for (std::size_t e = begin_[v]; e < begin_[v + 1]; ++e)
      if (const double next = distance + edges_[e].length; next < reach && !done.contains(edges_[e].to))
        open.emplace(next, edges_[e].to);
  }
}

void EdgeGraph::lower_distances(Index source, std::vector<double>& distances) const {
  lower_distances_up_to(no_index, source, distances);
}

std::vector<std::size_t> EdgeGraph::nearest_of(const std::vector<Index>& sources, double reach) const {
  using Entry = std::tuple<double, std::size_t, Index>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> open;
  std::vector<std::size_t> nearest(n_vertices(), none);
  for (std::size_t k = 0; k < sources.size(); ++k) open.emplace(0, k, sources[k]);
  while (!open.empty()) {
    const auto [distance, source, v] = open.top();
    open.pop();
    if (nearest[v] != none) continue;
    nearest[v] = source;
    for (std::size_t e = begin_[v]; e < begin_[v + 1]; ++e)
      if (const double next = distance + edges_[e].length; next < reach && nearest[edges_[e].to] == none)
        open.emplace(next, source, edges_[e].to);
  }
  return nearest;
}

double EdgeGraph::distance(Index source, Index goal) const {
  std::vector<double> distances(n_vertices(), infinity);
  lower_distances_up_to(goal, source, distances);
  return distances[goal];
}

std::vector<double> EdgeGraph::distances_from(Index source) const {
  std::vector<double> distances(n_vertices(), std::numeric_limits<double>::infinity());
  lower_distances(source, distances);
  return distances;
}

std::vector<Index> farthest_point_samples(const EdgeGraph& graph, Index first, std::size_t n) {
  std::vector<Index> samples;
  std::vector<double> distances(graph.n_vertices(), std::numeric_limits<double>::infinity());
  for (Index next = first; samples.size() < std::min(n, graph.n_vertices());) {
    samples.push_back(next);
    graph.lower_distances(next, distances);
    next = static_cast<Index>(std::max_element(distances.begin(), distances.end()) - distances.begin());
  }
  return samples;
}

NeighbourLists nearest_along(const EdgeGraph& graph, const std::vector<Index>& vertices, std::size_t n) {
  constexpr std::size_t none = std::numeric_limits<std::size_t>::max();
  std::vector<std::size_t> place(graph.n_vertices(), none);
  for (std::size_t i = 0; i < vertices.size(); ++i) place[vertices[i]] = i;
  NeighbourLists nearest(vertices.size());
  parallel_for(vertices.size(), [&](std::size_t i) {
    graph.for_each_within(vertices[i], std::numeric_limits<double>::infinity(), [&](Index v, double distance) {
      if (place[v] != none && place[v] != i) nearest[i].emplace_back(distance, place[v]);
      return nearest[i].size() < n;
    });
  });
  return nearest;
}

}  // namespace shellmatch
