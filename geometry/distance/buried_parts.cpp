#include "geometry/distance/buried_parts.h"

#include "base/disjoint_sets.h"
#include "geometry/distance/facet_tree.h"
#include "geometry/distance/winding_number.h"
#include "geometry/surface/facet_point.h"
#include "geometry/surface/self_intersections.h"

#include <algorithm>
#include <functional>
#include <map>
#include <utility>
#include <vector>

namespace shellmatch {

namespace {

using Part = std::vector<Index>;

// A part costs the time of a tree over all facets; where thousands of facets cross there are thousands of parts of a few facets each.
constexpr std::size_t most_parts = 64;

/// Facets that cross no other and are connected across edges: no other part of the surface lies between them. Across vertices they need
/// not be: two facets of one vertex can cross each other. The largest parts first.
std::vector<Part> parts_between(const Surface<3>& s, const std::vector<Index>& crossing) {
  std::vector<bool> crosses(s.facets.size());
  for (const Index f : crossing) crosses[f] = true;
  DisjointSets sets(s.facets.size());
  std::map<std::pair<Index, Index>, Index> facet_at;
  for (Index f = 0; f < static_cast<Index>(s.facets.size()); ++f)
    for (int k = 0; k < 3 && !crosses[f]; ++k) {
      const auto [edge, is_new] = facet_at.try_emplace(std::minmax({s.facets[f][k], s.facets[f][(k + 1) % 3]}), f);
      if (!is_new) sets.join(f, edge->second);
    }
  std::map<Index, Part> parts;
  for (Index f = 0; f < static_cast<Index>(s.facets.size()); ++f)
    if (!crosses[f]) parts[sets.find(f)].push_back(f);
  std::vector<Part> result;
  for (auto& [first, part] : parts) result.push_back(std::move(part));
  std::ranges::stable_sort(result, std::ranges::greater{}, &Part::size);
  result.resize(std::min(result.size(), most_parts));
  return result;
}

bool is_buried(const Surface<3>& s, const Part& part) {
  const Index largest = *std::ranges::max_element(part, {}, [&](Index f) { return facet_measure(s, f); });
  const auto& [a, b, c] = s.facets[largest];
  const Vec<3> centre = (s.vertices[a] + s.vertices[b] + s.vertices[c]) / 3;
  const Vec<3> away = 1e-6 * bounding_box(s.vertices).diagonal() * facet_normal(s, largest).normalized();
  return winding_number<3>(s, centre + away) > 0.5;
}

std::vector<bool> vertices_of(const Surface<3>& s, const Part& part) {
  std::vector<bool> belongs(s.vertices.size());
  for (const Index f : part)
    for (const Index v : s.facets[f]) belongs[v] = true;
  return belongs;
}

double depth_of(const Surface<3>& s, const std::vector<bool>& belongs) {
  Surface<3> others{s.vertices, {}};
  for (const auto& facet : s.facets)
    if (std::ranges::none_of(facet, [&](Index v) { return belongs[v]; })) others.facets.push_back(facet);
  if (others.facets.empty()) return 0;
  const FacetTree<3> tree(others);
  double depth = 0;
  for (std::size_t v = 0; v < belongs.size(); ++v) {
    if (!belongs[v]) continue;
    const Vec<3>& x = s.vertices[v];
    depth = std::max(depth, (closest_point_on_facet(others, tree.nearest(x), x).point - x).norm());
  }
  return depth;
}

}  // namespace

BuriedParts buried_parts(const Surface<3>& s) {
  BuriedParts result;
  const std::vector<Index> crossing = self_intersecting_facets(s);
  if (crossing.empty()) return result;
  std::vector<bool> all(s.vertices.size());
  for (const Part& part : parts_between(s, crossing)) {
    if (!is_buried(s, part)) continue;
    const std::vector<bool> belongs = vertices_of(s, part);
    for (std::size_t v = 0; v < belongs.size(); ++v) all[v] = all[v] || belongs[v];
    result.depth = std::max(result.depth, depth_of(s, belongs));
  }
  result.n_vertices = static_cast<std::size_t>(std::ranges::count(all, true));
  return result;
}

}  // namespace shellmatch
