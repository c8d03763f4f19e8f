#include "geometry/surface/subdivision.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <unordered_map>
#include <utility>

namespace shellmatch {

namespace {

/// Cuts all edges that are longer than a length at their middles, once.
class Bisection {
 public:
  Bisection(Surface<3>& surface, double length) : surface_(surface), square_(length * length) {}

  /// \return whether there was any
  bool run() {
    const std::size_t n_before = surface_.vertices.size();
    std::vector<std::array<Index, 3>> facets = std::exchange(surface_.facets, {});
    surface_.facets.reserve(facets.size());
    for (const auto& facet : facets) cut(facet);
    return surface_.vertices.size() > n_before;
  }

 private:
  double squared_distance(Index a, Index b) const {
    return (surface_.vertices[a] - surface_.vertices[b]).squaredNorm();
  }

  // The vertex at the middle of an edge, or no_index where the edge is short.
  Index middle(Index a, Index b) {
    if (!(squared_distance(a, b) > square_)) return no_index;
    const auto [low, high] = std::minmax(a, b);
    const auto [at, is_new] =
        middles_.try_emplace(static_cast<std::uint64_t>(low) << 32 | static_cast<std::uint32_t>(high),
                             static_cast<Index>(surface_.vertices.size()));
    if (is_new) surface_.vertices.push_back(0.5 * (surface_.vertices[low] + surface_.vertices[high]));
    return at->second;
  }

  void cut(std::array<Index, 3> facet) {
    std::array<Index, 3> m;  // m[k] on the edge from vertex k to the next
    for (int k = 0; k < 3; ++k) m[k] = middle(facet[k], facet[(k + 1) % 3]);
    const auto n_long = 3 - std::ranges::count(m, no_index);
    // Rotated so that the edge 0-1 is long where any is, and 2-0 short where any is.
    while ((n_long == 1 && m[0] == no_index) || (n_long == 2 && m[2] != no_index)) {
      std::ranges::rotate(facet, facet.begin() + 1);
      std::ranges::rotate(m, m.begin() + 1);
    }
    const auto [a, b, c] = facet;
    const auto add = [&](Index i, Index j, Index k) { surface_.facets.push_back({i, j, k}); };
    if (n_long == 0) return add(a, b, c);
    if (n_long == 1) return add(a, m[0], c), add(m[0], b, c);
    if (n_long == 3) return add(a, m[0], m[2]), add(m[0], b, m[1]), add(m[2], m[1], c), add(m[0], m[1], m[2]);
    add(m[0], b, m[1]);
    if (squared_distance(a, m[1]) < squared_distance(m[0], c)) return add(a, m[0], m[1]), add(a, m[1], c);
    add(a, m[0], c);
    add(m[0], m[1], c);
  }

  Surface<3>& surface_;
  double square_;
  std::unordered_map<std::uint64_t, Index> middles_;
};

}  // namespace

bool cut_long_edges(Surface<3>& surface, double length) { return Bisection(surface, length).run(); }

template <>
Surface<2> subdivided(const Surface<2>& surface, double length) {
  Surface<2> fine{surface.vertices, {}};
  for (const auto& [a, b] : surface.facets) {
    const Vec<2> from = surface.vertices[a], edge = surface.vertices[b] - from;
    const int pieces = std::max(1, static_cast<int>(std::ceil(edge.norm() / length)));
    Index last = a;
    for (int k = 1; k < pieces; ++k) {
      fine.vertices.push_back(from + edge * (static_cast<double>(k) / pieces));
      fine.facets.push_back({last, static_cast<Index>(fine.vertices.size()) - 1});
      last = fine.facets.back()[1];
    }
    fine.facets.push_back({last, b});
  }
  return fine;
}

template <>
Surface<3> subdivided(const Surface<3>& surface, double length) {
  Surface<3> fine = surface;
  while (cut_long_edges(fine, length)) {
  }
  return fine;
}

}  // namespace shellmatch
