#include "geometry/repair/close_surface.h"

#include "base/error.h"
#include "base/parallel.h"
#include "base/text.h"
#include "geometry/distance/facet_tree.h"
#include "geometry/repair/flat_triangles.h"
#include "geometry/repair/repair_steps.h"
#include "geometry/surface/facet_point.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace shellmatch {

namespace {

// Of the area: where fillings are no more, nothing but them is tried. Half of what closes a flat sheet is filled.
constexpr double most_filled = 0.45;
// Of the diagonal of the bounding box: gaps up to a fiftieth are closed, wider ones where nothing else encloses
// anything.
constexpr double gaps[] = {0.02, 0.04, 0.08, 0.16};
// Of the gaps: how far outside the wrap lies.
constexpr double distance = 0.02;
// Of the diagonal: volume over area of what bounds something. A ball has a tenth, limbs a fiftieth, flat sheets
// nothing.
constexpr double least_thickness = 0.005;

// What check_closed() says; empty for a closed surface.
std::string why_open(const Surface<3>& surface, const std::string& source) {
  try {
    check_closed(surface, source);
    return "";
  } catch (const InputError& error) {
    return error.what();
  }
}

double thickness(const Surface<3>& closed) { return std::abs(enclosed_measure(closed)) / surface_measure(closed); }

// Triangles that share no vertex with another, beside parts that are more: nothing is lost with them. None where there
// is nothing else.
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

// The facets of the wrap that lie farther from the triangles than the wrap of a plane does: they bridge gaps and fill
// corners.
Surface<3> bridges(const Surface<3>& wrap, const Surface<3>& triangles, double offset) {
  const FacetTree<3> tree(triangles);
  const auto is_away = [&](const Vec<3>& x) {
    const Index f = tree.nearest(x);
    return f == no_index || (closest_point_on_facet(triangles, f, x).point - x).norm() > 3 * offset;
  };
  std::vector<char> vertex_is_away(wrap.vertices.size()), is_bridge(wrap.facets.size());
  parallel_for(
      wrap.vertices.size(), [&](std::size_t v) { vertex_is_away[v] = is_away(wrap.vertices[v]); }, 256);
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
  Surface<3> patches{
      filled.surface.vertices,
      {filled.surface.facets.end() - static_cast<std::ptrdiff_t>(filled.n_new), filled.surface.facets.end()}};
  remove_unused_vertices(patches);
  return {{std::move(observed), std::move(patches)}, filled.new_share};
}

struct Wrap {
  Surface<3> surface;
  double gap;  // that it bridges
  double offset() const { return distance * gap; }
};

// None where it encloses next to nothing: around a sheet it has two sides at twice its distance.
std::optional<Wrap> wrap_around(const Surface<3>& surface, double gap) {
  const double diagonal = bounding_box(surface.vertices).diagonal();
  if (!(diagonal > 0)) return std::nullopt;
  Wrap wrap{{}, gap * diagonal};
  wrap.surface = wrapped(surface, wrap.gap, wrap.offset());
  const double least = std::max(3 * wrap.offset(), gap > gaps[0] ? least_thickness * diagonal : 0);
  if (wrap.surface.facets.empty() || thickness(wrap.surface) < least) return std::nullopt;
  return wrap;
}

Closure put_wrap(Surface<3>& surface, Wrap wrap, std::string_view state, std::vector<std::string>& notes) {
  Closure closure{{surface, bridges(wrap.surface, surface, wrap.offset())}, 0};
  closure.invented_share = surface_measure(closure.evidence.unobserved) / surface_measure(wrap.surface);
  notes.push_back(fmt::format(
      "{}, and wrapped: the surface that is matched lies {:.3g} outside of the file's and bridges gaps up to {:.3g}; "
      "{:.2g} % of its area is made up, and weighs nothing",
      state, wrap.offset(), wrap.gap, 100 * closure.invented_share));
  if (closure.evidence.unobserved.facets.empty()) closure.evidence = {};
  surface = std::move(wrap.surface);
  return closure;
}

// Around what is open more widely than it bridges a wrap goes on both sides, so that it encloses less than fillings do.
bool encloses_more(const Surface<3>& filled, const std::optional<Wrap>& wrap) {
  const double volume = std::abs(enclosed_measure(filled));
  return thickness(filled) >= least_thickness * bounding_box(filled.vertices).diagonal() &&
         (!wrap || enclosed_measure(wrap->surface) < 0.5 * volume);
}

}  // namespace

Closure wrap_surface(Surface<3>& surface, std::string_view state, const std::string& why,
                     std::vector<std::string>& notes) {
  for (const double gap : gaps)
    if (std::optional<Wrap> wrap = wrap_around(surface, gap)) return put_wrap(surface, std::move(*wrap), state, notes);
  throw_input_error("{} (it encloses next to nothing even where gaps up to {:.3g} are bridged)", why,
                    std::ranges::max(gaps) * bounding_box(surface.vertices).diagonal());
}

Closure close_surface(Surface<3>& surface, const std::string& source, std::vector<std::string>& notes) {
  const std::string why = why_open(surface, source);
  if (why.empty()) return {};
  // The triangles on one side of each wedge stay together; what remains open is filled or wrapped.
  for (const Touching touching : {Touching::is_joined, Touching::is_apart}) {
    Surface<3> apart = surface;
    if (take_apart(apart, touching) == 0) break;
    const std::size_t n_folded = remove_folded_pairs(apart);
    if (apart.facets.empty() || !why_open(apart, source).empty()) continue;
    notes.emplace_back("edges with more than two triangles taken apart");
    if (n_folded > 0) notes.push_back(fmt::format("{} triangles between parts that share a face left out", n_folded));
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
  if (filled && !why_open(filled->surface, source).empty()) filled.reset();
  const bool is_mostly_there = filled && filled->new_share <= most_filled;
  std::optional<Wrap> wrap;
  if (!is_mostly_there) wrap = wrap_around(surface, gaps[0]);
  if (is_mostly_there || (filled && encloses_more(filled->surface, wrap))) {
    note_loose();
    Closure closure;
    if (filled->n_holes == 0) {
      notes.emplace_back("edges with more than two triangles taken apart");
    } else {
      notes.push_back(fmt::format("{} filled with {}, {:.2g} % of the area: that part is made up, and weighs nothing",
                                  counted(filled->n_holes, "hole", "holes"),
                                  counted(filled->n_new, "triangle", "triangles"), 100 * filled->new_share));
      closure = closure_by(*filled, std::move(bodies));
    }
    surface = std::move(filled->surface);
    return closure;
  }
  return wrap ? put_wrap(surface, std::move(*wrap), "not closed", notes)
              : wrap_surface(surface, "not closed", why, notes);
}

}  // namespace shellmatch
