#include "geometry/repair/close_surface.h"

#include "base/error.h"
#include "base/text.h"
#include "geometry/repair/repair_steps.h"

#include <utility>

namespace shellmatch {

namespace {

// Larger patches are guesses rather than repairs.
constexpr double most_filled = 0.3;
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
  double area = 0;
  for (std::size_t f = 0; f < wrap.facets.size(); ++f) area += facet_measure(wrap, static_cast<Index>(f));
  return enclosed_measure(wrap) < 3 * offset * area;
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

}  // namespace

double close_surface(Surface<3>& surface, const std::string& source, std::vector<std::string>& notes) {
  const std::string why = why_open(surface, source);
  if (why.empty()) return 0;
  Surface<3> bodies = surface;
  const std::size_t n_loose = drop_loose_triangles(bodies);
  const auto note_loose = [&] {
    if (n_loose > 0) notes.push_back(fmt::format("{} left out", counted(n_loose, "loose triangle", "loose triangles")));
  };
  if (n_loose > 0 && why_open(bodies, source).empty()) {
    note_loose();
    surface = std::move(bodies);
    return 0;
  }
  std::optional<FilledHoles> filled = fill_holes(bodies);
  if (filled && filled->new_share <= most_filled && why_open(filled->surface, source).empty()) {
    note_loose();
    surface = std::move(filled->surface);
    if (filled->n_holes == 0) {
      notes.emplace_back("edges with more than two triangles taken apart");
      return 0;
    }
    notes.push_back(fmt::format("{} filled with {}, {:.2g} % of the area: that part is made up", counted(filled->n_holes, "hole", "holes"),
                                counted(filled->n_new, "triangle", "triangles"), 100 * filled->new_share));
    return filled->new_share;
  }
  const double diagonal = bounding_box(surface.vertices).diagonal();
  if (!(diagonal > 0)) throw InputError(why);
  Surface<3> wrap = wrapped(surface, gap * diagonal, distance * diagonal);
  if (wrap.facets.empty()) throw_input_error("{} (and no wrap could be made)", why);
  if (encloses_next_to_nothing(wrap, distance * diagonal))
    throw_input_error("{} (it encloses next to nothing even where gaps up to {:.3g} are bridged)", why, gap * diagonal);
  notes.push_back(fmt::format("not closed, and wrapped: the surface that is matched lies {:.3g} outside of the file's and bridges gaps up to {:.3g}",
                              distance * diagonal, gap * diagonal));
  surface = std::move(wrap);
  return 1;
}

}  // namespace shellmatch
