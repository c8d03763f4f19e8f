#include "geometry/distance/buried_parts.h"

#include "base/disjoint_sets.h"
#include "base/parallel.h"
#include "geometry/distance/facet_tree.h"
#include "geometry/distance/winding_number.h"
#include "geometry/surface/facet_edges.h"
#include "geometry/surface/facet_point.h"

#include <algorithm>
#include <optional>
#include <utility>

namespace shellmatch {

namespace {

Vec<3> centre_of(const Surface<3>& s, Index f) {
  const auto& [a, b, c] = s.facets[f];
  return (s.vertices[a] + s.vertices[b] + s.vertices[c]) / 3;
}

/// For each facet the one that decides for it: itself where it crosses others; else the largest of those to which it is
/// connected by edges across facets that cross none, as no other part of the surface lies between them. Across vertices
/// they need not be connected: two facets of one vertex can cross each other.
std::vector<Index> judges(const Surface<3>& s, const std::vector<Index>& crossing) {
  std::vector<bool> crosses(s.facets.size());
  for (const Index f : crossing) crosses[f] = true;
  DisjointSets sets(s.facets.size());
  for_each_edge(sorted_edges(s.facets, s.vertices.size()), [&](const FacetEdge* begin, const FacetEdge* end) {
    Index first = no_index;
    for (const FacetEdge* e = begin; e != end; ++e) {
      if (crosses[e->facet]) continue;
      if (first == no_index) first = e->facet;
      else sets.join(first, e->facet);
    }
  });
  std::vector<Index> judge(s.facets.size(), no_index);
  std::vector<double> area(s.facets.size());
  for (Index f = 0; f < static_cast<Index>(s.facets.size()); ++f) {
    area[f] = facet_measure(s, f);
    Index& of_set = judge[sets.find(f)];
    if (of_set == no_index || area[f] > area[of_set]) of_set = f;
  }
  for (Index f = 0; f < static_cast<Index>(s.facets.size()); ++f) judge[f] = judge[sets.find(f)];
  return judge;
}

std::vector<char> is_buried(const Surface<3>& s, const std::vector<Index>& crossing) {
  const std::vector<Index> judge = judges(s, crossing);
  const CrossingNumber winding(s);
  const double above = 1e-6 * bounding_box(s.vertices).diagonal();
  std::vector<char> buried(s.facets.size());
  parallel_for(
      buried.size(),
      [&](std::size_t i) {
        const auto f = static_cast<Index>(i);
        if (judge[i] == f) buried[i] = winding(centre_of(s, f) + above * facet_normal(s, f).normalized()) > 0;
      },
      256);
  for (std::size_t f = 0; f < buried.size(); ++f) buried[f] = buried[judge[f]];
  return buried;
}

/// For each buried facet how deep it reaches below the others; 0 for those, and for all where there are none.
std::vector<double> depths_of(const Surface<3>& s, const std::vector<char>& buried) {
  std::vector<double> depths(buried.size());
  if (std::ranges::find(buried, 1) == buried.end()) return depths;
  Surface<3> others{s.vertices, {}};
  for (std::size_t f = 0; f < buried.size(); ++f)
    if (!buried[f]) others.facets.push_back(s.facets[f]);
  if (others.facets.empty()) return depths;
  const FacetTree<3> tree(others);
  const auto below = [&](const Vec<3>& x) {
    return (closest_point_on_facet(others, tree.nearest(x), x).point - x).norm();
  };
  parallel_for(
      depths.size(),
      [&](std::size_t f) {
        if (!buried[f]) return;
        depths[f] = below(centre_of(s, static_cast<Index>(f)));
        for (const Index v : s.facets[f]) depths[f] = std::max(depths[f], below(s.vertices[v]));
      },
      64);
  return depths;
}

}  // namespace

BuriedParts buried_parts(const Surface<3>& s, const std::vector<Index>& crossing) {
  BuriedParts result;
  if (crossing.empty()) return result;
  std::vector<char> buried = is_buried(s, crossing);
  const std::vector<double> depths = depths_of(s, buried);
  DisjointSets sets(s.vertices.size());
  for (std::size_t f = 0; f < buried.size(); ++f)
    for (int k = 1; k < 3 && buried[f]; ++k) sets.join(s.facets[f][0], s.facets[f][k]);
  std::vector<double> depth_of_set(s.vertices.size());
  for (std::size_t f = 0; f < buried.size(); ++f) {
    double& depth = depth_of_set[sets.find(s.facets[f][0])];
    if (buried[f]) depth = std::max(depth, depths[f]);
  }
  const double least = least_burial_depth * bounding_box(s.vertices).diagonal();
  std::vector<bool> is_used(s.vertices.size()), is_seen(s.vertices.size());
  double area = 0, all = 0;
  for (std::size_t f = 0; f < buried.size(); ++f) {
    buried[f] = buried[f] && depth_of_set[sets.find(s.facets[f][0])] >= least;
    for (const Index v : s.facets[f]) (buried[f] ? is_used : is_seen)[v] = true;
    const double measure = facet_measure(s, static_cast<Index>(f));
    all += measure;
    if (!buried[f]) continue;
    area += measure;
    result.facets.push_back(static_cast<Index>(f));
    result.depth = std::max(result.depth, depths[f]);
  }
  for (std::size_t v = 0; v < is_used.size(); ++v) result.n_vertices += is_used[v] && !is_seen[v];
  result.share = area / all;
  return result;
}

Evidence<3> without_buried(const Surface<3>& surface, const Evidence<3>& evidence, const std::vector<Index>& buried) {
  if (buried.empty()) return evidence;
  std::vector<bool> is_hidden(surface.facets.size());
  for (const Index f : buried) is_hidden[f] = true;
  const bool is_whole = evidence.is_complete();
  const Surface<3>& known = is_whole ? surface : evidence.observed;
  std::optional<FacetTree<3>> tree;  // the observed facets were mended since, and have other numbers there
  if (!is_whole) tree.emplace(surface);
  Evidence<3> result{{known.vertices, {}}, evidence.unobserved};
  const auto offset = static_cast<Index>(result.unobserved.vertices.size());
  result.unobserved.vertices.insert(result.unobserved.vertices.end(), known.vertices.begin(), known.vertices.end());
  for (std::size_t f = 0; f < known.facets.size(); ++f) {
    const auto& [a, b, c] = known.facets[f];
    if (is_hidden[is_whole ? static_cast<Index>(f) : tree->nearest(centre_of(known, static_cast<Index>(f)))])
      result.unobserved.facets.push_back({a + offset, b + offset, c + offset});
    else result.observed.facets.push_back(known.facets[f]);
  }
  return result;
}

Surface<3> with_buried(const Evidence<3>& evidence) {
  Surface<3> all = evidence.observed;
  const auto& [vertices, facets] = evidence.unobserved;
  if (vertices.size() < all.vertices.size()) return all;
  const auto offset = static_cast<Index>(vertices.size() - all.vertices.size());  // those of without_buried() are last
  for (const auto& [a, b, c] : facets)
    if (std::min({a, b, c}) >= offset) all.facets.push_back({a - offset, b - offset, c - offset});
  return all;
}

}  // namespace shellmatch
