#include "geometry/repair/repair_steps.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/box_intersection_d.h>

#include <algorithm>
#include <tuple>

namespace shellmatch {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point = Kernel::Point_2;
using SegmentBox = CGAL::Box_intersection_d::Box_with_info_d<double, 2, Index>;

Point outline_point(const Surface<2>& outline, Index v) { return {outline.vertices[v].x(), outline.vertices[v].y()}; }

// Segments a -> b -> c fold back onto each other.
bool fold_back(const Point& a, const Point& b, const Point& c) {
  return CGAL::collinear(a, b, c) && CGAL::angle(a, b, c) == CGAL::ACUTE;
}

bool meet(const Surface<2>& outline, Index f, Index g) {
  const auto& [a, b] = outline.facets[f];
  const auto& [c, d] = outline.facets[g];
  const Point pa = outline_point(outline, a), pb = outline_point(outline, b), pc = outline_point(outline, c),
              pd = outline_point(outline, d);
  // A common end is no crossing, unless the segments run on top of each other from there.
  if (pb == pc) return fold_back(pa, pb, pd);
  if (pa == pd) return fold_back(pb, pa, pc);
  if (pa == pc) return fold_back(pb, pa, pd);
  if (pb == pd) return fold_back(pa, pb, pc);
  return CGAL::do_intersect(Kernel::Segment_2(pa, pb), Kernel::Segment_2(pc, pd));
}

// Two segments without a common end that pass through each other.
bool pass_through(const Surface<2>& outline, Index f, Index g) {
  const auto& [a, b] = outline.facets[f];
  const auto& [c, d] = outline.facets[g];
  const Point pa = outline_point(outline, a), pb = outline_point(outline, b), pc = outline_point(outline, c),
              pd = outline_point(outline, d);
  return CGAL::orientation(pa, pb, pc) * CGAL::orientation(pa, pb, pd) == CGAL::NEGATIVE &&
         CGAL::orientation(pc, pd, pa) * CGAL::orientation(pc, pd, pb) == CGAL::NEGATIVE;
}

// Calls visit(f, g), f < g, for all pairs of segments whose boxes meet.
template <class Visit>
void for_each_near_pair(const Surface<2>& outline, Visit&& visit) {
  std::vector<SegmentBox> boxes;
  for (std::size_t f = 0; f < outline.facets.size(); ++f) {
    const auto& [a, b] = outline.facets[f];
    boxes.emplace_back(outline_point(outline, a).bbox() + outline_point(outline, b).bbox(), static_cast<Index>(f));
  }
  CGAL::box_self_intersection_d(boxes.begin(), boxes.end(), [&](const SegmentBox& one, const SegmentBox& two) {
    visit(std::min(one.info(), two.info()), std::max(one.info(), two.info()));
  });
}

}  // namespace

std::vector<std::pair<Index, Index>> crossing_segments(const Surface<2>& outline, Contact contact, std::size_t most) {
  struct Enough {};  // CGAL's search ends by an exception only
  std::vector<std::pair<Index, Index>> found;
  try {
    for_each_near_pair(outline, [&](Index f, Index g) {
      if (contact == Contact::any ? !meet(outline, f, g) : !pass_through(outline, f, g)) return;
      found.emplace_back(f, g);
      if (found.size() > most) throw Enough();
    });
  } catch (const Enough&) {
  }
  std::sort(found.begin(), found.end());
  return found;
}

std::vector<std::pair<Index, Index>> touching_vertices(const Surface<2>& outline) {
  std::vector<std::pair<Index, Index>> found;
  const auto look = [&](Index f, Index v) {
    const auto& [a, b] = outline.facets[f];
    if (CGAL::collinear(outline_point(outline, a), outline_point(outline, v), outline_point(outline, b)) &&
        CGAL::collinear_are_strictly_ordered_along_line(outline_point(outline, a), outline_point(outline, v),
                                                        outline_point(outline, b)))
      found.emplace_back(f, v);
  };
  for_each_near_pair(outline, [&](Index f, Index g) {
    for (const Index v : outline.facets[g]) look(f, v);
    for (const Index v : outline.facets[f]) look(g, v);
  });
  const auto order = [&](const std::pair<Index, Index>& one) {
    const Vec<2> from_end = outline.vertices[one.second] - outline.vertices[outline.facets[one.first][0]];
    return std::make_tuple(one.first, from_end.squaredNorm(), one.second);
  };
  std::sort(found.begin(), found.end(), [&](const auto& one, const auto& two) { return order(one) < order(two); });
  found.erase(std::unique(found.begin(), found.end()), found.end());
  return found;
}

bool pass_through_at(const Vec<2>& p, const Vec<2>& a, const Vec<2>& b, const Vec<2>& c, const Vec<2>& d) {
  const auto turns_left = [](const Vec<2>& x, const Vec<2>& y, const Vec<2>& z) {
    return CGAL::orientation(Point(x.x(), x.y()), Point(y.x(), y.y()), Point(z.x(), z.y())) == CGAL::LEFT_TURN;
  };
  const bool narrow = turns_left(a, p, b);
  const auto on_the_left = [&](const Vec<2>& x) {
    const bool of_a = turns_left(a, p, x), of_b = turns_left(p, b, x);
    return narrow ? of_a && of_b : of_a || of_b;
  };
  return on_the_left(c) != on_the_left(d);
}

Vec<2> crossing_point(const Surface<2>& outline, Index f, Index g) {
  const auto& [a, b] = outline.facets[f];
  const auto& [c, d] = outline.facets[g];
  const Vec<2>&pa = outline.vertices[a], &pc = outline.vertices[c];
  const Vec<2> u = outline.vertices[b] - pa, v = outline.vertices[d] - pc, w = pc - pa;
  const double cross = u.x() * v.y() - u.y() * v.x();
  if (cross != 0) return pa + std::clamp((w.x() * v.y() - w.y() * v.x()) / cross, 0.0, 1.0) * u;
  // Parallel: an end of g that lies on f, or else f lies within g.
  for (const Vec<2>& end : {pc, Vec<2>(pc + v)}) {
    const double t = (end - pa).dot(u);
    if (t >= 0 && t <= u.squaredNorm()) return end;
  }
  return pa;
}

}  // namespace shellmatch
