#include "geometry/surface/overlapping_boxes.h"
#include "geometry/surface/self_intersections.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <algorithm>
#include <utility>

namespace shellmatch {

namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;

Kernel::Point_2 cgal_point(const Vec<2>& x) { return {x[0], x[1]}; }
Kernel::Point_3 cgal_point(const Vec<3>& x) { return {x[0], x[1], x[2]}; }

/// The corners of a facet in its cyclic order, beginning with its i-th.
template <int Dim>
std::array<Index, Dim> rotated(std::array<Index, Dim> facet, int i) {
  std::rotate(facet.begin(), facet.begin() + i, facet.end());
  return facet;
}

/// Turns both facets so that corners they share come first, and returns how many they share.
template <int Dim>
int align_shared_corners(std::array<Index, Dim>& f, std::array<Index, Dim>& g) {
  int n_shared = 0;
  for (const Index v : f) n_shared += static_cast<int>(std::count(g.begin(), g.end(), v));
  if (n_shared == 0 || n_shared == Dim) return n_shared;
  const auto holds = [](const std::array<Index, Dim>& facet, Index v) {
    return std::find(facet.begin(), facet.end(), v) != facet.end();
  };
  for (int i = 0; i < Dim && !(holds(g, f[0]) && (n_shared == 1 || holds(g, f[1]))); ++i) f = rotated<Dim>(f, 1);
  for (int i = 0; i < Dim && !(holds(f, g[0]) && (n_shared == 1 || holds(f, g[1]))); ++i) g = rotated<Dim>(g, 1);
  return n_shared;
}

bool is_flat(const Surface<2>& s, const std::array<Index, 2>& f) { return s.vertices[f[0]] == s.vertices[f[1]]; }
bool is_flat(const Surface<3>& s, const std::array<Index, 3>& f) {
  return CGAL::collinear(cgal_point(s.vertices[f[0]]), cgal_point(s.vertices[f[1]]), cgal_point(s.vertices[f[2]]));
}

bool meet(const Surface<2>& s, std::array<Index, 2> f, std::array<Index, 2> g) {
  const int n_shared = align_shared_corners<2>(f, g);
  const auto point = [&](Index v) { return cgal_point(s.vertices[v]); };
  if (n_shared == 2) return true;
  // Segments with a common end overlap where they leave it in the same direction.
  if (n_shared == 1)
    return CGAL::collinear(point(f[0]), point(f[1]), point(g[1])) &&
           !CGAL::collinear_are_strictly_ordered_along_line(point(f[1]), point(f[0]), point(g[1]));
  return CGAL::do_intersect(Kernel::Segment_2(point(f[0]), point(f[1])), Kernel::Segment_2(point(g[0]), point(g[1])));
}

bool meet(const Surface<3>& s, std::array<Index, 3> f, std::array<Index, 3> g) {
  const int n_shared = align_shared_corners<3>(f, g);
  const auto point = [&](Index v) { return cgal_point(s.vertices[v]); };
  const auto triangle = [&](const std::array<Index, 3>& t) {
    return Kernel::Triangle_3(point(t[0]), point(t[1]), point(t[2]));
  };
  const auto opposite_edge = [&](const std::array<Index, 3>& t) { return Kernel::Segment_3(point(t[1]), point(t[2])); };
  if (n_shared == 3) return true;
  // Triangles with a common edge overlap where they lie in one plane on the same side of it.
  if (n_shared == 2)
    return CGAL::coplanar(point(f[0]), point(f[1]), point(f[2]), point(g[2])) &&
           CGAL::coplanar_orientation(point(f[0]), point(f[1]), point(f[2]), point(g[2])) == CGAL::POSITIVE;
  // Triangles with a common corner meet elsewhere only if the edge opposite to it of one of them does.
  if (n_shared == 1)
    return CGAL::do_intersect(triangle(f), opposite_edge(g)) || CGAL::do_intersect(triangle(g), opposite_edge(f));
  return CGAL::do_intersect(triangle(f), triangle(g));
}

template <int Dim>
std::vector<Index> find(const Surface<Dim>& surface) {
  std::vector<Box<Dim>> boxes;
  std::vector<Index> facet_of;
  for (std::size_t f = 0; f < surface.facets.size(); ++f) {
    if (is_flat(surface, surface.facets[f])) continue;
    facet_of.push_back(static_cast<Index>(f));
    Box<Dim>& box = boxes.emplace_back();
    for (const Index v : surface.facets[f]) box.add(surface.vertices[v]);
  }
  std::vector<bool> found(surface.facets.size(), false);
  for_overlapping_boxes(boxes, [&](std::size_t a, std::size_t b) {
    const Index f = facet_of[a], g = facet_of[b];
    if (found[f] && found[g]) return;
    if (meet(surface, surface.facets[f], surface.facets[g])) found[f] = found[g] = true;
  });
  std::vector<Index> facets;
  for (std::size_t f = 0; f < found.size(); ++f)
    if (found[f]) facets.push_back(static_cast<Index>(f));
  return facets;
}

}  // namespace

std::vector<Index> self_intersecting_facets(const Surface<2>& surface) { return find(surface); }
std::vector<Index> self_intersecting_facets(const Surface<3>& surface) { return find(surface); }

}  // namespace shellmatch
