// Edges with more than two triangles (geometry/repair/flat_triangles.h).
#include "base/disjoint_sets.h"
#include "geometry/repair/flat_triangles.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <tuple>

namespace shellmatch {

namespace {

struct Side {
  Index low, high;
  Index facet;
  int begin;     // the edge runs from this corner of the facet to the next
  bool forward;  // from low to high
  bool operator<(const Side& other) const { return std::tie(low, high, facet) < std::tie(other.low, other.high, other.facet); }
};

std::vector<Side> sorted_sides(const Surface<3>& surface) {
  std::vector<Side> sides;
  for (std::size_t f = 0; f < surface.facets.size(); ++f)
    for (int k = 0; k < 3; ++k) {
      const Index a = surface.facets[f][k], b = surface.facets[f][(k + 1) % 3];
      sides.push_back({std::min(a, b), std::max(a, b), static_cast<Index>(f), k, a < b});
    }
  std::sort(sides.begin(), sides.end());
  return sides;
}

// Corner k of facet f as one number.
Index corner(Index f, int k) { return 3 * f + k; }

class Joints {
 public:
  explicit Joints(const Surface<3>& surface) : surface_(surface), sets_(3 * surface.facets.size()) {}

  void join(const Side& one, const Side& two) {
    const int one_end = (one.begin + 1) % 3, two_end = (two.begin + 1) % 3;
    const bool opposite = one.forward != two.forward;
    sets_.join(corner(one.facet, one.begin), corner(two.facet, opposite ? two_end : two.begin));
    sets_.join(corner(one.facet, one_end), corner(two.facet, opposite ? two.begin : two_end));
  }

  // Around the edge, by angle: the inside lies counter-clockwise of a facet that runs backward and clockwise of one that runs forward. Like
  // brackets, each that opens a wedge is joined to the one that closes it; going round twice finds those beyond the angle 0.
  void join_wedges(const Side* begin, const Side* end) {
    const Vec<3>& origin = surface_.vertices[begin->low];
    const Vec<3> axis = surface_.vertices[begin->high] - origin;
    Vec<3> u = axis.unitOrthogonal();
    const Vec<3> v = axis.cross(u).normalized();
    struct Ray {
      double angle;
      const Side* side;
    };
    std::vector<Ray> rays;
    for (const Side* s = begin; s != end; ++s) {
      const Vec<3> r = surface_.vertices[surface_.facets[s->facet][(s->begin + 2) % 3]] - origin;
      rays.push_back({std::atan2(r.dot(v), r.dot(u)), s});
    }
    // At equal angles, wedges of no width open before they close.
    std::stable_sort(rays.begin(), rays.end(), [](const Ray& a, const Ray& b) {
      return std::make_pair(a.angle, a.side->forward) < std::make_pair(b.angle, b.side->forward);
    });
    std::vector<std::size_t> open;
    std::vector<bool> done(rays.size(), false);
    for (std::size_t i = 0; i < 2 * rays.size(); ++i) {
      const std::size_t k = i % rays.size();
      if (done[k]) continue;
      if (!rays[k].side->forward) {
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
  const Surface<3>& surface_;
  DisjointSets sets_;
};

}  // namespace

std::size_t take_apart(Surface<3>& surface) {
  const std::vector<Side> sides = sorted_sides(surface);
  Joints joints(surface);
  std::size_t n_crowded = 0;
  for (std::size_t i = 0, j = 0; i < sides.size(); i = j) {
    while (j < sides.size() && sides[j].low == sides[i].low && sides[j].high == sides[i].high) ++j;
    if (j - i == 2) joints.join(sides[i], sides[i + 1]);
    if (j - i <= 2) continue;
    ++n_crowded;
    joints.join_wedges(&sides[i], &sides[i] + (j - i));
  }
  if (n_crowded > 0) joints.divide(surface);
  return n_crowded;
}

}  // namespace shellmatch
