#include "geometry/repair/repair_steps.h"

#include "base/disjoint_sets.h"
#include "base/error.h"
#include "base/text.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <set>
#include <tuple>

namespace shellmatch {
namespace {

struct Edge {
  Index a, b;  // a < b
  Index facet;
  bool same_ends(const Edge& other) const { return a == other.a && b == other.b; }
  bool operator<(const Edge& other) const {
    return std::tie(a, b, facet) < std::tie(other.a, other.b, other.facet);
  }
};

std::vector<Edge> sorted_edges(const Surface<3>& surface) {
  std::vector<Edge> edges;
  for (std::size_t f = 0; f < surface.facets.size(); ++f)
    for (std::size_t k = 0; k < 3; ++k) {
      const Index a = surface.facets[f][k], b = surface.facets[f][(k + 1) % 3];
      if (a != b) edges.push_back({std::min(a, b), std::max(a, b), static_cast<Index>(f)});
    }
  std::sort(edges.begin(), edges.end());
  return edges;
}

// Calls visit(first edge of the group, number of its triangles) for every edge of the surface.
template <class Visit>
void for_each_edge(const Surface<3>& surface, Visit&& visit) {
  const std::vector<Edge> edges = sorted_edges(surface);
  for (std::size_t i = 0, j = 0; i < edges.size(); i = j) {
    while (j < edges.size() && edges[j].same_ends(edges[i])) ++j;
    visit(edges[i], j - i);
  }
}

// Six digits of the shape's size, however far from the origin it lies.
int digits_for(const std::vector<Vec<3>>& vertices) {
  const Box<3> box = bounding_box(vertices);
  const double largest = box.min.cwiseAbs().cwiseMax(box.max.cwiseAbs()).maxCoeff(), size = box.diagonal();
  return size > 0 ? std::clamp(6 + static_cast<int>(std::log10(largest / size)), 6, 17) : 6;
}

std::string position(const Vec<3>& x, int digits) {
  return fmt::format("({:.{}g}, {:.{}g}, {:.{}g})", x.x(), digits, x.y(), digits, x.z(), digits);
}

}  // namespace

std::size_t weld_seams(Surface<3>& surface) {
  std::vector<bool> on_boundary(surface.vertices.size(), false);
  for_each_edge(surface, [&](const Edge& e, std::size_t n) {
    if (n == 1) on_boundary[e.a] = on_boundary[e.b] = true;
  });
  std::vector<Index> order;
  for (std::size_t v = 0; v < on_boundary.size(); ++v)
    if (on_boundary[v]) order.push_back(static_cast<Index>(v));
  const auto coordinates = [&](Index v) {
    const Vec<3>& x = surface.vertices[v];
    return std::array<double, 3>{x.x(), x.y(), x.z()};
  };
  std::stable_sort(order.begin(), order.end(),
                   [&](Index v, Index w) { return coordinates(v) < coordinates(w); });
  std::vector<Index> target(surface.vertices.size());
  std::iota(target.begin(), target.end(), Index{0});
  std::size_t n_welded = 0;
  for (std::size_t i = 1; i < order.size(); ++i)
    if (coordinates(order[i]) == coordinates(order[i - 1])) {
      target[order[i]] = target[order[i - 1]];
      ++n_welded;
    }
  for (auto& facet : surface.facets)
    for (Index& v : facet) v = target[v];
  return n_welded;
}

std::pair<std::size_t, std::size_t> remove_repetitions(Surface<3>& surface) {
  Triangles proper;
  for (const auto& [a, b, c] : surface.facets)
    if (a != b && b != c && c != a) proper.push_back({a, b, c});
  const std::size_t n_collapsed = surface.facets.size() - proper.size();
  // Rotated to start with their smallest corner and sorted, copies are adjacent; the first one is kept.
  std::vector<std::pair<std::array<Index, 3>, std::size_t>> turned;
  for (std::size_t t = 0; t < proper.size(); ++t) {
    std::array<Index, 3> corners = proper[t];
    std::rotate(corners.begin(), std::min_element(corners.begin(), corners.end()), corners.end());
    turned.emplace_back(corners, t);
  }
  std::sort(turned.begin(), turned.end());
  std::vector<bool> copy(proper.size(), false);
  for (std::size_t i = 1; i < turned.size(); ++i)
    copy[turned[i].second] = turned[i].first == turned[i - 1].first;
  surface.facets.clear();
  for (std::size_t t = 0; t < proper.size(); ++t)
    if (!copy[t]) surface.facets.push_back(proper[t]);
  return {n_collapsed, proper.size() - surface.facets.size()};
}

void check_closed(const Surface<3>& surface, const std::string& source) {
  DisjointSets loops(surface.vertices.size());
  std::vector<Edge> open, crowded;
  for_each_edge(surface, [&](const Edge& e, std::size_t n) {
    if (n == 1) {
      open.push_back(e);
      loops.join(e.a, e.b);
    } else if (n > 2) {
      crowded.push_back(e);
    }
  });
  std::set<Index> loop_names;
  for (const Edge& e : open) loop_names.insert(loops.find(e.a));
  const int digits = digits_for(surface.vertices);
  const auto place = [&](const Edge& e) {
    return position(surface.vertices[e.a], digits) + " to " + position(surface.vertices[e.b], digits);
  };
  const std::string boundary =
      open.empty()
          ? ""
          : fmt::format("{} in {}, one from {}", counted(open.size(), "boundary edge", "boundary edges"),
                        counted(loop_names.size(), "loop", "loops"), place(open[0]));
  if (!crowded.empty())
    throw_input_error(
        "{}: the surface is not manifold: {} more than two faces, one from {}{}{}; remove inner walls and "
        "doubled faces",
        source, counted(crowded.size(), "edge has", "edges have"), place(crowded[0]),
        open.empty() ? "" : "; it is also open: ", boundary);
  if (!open.empty())
    throw_input_error("{}: the surface is open: {}; close its holes in a mesh editor", source, boundary);
}

std::vector<std::vector<Index>> connected_parts(const Surface<3>& surface) {
  DisjointSets sets(surface.vertices.size());
  for (const auto& [a, b, c] : surface.facets) {
    sets.join(a, b);
    sets.join(b, c);
  }
  std::vector<Index> part_of(surface.vertices.size(), no_index);
  std::vector<std::vector<Index>> parts;
  for (std::size_t f = 0; f < surface.facets.size(); ++f) {
    Index& part = part_of[sets.find(surface.facets[f][0])];
    if (part == no_index) {
      part = static_cast<Index>(parts.size());
      parts.emplace_back();
    }
    parts[part].push_back(static_cast<Index>(f));
  }
  return parts;
}

std::size_t remove_unused_vertices(Surface<3>& surface) {
  std::vector<Index> new_index(surface.vertices.size(), no_index);
  for (const auto& facet : surface.facets)
    for (const Index v : facet) new_index[v] = 0;
  std::vector<Vec<3>> kept;
  for (std::size_t v = 0; v < new_index.size(); ++v)
    if (new_index[v] != no_index) {
      new_index[v] = static_cast<Index>(kept.size());
      kept.push_back(surface.vertices[v]);
    }
  for (auto& facet : surface.facets)
    for (Index& v : facet) v = new_index[v];
  const std::size_t n_removed = surface.vertices.size() - kept.size();
  surface.vertices = std::move(kept);
  return n_removed;
}

}  // namespace shellmatch
