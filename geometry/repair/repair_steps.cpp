#include "geometry/repair/repair_steps.h"

#include "base/disjoint_sets.h"
#include "base/error.h"
#include "base/text.h"
#include "geometry/surface/facet_edges.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <set>

namespace shellmatch {

namespace {

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
  for_each_edge(sorted_edges(surface.facets, surface.vertices.size()), [&](const FacetEdge* e, const FacetEdge* end) {
    if (end - e == 1) on_boundary[e->low] = on_boundary[e->high] = true;
  });
  std::vector<Index> order;
  for (std::size_t v = 0; v < on_boundary.size(); ++v)
    if (on_boundary[v]) order.push_back(static_cast<Index>(v));
  const auto coordinates = [&](Index v) {
    const Vec<3>& x = surface.vertices[v];
    return std::array<double, 3>{x.x(), x.y(), x.z()};
  };
  std::stable_sort(order.begin(), order.end(), [&](Index v, Index w) { return coordinates(v) < coordinates(w); });
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
  // Copies run from the same smallest corner to the same next one and to the same third; the first one is kept.
  std::vector<bool> copy(proper.size(), false);
  std::vector<std::pair<Index, Index>> thirds;  // and their facets
  for_each_edge(sorted_edges(proper, surface.vertices.size()), [&](const FacetEdge* begin, const FacetEdge* end) {
    thirds.clear();
    for (const FacetEdge* e = begin; e != end; ++e) {
      const std::array<Index, 3>& t = proper[e->facet];
      const Index third = t[(e->begin + 2) % 3];
      if (t[e->begin] == e->low && third > e->low) thirds.emplace_back(third, e->facet);
    }
    std::sort(thirds.begin(), thirds.end());
    for (std::size_t i = 1; i < thirds.size(); ++i)
      if (thirds[i].first == thirds[i - 1].first) copy[thirds[i].second] = true;
  });
  surface.facets.clear();
  for (std::size_t t = 0; t < proper.size(); ++t)
    if (!copy[t]) surface.facets.push_back(proper[t]);
  return {n_collapsed, proper.size() - surface.facets.size()};
}

void check_closed(const Surface<3>& surface, const std::string& source) {
  DisjointSets loops(surface.vertices.size());
  std::vector<FacetEdge> open, crowded;
  for_each_edge(sorted_edges(surface.facets, surface.vertices.size()), [&](const FacetEdge* e, const FacetEdge* end) {
    if (end - e == 1) {
      open.push_back(*e);
      loops.join(e->low, e->high);
    } else if (end - e > 2) {
      crowded.push_back(*e);
    }
  });
  std::set<Index> loop_names;
  for (const FacetEdge& e : open) loop_names.insert(loops.find(e.low));
  const int digits = digits_for(surface.vertices);
  const auto place = [&](const FacetEdge& e) {
    return position(surface.vertices[e.low], digits) + " to " + position(surface.vertices[e.high], digits);
  };
  const std::string boundary =
      open.empty() ? ""
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
