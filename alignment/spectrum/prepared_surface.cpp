#include "alignment/spectrum/prepared_surface.h"

#include "base/disjoint_sets.h"
#include "base/error.h"
#include "base/parallel.h"
#include "base/stop.h"
#include "geometry/distance/facet_tree.h"
#include "geometry/repair/repair_steps.h"
#include "geometry/surface/subdivision.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numeric>

namespace shellmatch {

namespace {

/// A vertex' component, or no_index where it has no facet.
struct Components {
  std::vector<Index> of_vertex;
  std::vector<double> areas;
};

/// Counted in the order of their first vertices.
std::vector<Index> numbered_components(const Surface<3>& surface) {
  DisjointSets sets(surface.vertices.size());
  StopCheck stop_check;
  for (const auto& [a, b, c] : surface.facets) {
    stop_check();
    sets.join(a, b);
    sets.join(b, c);
  }
  std::vector<Index> component(surface.vertices.size());
  Index n = 0;
  // A set's first vertex stands for it.
  for (Index v = 0; v < static_cast<Index>(component.size()); ++v)
    component[v] = sets.find(v) == v ? n++ : component[sets.find(v)];
  return component;
}

Components components_of(const Surface<3>& surface) {
  Components components{numbered_components(surface), {}};
  std::vector<bool> has_facet(surface.vertices.size(), false);
  for (std::size_t f = 0; f < surface.facets.size(); ++f) {
    const auto c = static_cast<std::size_t>(components.of_vertex[surface.facets[f][0]]);
    if (components.areas.size() <= c) components.areas.resize(c + 1, 0);
    components.areas[c] += facet_measure(surface, static_cast<Index>(f));
    for (const Index v : surface.facets[f]) has_facet[v] = true;
  }
  for (std::size_t v = 0; v < has_facet.size(); ++v)
    if (!has_facet[v]) components.of_vertex[v] = no_index;
  return components;
}

/// Descending by area.
std::vector<Index> ranked(const Components& components) {
  std::vector<Index> order(components.areas.size());
  std::iota(order.begin(), order.end(), Index{0});
  std::ranges::stable_sort(order, std::greater<>(), [&](Index c) { return components.areas[c]; });
  return order;
}

double total_area(const Components& components) {
  return std::accumulate(components.areas.begin(), components.areas.end(), 0.0);
}

Surface<3> component_of(const Surface<3>& surface, const Components& components, Index wanted) {
  Surface<3> part;
  std::vector<Index> number(surface.vertices.size(), no_index);
  for (std::size_t v = 0; v < number.size(); ++v)
    if (components.of_vertex[v] == wanted) {
      number[v] = static_cast<Index>(part.vertices.size());
      part.vertices.push_back(surface.vertices[v]);
    }
  for (const auto& [a, b, c] : surface.facets)
    if (components.of_vertex[a] == wanted) part.facets.push_back({number[a], number[b], number[c]});
  return part;
}

/// For each vertex of a component the nearest corner of the nearest facet.
std::vector<Index> nearest_corners(const Surface<3>& input, const Components& components, Index wanted,
                                   const Surface<3>& surface) {
  const FacetTree<3> tree(surface);
  std::vector<Index> nearest(input.vertices.size(), no_index);
  parallel_for(nearest.size(), [&](std::size_t v) {
    if (components.of_vertex[v] != wanted) return;
    const Vec<3>& x = input.vertices[v];
    const auto& corners = surface.facets[tree.nearest(x)];
    nearest[v] = *std::min_element(corners.begin(), corners.end(), [&](Index a, Index b) {
      return (surface.vertices[a] - x).squaredNorm() < (surface.vertices[b] - x).squaredNorm();
    });
  });
  return nearest;
}

}  // namespace

std::size_t n_large_components(const Surface<3>& input) {
  constexpr double least_share = 0.05;
  constexpr std::ptrdiff_t most = 4;
  const Components components = components_of(input);
  const double least = least_share * total_area(components);
  const auto n = std::ranges::count_if(components.areas, [&](double a) { return a > least; });
  return static_cast<std::size_t>(std::clamp<std::ptrdiff_t>(n, 1, most));
}

PreparedSurface prepare_surface(const Surface<3>& input, const AlignmentOptions& options, std::size_t rank) {
  const Components components = components_of(input);
  const double area = total_area(components);
  if (!std::isfinite(area)) throw_input_error("a surface has coordinates that are not finite");
  if (!(area > 0)) throw_input_error("a surface without area has no correspondence; give it facets");
  const Index wanted = ranked(components)[rank];
  PreparedSurface prepared{component_of(input, components, wanted), {}};
  prepared.share = components.areas[wanted] / area;
  prepared.rank = rank;
  const std::size_t n = prepared.surface.vertices.size();
  const auto most = static_cast<std::size_t>(options.max_vertices);
  // A surface that is a little larger is not worth the change of its vertices.
  if (n > most + most / 20) {
    const Surface<3> coarse = simplified(prepared.surface, most);
    // Where facets were dropped the rest may fall apart.
    const Components parts = components_of(coarse);
    prepared.surface = component_of(coarse, parts, ranked(parts)[0]);
  }
  while (prepared.surface.vertices.size() < n_least_vertices) cut_long_edges(prepared.surface, 0);
  prepared.nearest = nearest_corners(input, components, wanted, prepared.surface);
  return prepared;
}

}  // namespace shellmatch
