#include "alignment/bend/deformation_graph.h"

#include "base/disjoint_sets.h"
#include "base/error.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <utility>

namespace shellmatch {

namespace {

struct Near {
  double distance;
  Index node;
};

Index nearest_of(const std::vector<Vec<3>>& points, const Vec<3>& x) {
  const auto nearer = [&](const Vec<3>& a, const Vec<3>& b) { return (a - x).squaredNorm() < (b - x).squaredNorm(); };
  return static_cast<Index>(std::min_element(points.begin(), points.end(), nearer) - points.begin());
}

DeformationGraph::Influence influence_of(std::vector<Near>& near, double reach) {
  constexpr std::size_t n = DeformationGraph::n_influences;
  std::ranges::stable_sort(near, {}, &Near::distance);
  DeformationGraph::Influence result;
  result.nodes.fill(near.front().node);
  result.weights.fill(0);
  // The first node that is left out has weight 0, so that weights are continuous.
  const double end = near.size() > n ? near[n].distance : reach;
  double sum = 0;
  for (std::size_t i = 0; i < std::min(n, near.size()); ++i) {
    result.nodes[i] = near[i].node;
    const double weight = end > 0 ? std::max(0.0, 1 - near[i].distance / end) : 0;
    sum += result.weights[i] = weight * weight;
  }
  if (!(sum > 0)) result.weights[0] = sum = 1;
  for (double& weight : result.weights) weight /= sum;
  return result;
}

}  // namespace

DeformationGraph::DeformationGraph(const Surface<3>& surface, std::size_t n_nodes) {
  SHELLMATCH_CHECK(!surface.vertices.empty() && n_nodes > 0, "a graph has nodes");
  const EdgeGraph graph(surface);
  const std::vector<Index> nodes = farthest_point_samples(graph, 0, n_nodes);
  for (const Index v : nodes) centres_.push_back(surface.vertices[v]);
  add_influences(surface, graph, nodes);
  add_edges(surface);
}

void DeformationGraph::add_influences(const Surface<3>& surface, const EdgeGraph& graph,
                                      const std::vector<Index>& nodes) {
  std::vector<double> nearest(surface.vertices.size(), std::numeric_limits<double>::infinity());
  for (const Index v : nodes) graph.lower_distances(v, nearest);
  double covering = 0;
  for (const double distance : nearest)
    if (std::isfinite(distance)) covering = std::max(covering, distance);
  const double reach = 2 * covering;
  std::vector<std::vector<Near>> near(surface.vertices.size());
  for (std::size_t k = 0; k < nodes.size(); ++k)
    graph.for_each_within(nodes[k], reach, [&](Index v, double distance) {
      near[v].push_back({distance, static_cast<Index>(k)});
      return true;
    });
  influences_.reserve(near.size());
  for (std::size_t v = 0; v < near.size(); ++v) {
    if (near[v].empty()) near[v].push_back({0, nearest_of(centres_, surface.vertices[v])});
    influences_.push_back(influence_of(near[v], reach));
  }
}

void DeformationGraph::add_edges(const Surface<3>& surface) {
  std::map<std::pair<Index, Index>, double> weights;
  for (const Influence& influence : influences_)
    for (std::size_t i = 0; i < n_influences; ++i)
      for (std::size_t j = 0; j < n_influences; ++j)
        if (const double shared = influence.weights[i] * influence.weights[j];
            shared > 0 && influence.nodes[i] != influence.nodes[j])
          weights[{influence.nodes[i], influence.nodes[j]}] += shared;
  DisjointSets components(centres_.size());
  double mean = 0;
  for (const auto& [nodes, weight] : weights) {
    components.join(nodes.first, nodes.second);
    mean += weight / static_cast<double>(weights.size());
  }
  // The nearest nodes of different components hold them together.
  std::vector<std::pair<double, std::pair<Index, Index>>> gaps;
  for (Index a = 0; a < static_cast<Index>(centres_.size()); ++a)
    for (Index b = 0; b < a; ++b)
      if (components.find(a) != components.find(b)) gaps.push_back({(centres_[a] - centres_[b]).squaredNorm(), {a, b}});
  std::ranges::sort(gaps);
  for (const auto& [gap, nodes] : gaps) {
    const auto [a, b] = nodes;
    if (components.find(a) == components.find(b)) continue;
    components.join(a, b);
    weights[{a, b}] = weights[{b, a}] = mean > 0 ? mean : 1;
  }
  double sum = 0;
  for (const auto& [nodes, weight] : weights)
    sum += weight * (centres_[nodes.first] - centres_[nodes.second]).squaredNorm();
  const double factor = sum > 0 ? 2 * surface_measure(surface) / sum : 1;
  for (const auto& [nodes, weight] : weights) edges_.push_back({nodes.first, nodes.second, factor * weight});
}

Vec<3> DeformationGraph::moved(Index vertex, const Vec<3>& x, const std::vector<NodeMotion>& motions) const {
  const Influence& influence = influences_[vertex];
  Vec<3> y = Vec<3>::Zero();
  for (std::size_t i = 0; i < n_influences; ++i) {
    if (influence.weights[i] == 0) continue;
    const Vec<3>& centre = centres_[influence.nodes[i]];
    const NodeMotion& motion = motions[influence.nodes[i]];
    y += influence.weights[i] * (motion.rotation * (x - centre) + centre + motion.translation);
  }
  return y;
}

}  // namespace shellmatch
