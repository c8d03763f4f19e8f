#include "base/error.h"
#include "base/text.h"
#include "geometry/repair/repair.h"
#include "geometry/repair/repair_steps.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

namespace shellmatch {
namespace {

struct Ring {
  std::vector<Index> points;  // of the original
  Box<2> box;
  double area = 0;  // signed
};

using Coordinates = std::pair<double, double>;

// Splits a ring where it returns to a visited point: the loop in between becomes a ring. A loop of two points
// is a spike without width and is removed. The remaining rings visit no point twice; their orientation is
// determined later by the depth of nesting.
std::vector<std::vector<Index>> simple_loops(const std::vector<Index>& ring, const std::vector<Vec<2>>& x,
                                             std::size_t& n_spikes) {
  std::vector<std::vector<Index>> loops;
  std::vector<Index> path;
  std::map<Coordinates, std::size_t> place_in_path;
  const auto key = [&](Index v) { return Coordinates(x[v].x(), x[v].y()); };
  const auto close = [&](std::size_t from) {
    if (path.size() - from > 2) loops.emplace_back(path.begin() + static_cast<std::ptrdiff_t>(from), path.end());
    else ++n_spikes;
    for (std::size_t k = from; k < path.size(); ++k) place_in_path.erase(key(path[k]));
    path.resize(from);
  };
  for (const Index v : ring) {
    const auto visited = place_in_path.find(key(v));
    if (visited != place_in_path.end()) close(visited->second);
    place_in_path[key(v)] = path.size();
    path.push_back(v);
  }
  // After the removal of a spike, a single point may remain.
  if (path.size() > 1) close(0);
  return loops;
}

struct Repairs {
  std::size_t n_repeated = 0, n_spikes = 0, n_touches = 0;
};

std::vector<Index> without_repetitions(const OriginalShape<2>& original, std::size_t number, const std::string& source,
                                       Repairs& repairs) {
  const std::vector<Index>& polygon = original.polygons[number];
  const auto& x = original.vertices;
  std::vector<Index> points;
  for (const Index v : polygon)
    if (points.empty() || x[points.back()] != x[v]) points.push_back(v);
  while (points.size() > 1 && x[points.back()] == x[points.front()]) points.pop_back();
  repairs.n_repeated += polygon.size() - points.size();
  if (points.size() < 3)
    throw_input_error("{}: ring {} has only {} (point {} on); a closed outline needs three or more", source, number + 1,
                      counted(points.size(), "different point", "different points"),
                      polygon.empty() ? 0 : polygon[0] + 1);
  return points;
}

// A ring that is cut off is closed by a segment from its last point to its first, which is much longer than the others.
void note_long_closing_edge(const std::vector<Index>& ring, const std::vector<Vec<2>>& x, std::size_t number,
                            std::vector<std::string>& notes) {
  constexpr double much = 5;
  double longest = 0;
  for (std::size_t k = 0; k + 1 < ring.size(); ++k) longest = std::max(longest, (x[ring[k + 1]] - x[ring[k]]).norm());
  const double closing = (x[ring.front()] - x[ring.back()]).norm();
  if (closing > much * longest)
    notes.push_back(fmt::format(
        "ring {} is closed by a segment of length {:.3g}, {:.3g} times the longest other one: is it cut off?",
        number + 1, closing, closing / longest));
}

// All pairs of segments that end in one point are looked at, so that their number is limited.
void check_number_of_visits(const std::vector<std::vector<Index>>& rings, const std::vector<Vec<2>>& x,
                            const std::string& source) {
  constexpr std::size_t most = 1000;
  std::map<Coordinates, std::size_t> n_visits;
  for (const std::vector<Index>& ring : rings)
    for (const Index v : ring)
      if (++n_visits[{x[v].x(), x[v].y()}] > most)
        throw_input_error(
            "{}: the outline passes through ({:.6g}, {:.6g}) more than {} times; move or remove points there", source,
            x[v].x(), x[v].y(), most);
}

// Segments of all rings, in their order.
Surface<2> segments_of(const std::vector<Vec<2>>& vertices, const std::vector<std::vector<Index>>& rings) {
  Surface<2> all{vertices, {}};
  for (const std::vector<Index>& ring : rings)
    for (std::size_t k = 0; k < ring.size(); ++k) all.facets.push_back({ring[k], ring[(k + 1) % ring.size()]});
  return all;
}

// Inserts vertices that lie on a segment into the segment.
void share_touching_points(const std::vector<Vec<2>>& vertices, std::vector<std::vector<Index>>& rings) {
  const auto touching = touching_vertices(segments_of(vertices, rings));
  auto next = touching.begin();
  Index segment = 0;
  for (std::vector<Index>& ring : rings) {
    std::vector<Index> longer;
    for (const Index v : ring) {
      longer.push_back(v);
      for (; next != touching.end() && next->first == segment; ++next)
        if (vertices[longer.back()] != vertices[next->second]) longer.push_back(next->second);
      ++segment;
    }
    ring = std::move(longer);
  }
}

void add_rings(const std::vector<Index>& points, const std::vector<Vec<2>>& x, std::size_t number,
               const std::string& source, std::vector<Ring>& rings, Repairs& repairs) {
  const std::vector<std::vector<Index>> loops = simple_loops(points, x, repairs.n_spikes);
  if (loops.empty())
    throw_input_error("{}: ring {} (point {} on) has no area: it goes back the way it came", source, number + 1,
                      points[0] + 1);
  repairs.n_touches += loops.size() - 1;
  for (const std::vector<Index>& loop : loops) {
    Ring ring{loop, {}, 0};
    for (std::size_t k = 0; k < loop.size(); ++k) {
      const Vec<2> a = x[loop[k]] - x[loop[0]], b = x[loop[(k + 1) % loop.size()]] - x[loop[0]];
      ring.area += 0.5 * (a.x() * b.y() - a.y() * b.x());
      ring.box.add(x[loop[k]]);
    }
    rings.push_back(std::move(ring));
  }
}

// Beyond this number the outline is noise, and where it crosses itself is of no help.
constexpr std::size_t max_crossings = 1000;

void check_crossings(const Surface<2>& outline, const std::string& source, Contact contact, std::size_t allowed) {
  const auto found = crossing_segments(outline, contact, max_crossings);
  if (found.size() <= allowed) return;
  std::string places;
  const std::size_t n_shown = std::min<std::size_t>(found.size(), 3);
  for (std::size_t i = 0; i < n_shown; ++i) {
    const auto& [f, g] = found[i];
    const Vec<2> x = crossing_point(outline, f, g);
    places +=
        fmt::format("{}segments {}-{} and {}-{} at ({:.6g}, {:.6g})", i == 0 ? "" : ", ", outline.facets[f][0] + 1,
                    outline.facets[f][1] + 1, outline.facets[g][0] + 1, outline.facets[g][1] + 1, x.x(), x.y());
  }
  throw_input_error(
      "{}: the outline crosses or touches itself in {}: {}{} (points counted from 1); move or remove "
      "points there",
      source,
      found.size() > max_crossings ? fmt::format("more than {} places", max_crossings)
                                   : counted(found.size(), "place", "places"),
      places, found.size() > n_shown ? ", ..." : "");
}

// Rings may have points in common, but not pass through each other there. \pre they meet nowhere else
void check_common_points(const std::vector<std::vector<Index>>& rings, const std::vector<Vec<2>>& x,
                         const std::string& source) {
  struct Visit {
    Index before, after;
  };
  std::map<Coordinates, std::vector<Visit>> visits;
  for (const std::vector<Index>& ring : rings)
    for (std::size_t k = 0; k < ring.size(); ++k)
      visits[{x[ring[k]].x(), x[ring[k]].y()}].push_back(
          {ring[(k + ring.size() - 1) % ring.size()], ring[(k + 1) % ring.size()]});
  for (const auto& [place, paths] : visits)
    for (std::size_t i = 0; i < paths.size(); ++i)
      for (std::size_t j = 0; j < i; ++j)
        if (pass_through_at({place.first, place.second}, x[paths[i].before], x[paths[i].after], x[paths[j].before],
                            x[paths[j].after]))
          throw_input_error(
              "{}: two rings cross at ({:.6g}, {:.6g}), which is a point of both; move or remove points there", source,
              place.first, place.second);
}

// Crossing number of the ray to the right; x lies on no segment.
bool is_inside(const Vec<2>& x, const Ring& ring, const std::vector<Vec<2>>& points) {
  bool inside = false;
  for (std::size_t k = 0; k < ring.points.size(); ++k) {
    const Vec<2>& a = points[ring.points[k]];
    const Vec<2>& b = points[ring.points[(k + 1) % ring.points.size()]];
    if ((a.y() > x.y()) == (b.y() > x.y())) continue;
    const double turn = (b.x() - a.x()) * (x.y() - a.y()) - (b.y() - a.y()) * (x.x() - a.x());
    if ((turn > 0) == (b.y() > a.y())) inside = !inside;
  }
  return inside;
}

int nesting_depth(std::size_t number, const std::vector<Ring>& rings, const std::vector<Vec<2>>& points) {
  // Rings may share points but not parts of segments.
  const std::vector<Index>& ring = rings[number].points;
  const Vec<2> x = 0.5 * (points[ring[0]] + points[ring[1]]);
  int depth = 0;
  for (std::size_t other = 0; other < rings.size(); ++other) {
    const Box<2>& box = rings[other].box;
    if (other == number || (x.array() < box.min.array()).any() || (x.array() > box.max.array()).any()) continue;
    depth += is_inside(x, rings[other], points) ? 1 : 0;
  }
  return depth;
}

// Products of smaller numbers vanish, and with them the sides of points. Shapes are at least 1e-50 large
// (make_shape.cpp).
constexpr double vanishing = 1e-100;

bool is_vanishing(double x) { return x != 0 && std::abs(x) < vanishing; }

}  // namespace

Surface<2> mend_outline(const OriginalShape<2>& original, const std::string& source, std::vector<std::string>& notes) {
  if (original.polygons.empty()) throw_input_error("{}: no outline in it", source);
  if (std::ranges::any_of(original.vertices,
                          [](const Vec<2>& x) { return is_vanishing(x.x()) || is_vanishing(x.y()); })) {
    OriginalShape<2> rounded{original.vertices, original.polygons, {}};
    for (Vec<2>& x : rounded.vertices)
      for (double& coordinate : x)
        if (is_vanishing(coordinate)) coordinate = 0;
    return mend_outline(rounded, source, notes);
  }
  Repairs repairs;
  std::vector<std::vector<Index>> polygons;
  for (std::size_t number = 0; number < original.polygons.size(); ++number)
    polygons.push_back(without_repetitions(original, number, source, repairs));
  for (std::size_t number = 0; number < polygons.size(); ++number)
    note_long_closing_edge(polygons[number], original.vertices, number, notes);
  check_number_of_visits(polygons, original.vertices, source);
  // Segments that touch are joined below, which takes time for each pair that is near: not for noise.
  check_crossings(segments_of(original.vertices, polygons), source, Contact::of_inner_points, max_crossings);
  share_touching_points(original.vertices, polygons);
  std::vector<Ring> rings;
  for (std::size_t number = 0; number < polygons.size(); ++number)
    add_rings(polygons[number], original.vertices, number, source, rings, repairs);

  // The messages number points as in the file, so the test uses the original points.
  polygons.clear();
  for (const Ring& ring : rings) polygons.push_back(ring.points);
  const Surface<2> all = segments_of(original.vertices, polygons);
  check_crossings(all, source, Contact::any, 0);
  check_common_points(polygons, original.vertices, source);

  Surface<2> outline;
  std::size_t n_turned = 0, n_holes = 0;
  for (std::size_t number = 0; number < rings.size(); ++number) {
    Ring& ring = rings[number];
    const bool hole = nesting_depth(number, rings, original.vertices) % 2 == 1;
    n_holes += hole ? 1 : 0;
    if ((ring.area < 0) != hole) {
      std::reverse(ring.points.begin(), ring.points.end());
      ++n_turned;
    }
    const auto first = static_cast<Index>(outline.vertices.size());
    const auto n = static_cast<Index>(ring.points.size());
    for (Index k = 0; k < n; ++k) {
      outline.vertices.push_back(original.vertices[ring.points[k]]);
      outline.facets.push_back({first + k, first + (k + 1) % n});
    }
  }
  if (repairs.n_repeated > 0)
    notes.push_back(counted(repairs.n_repeated, "repeated point", "repeated points") + " left out");
  if (repairs.n_spikes > 0) notes.push_back(counted(repairs.n_spikes, "spike", "spikes") + " without width removed");
  if (repairs.n_touches > 0)
    notes.push_back(counted(repairs.n_touches, "loop", "loops") + " cut off where an outline touches itself");
  if (n_holes > 0) notes.push_back(counted(n_holes, "ring is a hole", "rings are holes"));
  if (n_turned > 0)
    notes.push_back(counted(n_turned, "ring", "rings") +
                    " turned round (outlines run counter-clockwise, holes clockwise)");
  return outline;
}

}  // namespace shellmatch
