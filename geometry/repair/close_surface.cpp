#include "geometry/repair/close_surface.h"

#include "base/error.h"
#include "base/parallel.h"
#include "base/text.h"
#include "geometry/distance/facet_tree.h"
#include "geometry/repair/flat_triangles.h"
#include "geometry/repair/repair_steps.h"
#include "geometry/surface/facet_point.h"

#include <utility>

namespace shellmatch {

namespace {

// More than half of a surface is not made up: a flat sheet has nothing else.
constexpr double most_filled = 0.45;
// Of the diagonal of the bounding box: gaps up to a fiftieth are closed, and the wrap lies a fiftieth of that outside.
constexpr double gap = 0.02, distance = 0.02 * gap;

// What check_closed() says; empty for a closed surface.
std::string why_open(const Surface<3>& surface, const std::string& source) {
  try {
    check_closed(surface, source);
    return "";
  } catch (const InputError& error) {
    return error.what();
  }
}

// A sheet has two sides at twice the wrap's distance: half of its area times that.
bool encloses_next_to_nothing(const Surface<3>& wrap, double offset) {
  return enclosed_measure(wrap) < 3 * offset * surface_measure(wrap);
}

// Triangles that share no vertex with another, beside parts that are more: nothing is lost with them. None where there is nothing else.
std::size_t drop_loose_triangles(Surface<3>& surface) {
  const std::vector<std::vector<Index>> parts = connected_parts(surface);
  Triangles kept;
  for (const std::vector<Index>& part : parts)
    if (part.size() > 1)
      for (const Index f : part) kept.push_back(surface.facets[f]);
  if (kept.empty()) return 0;
  const std::size_t n_loose = surface.facets.size() - kept.size();
  if (n_loose > 0) surface.facets = std::move(kept);
  return n_loose;
}

// The facets of the wrap that lie farther from the triangles than the wrap of a plane does: they bridge gaps and fill corners.
Surface<3> bridges(const Surface<3>& wrap, const Surface<3>& triangles, double offset) {
  const FacetTree<3> tree(triangles);
  const auto is_away = [&](const Vec<3>& x) {
    const Index f = tree.nearest(x);
    return f == no_index || (closest_point_on_facet(triangles, f, x).point - x).norm() > 3 * offset;
  };
  std::vector<char> vertex_is_away(wrap.vertices.size()), is_bridge(wrap.facets.size());
  parallel_for(wrap.vertices.size(), [&](std::size_t v) { vertex_is_away[v] = is_away(wrap.vertices[v]); }, 256);
  parallel_for(
      wrap.facets.size(),
      [&](std::size_t i) {
        const auto& [a, b, c] = wrap.facets[i];
        is_bridge[i] = vertex_is_away[a] || vertex_is_away[b] || vertex_is_away[c] ||
                       is_away((wrap.vertices[a] + wrap.vertices[b] + wrap.vertices[c]) / 3);
      },
      256);
  Surface<3> found{wrap.vertices, {}};
  for (std::size_t f = 0; f < wrap.facets.size(); ++f)
    if (is_bridge[f]) found.facets.push_back(wrap.facets[f]);
  remove_unused_vertices(found);
  return found;
}

// The patches with which the holes of `observed` were filled.
Closure closure_by(const FilledHoles& filled, Surface<3> observed) {
  Surface<3> patches{filled.surface.vertices, {filled.surface.facets.end() - static_cast<std::ptrdiff_t>(filled.n_new), filled.surface.facets.end()}};
  remove_unused_vertices(patches);
  return {{std::move(observed), std::move(patches)}, filled.new_share};
}

}  // namespace

Closure wrap_surface(Surface<3>& surface, std::string_view state, const std::string& why, std::vector<std::string>& notes) {
  const double diagonal = bounding_box(surface.vertices).diagonal();
  if (!(diagonal > 0)) throw InputError(why);
  Surface<3> wrap = wrapped(surface, gap * diagonal, distance * diagonal);
  if (wrap.facets.empty()) throw_input_error("{} (and no wrap could be made)", why);
  if (encloses_next_to_nothing(wrap, distance * diagonal))
    throw_input_error("{} (it encloses next to nothing even where gaps up to {:.3g} are bridged)", why, gap * diagonal);
  Closure closure{{surface, bridges(wrap, surface, distance * diagonal)}, 0};
  closure.invented_share = surface_measure(closure.evidence.unobserved) / surface_measure(wrap);
  notes.push_back(fmt::format("{}, and wrapped: the surface that is matched lies {:.3g} outside of the file's and bridges gaps up to {:.3g}; "
                              "{:.2g} % of its area is made up, and weighs nothing",
                              state, distance * diagonal, gap * diagonal, 100 * closure.invented_share));
  if (closure.evidence.unobserved.facets.empty()) closure.evidence = {};
  surface = std::move(wrap);
  return closure;
}

Closure close_surface(Surface<3>& surface, const std::string& source, std::vector<std::string>& notes) {
  const std::string why = why_open(surface, source);
  if (why.empty()) return {};
  // The triangles on one side of each wedge stay together; what remains open is filled or wrapped.
  Surface<3> apart = surface;
  if (take_apart(apart) > 0 && remove_folded_pairs(apart) == 0 && why_open(apart, source).empty()) {
    notes.emplace_back("edges with more than two triangles taken apart");
    surface = std::move(apart);
    return {};
  }
  Surface<3> bodies = surface;
  const std::size_t n_loose = drop_loose_triangles(bodies);
  const auto note_loose = [&] {
    if (n_loose > 0) notes.push_back(fmt::format("{} left out", counted(n_loose, "loose triangle", "loose triangles")));
  };
  if (n_loose > 0 && why_open(bodies, source).empty()) {
    note_loose();
    surface = std::move(bodies);
    return {};
  }
  std::optional<FilledHoles> filled = fill_holes(bodies);
  if (filled && filled->new_share <= most_filled && why_open(filled->surface, source).empty()) {
    note_loose();
    Closure closure;
    if (filled->n_holes == 0) {
      notes.emplace_back("edges with more than two triangles taken apart");
    } else {
      notes.push_back(fmt::format("{} filled with {}, {:.2g} % of the area: that part is made up, and weighs nothing",
                                  counted(filled->n_holes, "hole", "holes"), counted(filled->n_new, "triangle", "triangles"), 100 * filled->new_share));
      closure = closure_by(*filled, std::move(bodies));
    }
    surface = std::move(filled->surface);
    return closure;
  }
  return wrap_surface(surface, "not closed", why, notes);
}

}  // namespace shellmatch
