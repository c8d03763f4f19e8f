#include "geometry/repair/repair.h"

#include "base/error.h"
#include "base/stop.h"
#include "base/text.h"
#include "geometry/repair/close_surface.h"
#include "geometry/repair/flat_triangles.h"
#include "geometry/repair/repair_steps.h"
#include "geometry/surface/self_intersections.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <utility>

namespace shellmatch {
namespace {

// A volume below this share of the cubed diagonal of a part is a rounding error.
constexpr double flat_share = 1e-9;
// Of the mean edge: coordinates whose steps are longer move triangles visibly.
constexpr double most_step = 0.1;

class Notes {
 public:
  explicit Notes(std::vector<std::string>& notes) : notes_(notes) {}
  void add(std::size_t n, std::string_view singular, std::string_view plural, std::string_view what) {
    if (n > 0) notes_.push_back(fmt::format("{} {}", counted(n, singular, plural), what));
  }

 private:
  std::vector<std::string>& notes_;
};

struct PartMeasure {
  double volume = 0, diagonal = 0;
  bool is_flat() const { return std::abs(volume) <= flat_share * diagonal * diagonal * diagonal; }
};

PartMeasure measure(const Surface<3>& surface, const std::vector<Index>& part) {
  Box<3> box;
  for (const Index f : part)
    for (const Index v : surface.facets[f]) box.add(surface.vertices[v]);
  PartMeasure result;
  result.diagonal = box.diagonal();
  // The centre of the box as origin avoids cancellation for shapes far from 0.
  const Vec<3> centre = 0.5 * (box.min + box.max);
  for (const Index f : part) {
    const auto& [a, b, c] = surface.facets[f];
    result.volume +=
        (surface.vertices[a] - centre).dot((surface.vertices[b] - centre).cross(surface.vertices[c] - centre)) / 6;
  }
  return result;
}

void orient_outward(Surface<3>& surface, const std::string& source, Notes& notes) {
  std::vector<std::vector<Index>> parts;
  std::vector<PartMeasure> measures;
  std::size_t n_flat = 0;
  for (std::vector<Index>& part : connected_parts(surface)) {
    const PartMeasure m = measure(surface, part);
    if (m.is_flat()) {
      ++n_flat;
      continue;
    }
    parts.push_back(std::move(part));
    measures.push_back(m);
  }
  if (parts.empty()) throw_input_error("{}: the surface encloses no volume; it is flat", source);
  notes.add(n_flat, "flat closed part", "flat closed parts", "removed");
  const std::vector<int> depths = nesting_depths(surface, parts);
  std::size_t n_turned = 0, n_cavities = 0;
  Triangles kept;
  for (std::size_t p = 0; p < parts.size(); ++p) {
    const bool cavity = depths[p] % 2 == 1;
    const bool turn = (measures[p].volume < 0) != cavity;
    n_cavities += cavity ? 1 : 0;
    n_turned += turn ? 1 : 0;
    for (const Index f : parts[p]) {
      if (turn) std::swap(surface.facets[f][1], surface.facets[f][2]);
      kept.push_back(surface.facets[f]);
    }
  }
  surface.facets = std::move(kept);
  notes.add(n_cavities, "part lies", "parts lie", "inside another and bound cavities");
  notes.add(n_turned, "connected part", "connected parts", "turned inside out, to face outward");
}

// What to say of coordinates in single precision so far from the origin that its steps are about as long as the edges;
// empty otherwise.
std::string used_up_precision(const OriginalShape<3>& original) {
  if (original.vertices.empty()) return "";
  const auto is_single = [](double a) { return static_cast<double>(static_cast<float>(a)) == a; };
  const auto in_single = [&](const Vec<3>& x) { return is_single(x.x()) && is_single(x.y()) && is_single(x.z()); };
  if (!std::ranges::all_of(original.vertices, in_single)) return "";
  const Box<3> box = bounding_box(original.vertices);
  const double largest = box.min.cwiseAbs().cwiseMax(box.max.cwiseAbs()).maxCoeff();
  double sum = 0;
  std::size_t n = 0;
  for (const std::vector<Index>& polygon : original.polygons)
    for (std::size_t k = 0; k < polygon.size(); ++k, ++n)
      sum += (original.vertices[polygon[k]] - original.vertices[polygon[(k + 1) % polygon.size()]]).norm();
  const double step = largest > 0 ? std::ldexp(1.0, std::ilogb(largest) - 23) : 0,
               edge = n > 0 ? sum / static_cast<double>(n) : 0;
  if (!(step > most_step * edge)) return "";
  return fmt::format(
      "single precision is used up: {:.3g} from the origin its steps are {:.3g} long, and the mean edge is {:.3g}; "
      "write the file in "
      "double precision, or move the shape to the origin before it is written",
      largest, step, edge);
}

MendedSurface mend(const OriginalShape<3>& original, const std::string& source, std::vector<std::string>& note_list,
                   Closing closing) {
  if (original.polygons.empty())
    throw_input_error("{}: no faces, only {}; a closed surface is needed", source,
                      counted(original.vertices.size(), "vertex", "vertices"));
  Activity mending("mending", 5);
  mending.next();
  Notes notes(note_list);
  std::size_t n_given_up = 0;
  Surface<3> surface{original.vertices, triangulate(original, nullptr, &n_given_up)};
  const auto n_split = std::count_if(original.polygons.begin(), original.polygons.end(),
                                     [](const std::vector<Index>& p) { return p.size() > 3; });
  notes.add(static_cast<std::size_t>(n_split), "polygon", "polygons", "split into triangles");
  notes.add(n_given_up, "polygon", "polygons",
            "with too many crossings of the edges split into triangles that overlap");
  notes.add(remove_unused_vertices(surface), "unused vertex", "unused vertices", "left out");
  notes.add(weld_seams(surface), "duplicate vertex", "duplicate vertices", "welded");
  mending.next();
  const auto [n_collapsed, n_copies] = remove_repetitions(surface);
  notes.add(n_collapsed, "triangle", "triangles", "with a repeated corner removed");
  notes.add(n_copies, "repeated triangle", "repeated triangles", "removed");
  if (surface.facets.empty()) throw_input_error("{}: the faces have no area; a closed surface is needed", source);
  const double negligible = negligible_length(surface.vertices);
  const bool automatic = closing == Closing::automatic;
  if (!automatic) check_closed(surface, source);
  mending.next();
  std::size_t n_flat = dissolve_flat_triangles(surface, negligible);
  Closure closure;
  if (automatic) {
    notes.add(stitch_cracks(surface, negligible), "border edge", "border edges", "of cracks without width closed");
    closure = close_surface(surface, source, note_list);
  }
  check_closed(surface, source);

  const Orientation orientation = orient_consistently(surface);
  notes.add(orientation.n_turned, "triangle", "triangles", "turned to agree with the neighbours");
  try {
    check_closed(surface, source);
  } catch (const InputError&) {
    const std::string why =
        source + ": the surface is one-sided, as a Klein bottle is: inside and outside cannot be told apart";
    if (!automatic) throw InputError(why);
    closure = wrap_surface(surface, "one-sided", why, note_list);
  }
  notes.add(orientation.n_split, "vertex", "vertices", "added where the surface touches itself");
  if (flat_triangles(surface, 0).size() == surface.facets.size())
    throw_input_error("{}: the surface encloses no volume; its faces have no area", source);
  mending.next();
  n_flat += dissolve_flat_triangles(surface, negligible);
  notes.add(n_flat, "triangle", "triangles", "without area removed");
  mending.next();
  orient_outward(surface, source, notes);
  remove_unused_vertices(surface);
  std::vector<Index> crossing;
  if (surface.facets.size() <= self_intersection_limit) crossing = self_intersecting_facets(surface);
  notes.add(crossing.size(), "triangle", "triangles", "that cross or touch others (left as they are)");
  return {std::move(surface), std::move(closure.evidence), closure.invented_share, std::move(crossing)};
}

}  // namespace

MendedSurface mend_surface(const OriginalShape<3>& original, const std::string& source, std::vector<std::string>& notes,
                           Closing closing) {
  const std::string precision = used_up_precision(original);
  if (!precision.empty()) notes.push_back(precision);
  try {
    return mend(original, source, notes, closing);
  } catch (const InputError& error) {
    if (precision.empty()) throw;
    throw InputError(fmt::format("{}; {}", error.what(), precision));
  }
}

}  // namespace shellmatch
