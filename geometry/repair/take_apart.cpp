// Edges with more than two triangles (geometry/repair/flat_triangles.h).
#include "base/disjoint_sets.h"
#include "geometry/repair/flat_triangles.h"
#include "geometry/surface/facet_edges.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>

namespace shellmatch {

namespace {

// Corner k of facet f as one number.
Index corner(Index f, int k) { return 3 * f + k; }

// A side of an edge, by the direction in which its facet lies.
struct Ray {
  double angle;
  bool is_forward;
  const FacetEdge* side;
};

// By angle, from the widest gap on. At equal angles, which rounding makes differ, lie facets of two parts that touch:
// where the wedge between them opens before it closes they are joined to each other, otherwise each to its own part.
void sort_around(std::vector<Ray>& rays, Touching touching) {
  constexpr double rounding = 1e-9;
  std::stable_sort(rays.begin(), rays.end(), [](const Ray& a, const Ray& b) { return a.angle < b.angle; });
  std::size_t first = 0;
  double widest = rays.front().angle + 2 * std::numbers::pi - rays.back().angle;
  for (std::size_t i = 1; i < rays.size(); ++i)
    if (const double gap = rays[i].angle - rays[i - 1].angle; gap > widest) {
      widest = gap;
      first = i;
    }
  for (std::size_t i = 0; i < first; ++i) rays[i].angle += 2 * std::numbers::pi;
  std::rotate(rays.begin(), rays.begin() + static_cast<std::ptrdiff_t>(first), rays.end());
  for (auto begin = rays.begin(); begin != rays.end();) {
    auto end = begin + 1;
    while (end != rays.end() && end->angle - (end - 1)->angle <= rounding) ++end;
    std::stable_partition(begin, end,
                          [&](const Ray& ray) { return ray.is_forward == (touching == Touching::is_apart); });
    begin = end;
  }
}

class Joints {
 public:
  explicit Joints(const Surface<3>& surface) : surface_(surface), sets_(3 * surface.facets.size()) {}

  void join(const FacetEdge& one, const FacetEdge& two) {
    const int one_end = (one.begin + 1) % 3, two_end = (two.begin + 1) % 3;
    const bool opposite = is_forward(one) != is_forward(two);
    sets_.join(corner(one.facet, one.begin), corner(two.facet, opposite ? two_end : two.begin));
    sets_.join(corner(one.facet, one_end), corner(two.facet, opposite ? two.begin : two_end));
  }

  // Around the edge, by angle: the inside lies counter-clockwise of a facet that runs backward and clockwise of one
  // that runs forward. Like brackets, each that opens a wedge is joined to the one that closes it; going round twice
  // finds those beyond the angle 0.
  void join_wedges(const FacetEdge* begin, const FacetEdge* end, Touching touching) {
    const Vec<3>& origin = surface_.vertices[begin->low];
    const Vec<3> axis = surface_.vertices[begin->high] - origin;
    Vec<3> u = axis.unitOrthogonal();
    const Vec<3> v = axis.cross(u).normalized();
    std::vector<Ray> rays;
    for (const FacetEdge* s = begin; s != end; ++s) {
      const Vec<3> r = surface_.vertices[surface_.facets[s->facet][(s->begin + 2) % 3]] - origin;
      rays.push_back({std::atan2(r.dot(v), r.dot(u)), is_forward(*s), s});
    }
    sort_around(rays, touching);
    std::vector<std::size_t> open;
    std::vector<bool> done(rays.size(), false);
    for (std::size_t i = 0; i < 2 * rays.size(); ++i) {
      const std::size_t k = i % rays.size();
      if (done[k]) continue;
      if (!rays[k].is_forward) {
        if (i < rays.size()) open.push_back(k);
      } else if (!open.empty()) {
        join(*rays[open.back()].side, *rays[k].side);
        done[open.back()] = done[k] = true;
        open.pop_back();
      }
    }
  }

  // One vertex for each set of corners; the first set of a vertex keeps it.
  void divide(Surface<3>& surface) {
    std::vector<Index> vertex_of_set(3 * surface.facets.size(), no_index);
    std::vector<bool> taken(surface.vertices.size(), false);
    for (std::size_t f = 0; f < surface.facets.size(); ++f)
      for (int k = 0; k < 3; ++k) {
        Index& vertex = vertex_of_set[sets_.find(corner(static_cast<Index>(f), k))];
        Index& own = surface.facets[f][k];
        if (vertex == no_index) {
          vertex = own;
          if (taken[own]) {
            vertex = static_cast<Index>(surface.vertices.size());
            surface.vertices.push_back(Vec<3>(surface.vertices[own]));
          } else {
            taken[own] = true;
          }
        }
        own = vertex;
      }
  }

 private:
  // Does the side run from its lower end to the higher?
  bool is_forward(const FacetEdge& side) const { return surface_.facets[side.facet][side.begin] == side.low; }

  const Surface<3>& surface_;
  DisjointSets sets_;
};

}  // namespace

std::size_t take_apart(Surface<3>& surface, Touching touching) {
  Joints joints(surface);
  std::size_t n_crowded = 0;
  for_each_edge(sorted_edges(surface.facets, surface.vertices.size()),
                [&](const FacetEdge* begin, const FacetEdge* end) {
                  if (end - begin == 2) joints.join(begin[0], begin[1]);
                  if (end - begin <= 2) return;
                  ++n_crowded;
                  joints.join_wedges(begin, end, touching);
                });
  if (n_crowded > 0) joints.divide(surface);
  return n_crowded;
}

}  // namespace shellmatch
