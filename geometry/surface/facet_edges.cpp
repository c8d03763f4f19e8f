#include "geometry/surface/facet_edges.h"

#include "base/stop.h"

#include <algorithm>
#include <tuple>

namespace shellmatch {

namespace {

using Facets = std::vector<std::array<Index, 3>>;

constexpr std::size_t between_questions = 1 << 16;  // facets

// Calls visit(side) for every side with two ends.
template <class Visit>
void for_each_side(const Facets& facets, Visit&& visit) {
  for (std::size_t f = 0; f < facets.size(); ++f) {
    if (f % between_questions == 0) stop_if_wanted();
    for (int k = 0; k < 3; ++k) {
      const Index a = facets[f][k], b = facets[f][(k + 1) % 3];
      if (a != b) visit(FacetEdge{std::min(a, b), std::max(a, b), static_cast<Index>(f), k});
    }
  }
}

}  // namespace

// Counted into the places of their lower ends, each of which then has a few to sort.
std::vector<FacetEdge> sorted_edges(const Facets& facets, std::size_t n_vertices) {
  std::vector<std::size_t> end(n_vertices + 1, 0);
  for_each_side(facets, [&](const FacetEdge& e) { ++end[static_cast<std::size_t>(e.low) + 1]; });
  for (std::size_t v = 1; v < end.size(); ++v) end[v] += end[v - 1];
  std::vector<FacetEdge> edges(end.back());
  for_each_side(facets, [&](const FacetEdge& e) { edges[end[static_cast<std::size_t>(e.low)]++] = e; });
  // Each place now ends where the next one began.
  const auto before = [](const FacetEdge& e, const FacetEdge& f) {
    return std::tie(e.high, e.facet) < std::tie(f.high, f.facet);
  };
  for (std::size_t v = 0, begin = 0; v < n_vertices; begin = end[v++]) {
    if (v % between_questions == 0) stop_if_wanted();
    std::sort(edges.begin() + static_cast<std::ptrdiff_t>(begin), edges.begin() + static_cast<std::ptrdiff_t>(end[v]),
              before);
  }
  return edges;
}

bool is_oriented_manifold(const Facets& facets, std::size_t n_vertices, Border border) {
  for (const auto& [a, b, c] : facets)
    if (a == b || b == c || c == a) return false;
  // The corner that follows around the same vertex, across the side that leaves it.
  std::vector<Index> next(3 * facets.size(), no_index);
  std::vector<bool> is_first(next.size(), true);
  bool is_good = true;
  for_each_edge(sorted_edges(facets, n_vertices), [&](const FacetEdge* begin, const FacetEdge* end) {
    if (border == Border::allowed && end - begin == 1) return;
    const auto at = [](const FacetEdge& e, int k) { return 3 * e.facet + (e.begin + k) % 3; };
    const auto first = [&](const FacetEdge& e) { return facets[e.facet][e.begin]; };
    is_good = is_good && end - begin == 2 && first(begin[0]) != first(begin[1]);
    if (!is_good) return;
    const auto link = [&](Index corner, Index follower) {
      next[corner] = follower;
      is_first[follower] = false;
    };
    link(at(begin[0], 0), at(begin[1], 1));
    link(at(begin[1], 0), at(begin[0], 1));
  });
  if (!is_good) return false;
  // One fan for each vertex: those that begin at a border, and then those that go round.
  std::vector<bool> has_fan(n_vertices, false), is_seen(next.size(), false);
  const auto is_only_fan = [&](std::size_t c) {
    const Index v = facets[c / 3][c % 3];
    if (has_fan[v]) return false;
    has_fan[v] = true;
    for (auto turn = static_cast<Index>(c); turn != no_index && !is_seen[turn]; turn = next[turn]) is_seen[turn] = true;
    return true;
  };
  for (std::size_t c = 0; c < next.size(); ++c)
    if (is_first[c] && !is_only_fan(c)) return false;
  for (std::size_t c = 0; c < next.size(); ++c)
    if (!is_seen[c] && !is_only_fan(c)) return false;
  return true;
}

}  // namespace shellmatch
