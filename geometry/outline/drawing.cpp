#include "geometry/outline/drawing.h"

#include "base/error.h"
#include "base/printable.h"
#include "base/text.h"

#include <fmt/ranges.h>

#include <algorithm>
#include <limits>
#include <utility>

namespace shellmatch {

namespace {

using Rings = std::vector<std::vector<Vec<2>>>;

bool is_named(const std::vector<std::string>& names, const std::string& part) {
  return std::ranges::find(names, part) != names.end();
}

// The areas that are asked for; others go.
void choose(Drawing& drawing, const std::string& source, const std::string& part) {
  if (part.empty()) return;
  std::vector<char> group_is_meant;
  // Parents stand before their children.
  for (const DrawnGroup& group : drawing.groups)
    group_is_meant.push_back(is_named(group.names, part) || (group.parent != no_group && group_is_meant[group.parent]));
  const bool is_area =
      std::ranges::any_of(drawing.areas, [&](const DrawnArea& area) { return is_named(area.names, part); });
  std::vector<std::string> names;
  for (const DrawnArea& area : drawing.areas)
    if (!area.names.empty()) names.push_back(area.names.front());
  std::erase_if(drawing.areas, [&](const DrawnArea& area) {
    return is_area ? !is_named(area.names, part) : area.group == no_group || !group_is_meant[area.group];
  });
  if (drawing.areas.empty())
    throw_input_error("{}: no area is named '{}'; {}", source, printable(part, 60),
                      names.empty() ? "its areas have no names: leave out the colon and what follows"
                                    : "choose one of " + some_names(names));
}

bool is_inside(const Vec<2>& x, const std::vector<Vec<2>>& ring) {
  bool inside = false;
  for (std::size_t k = 0; k < ring.size(); ++k) {
    const Vec<2>&a = ring[k], &b = ring[(k + 1) % ring.size()];
    if ((a.y() > x.y()) == (b.y() > x.y())) continue;
    if (((b.x() - a.x()) * (x.y() - a.y()) > (b.y() - a.y()) * (x.x() - a.x())) == (b.y() > a.y())) inside = !inside;
  }
  return inside;
}

double area_of(const std::vector<Vec<2>>& ring) {
  double sum = 0;
  for (std::size_t k = 1; k + 1 < ring.size(); ++k) {
    const Vec<2> a = ring[k] - ring[0], b = ring[k + 1] - ring[0];
    sum += a.x() * b.y() - a.y() * b.x();
  }
  return sum / 2;
}

// Rings on both sides of which a path turns around points bound nothing. Returns how many they were.
std::size_t drop_inner_turns(Rings& rings) {
  std::vector<Box<2>> boxes;
  for (const auto& ring : rings) boxes.push_back(bounding_box(ring));
  std::vector<char> bounds;
  for (std::size_t i = 0; i < rings.size(); ++i) {
    const Vec<2> x = 0.5 * (rings[i][0] + rings[i][1]);
    int turns = 0;
    for (std::size_t j = 0; j < rings.size(); ++j) {
      const bool is_near = (x.array() >= boxes[j].min.array()).all() && (x.array() <= boxes[j].max.array()).all();
      if (j != i && is_near && is_inside(x, rings[j])) turns += area_of(rings[j]) > 0 ? 1 : -1;
    }
    bounds.push_back((turns == 0) != (turns + (area_of(rings[i]) > 0 ? 1 : -1) == 0));
  }
  std::size_t i = 0;
  return std::erase_if(rings, [&](const auto&) { return !bounds[i++]; });
}

void check_finite(const Drawing& drawing, const std::string& source) {
  for (const DrawnArea& area : drawing.areas)
    for (const DrawnPath& path : area.paths) {
      bool is_finite = path.start.allFinite();
      for (const PathPiece& piece : path.pieces)
        is_finite = is_finite && piece.end.allFinite() && piece.control[0].allFinite() && piece.control[1].allFinite();
      if (!is_finite)
        throw_input_error("{}: a coordinate{} is not finite or too large; correct it", source,
                          area.names.empty() ? "" : fmt::format(" of '{}'", printable(area.names.front(), 60)));
    }
}

// With the control points of curves.
double diagonal_of(const Drawing& drawing) {
  Box<2> box;
  for (const DrawnArea& area : drawing.areas)
    for (const DrawnPath& path : area.paths) {
      box.add(path.start);
      for (const PathPiece& piece : path.pieces) {
        box.add(piece.end);
        for (const Vec<2>& c : piece.control) box.add(c);
      }
    }
  return box.diagonal();
}

struct Counts {
  std::size_t n_lines = 0, n_open = 0, n_inner = 0, n_curved = 0;
};

Rings rings_of(const DrawnArea& area, double tolerance, Counts& counts) {
  Rings rings;
  for (const DrawnPath& path : area.paths) {
    std::vector<Vec<2>> ring = flattened(path, tolerance);
    if (ring.size() < 3) {
      ++counts.n_lines;
      continue;
    }
    counts.n_open += !path.is_closed && path.end() != path.start;
    counts.n_curved += std::ranges::any_of(path.pieces, &PathPiece::is_curve);
    rings.push_back(std::move(ring));
  }
  if (area.is_filled_by_turns && rings.size() > 1) counts.n_inner += drop_inner_turns(rings);
  return rings;
}

}  // namespace

std::string some_names(const std::vector<std::string>& names) {
  constexpr std::size_t most = 10;
  std::string text;
  for (std::size_t i = 0; i < std::min(most, names.size()); ++i)
    text += fmt::format("{}'{}'", i == 0 ? "" : ", ", printable(names[i], 40));
  return text + (names.size() > most ? fmt::format(", ... ({} in all)", names.size()) : "");
}

DrawnOutline outline_of_drawing(Drawing drawing, const std::string& source, const std::string& part) {
  if (drawing.areas.empty())
    throw_input_error("{}: no area in it{}; draw the outline as a closed one", source,
                      drawing.notes.empty() ? "" : fmt::format(" ({})", fmt::join(drawing.notes, "; ")));
  choose(drawing, source, part);
  check_finite(drawing, source);
  DrawnOutline result{{}, std::move(drawing.notes), std::move(drawing.unit), {}};
  result.shape.frame = {drawing.scale, drawing.is_downward ? -drawing.scale : drawing.scale, 0};
  Counts counts;
  std::vector<std::string> names;
  // Of points in one place the diagonal is 0.
  const double tolerance = std::max(curve_tolerance * diagonal_of(drawing), std::numeric_limits<double>::min());
  if (!(tolerance <= std::numeric_limits<double>::max()))
    throw_input_error("{}: its coordinates are too large; scale the drawing", source);
  for (const DrawnArea& area : drawing.areas) {
    if (!area.names.empty()) names.push_back(area.names.front());
    for (const std::vector<Vec<2>>& ring : rings_of(area, tolerance, counts)) {
      std::vector<Index> polygon;
      for (const Vec<2>& x : ring) {
        polygon.push_back(static_cast<Index>(result.shape.vertices.size()));
        result.shape.vertices.push_back(result.shape.frame(x));
        if (!result.shape.vertices.back().allFinite())
          throw_input_error("{}: its coordinates are too large; scale the drawing", source);
      }
      result.shape.polygons.push_back(std::move(polygon));
    }
  }
  if (result.shape.polygons.empty())
    throw_input_error("{}: what is drawn has no area: lines of two points; draw a closed outline", source);
  const auto note = [&](std::string text) { result.notes.push_back(std::move(text)); };
  if (drawing.areas.size() > 1) {
    result.choices = some_names(names);
    note(fmt::format("{} areas taken together{}", drawing.areas.size(),
                     names.empty() ? "" : fmt::format(": {}; FILE:NAME chooses", result.choices)));
  }
  if (counts.n_lines > 0) note(counted(counts.n_lines, "line", "lines") + " without area left out");
  if (counts.n_open > 0) note(counted(counts.n_open, "open path", "open paths") + " closed by a line");
  if (counts.n_inner > 0)
    note(counted(counts.n_inner, "ring", "rings") +
         " within an area left out: the fill rule 'nonzero' fills both sides");
  if (counts.n_curved > 0) note(fmt::format("curves flattened to {:g} diagonals", curve_tolerance));
  if (drawing.is_downward)
    note(
        "y points down in the file and up in the result: y = -y, also of landmarks given as CSV; give other points "
        "turned (docs/outlines.md)");
  return result;
}

}  // namespace shellmatch
