#include "geometry/implicit/mesh_implicit.h"

#include "base/error.h"
#include "base/parallel.h"
#include "base/stop.h"
#include "geometry/implicit/lattice.h"

#include <algorithm>
#include <cmath>
#include <unordered_map>

namespace shellmatch {

namespace {

// Lattice points that were moved onto the surface where two sheets of it are close have joined these; they are left
// where they were.
Surface<3> closed_in_any_case(const ImplicitFunction& f, double spacing) {
  Lattice lattice(f, spacing);
  for (int round = 0; round < 12; ++round) {
    Surface<3> surface = lattice.triangulate();
    std::vector<Vec<3>> places;
    for (const Index v : vertices_without_a_fan(surface)) places.push_back(surface.vertices[v]);
    if (places.empty()) return surface;
    lattice.keep_points_near(places);
  }
  lattice.keep_all_points();
  return lattice.triangulate();
}

}  // namespace

Surface<3> mesh_implicit(const ImplicitFunction& f, double edge_length, std::string_view name, Details details) {
  // The average edge is 0.78 times the spacing of the lattice. Where two sheets of the surface are close, the
  // lattice may connect them; slightly finer lattices are then tried.
  Surface<3> surface;
  bool closed = false;
  for (const double finer : {1.0, 0.93, 0.86, 0.8}) {
    surface = Lattice(f, finer * edge_length / 0.78).triangulate();
    closed = is_closed_manifold(surface);
    if (closed) break;
  }
  if (!closed && details == Details::as_they_come) {
    surface = closed_in_any_case(f, edge_length / 0.78);
    closed = is_closed_manifold(surface);
  }
  const Box<3> box = bounding_box(surface.vertices);
  if (!surface.vertices.empty() && (box.min.minCoeff() < 0.05 || box.max.maxCoeff() > 0.95))
    throw_input_error("{}: with these parameters the body leaves [0.05, 0.95]^3; choose less extreme ones", name);
  if (!closed)
    throw_input_error("{}: an edge length of {:g} is too coarse for the details of this body; choose a smaller one",
                      name, edge_length);
  const auto project = [&](std::size_t v) { surface.vertices[v] = project_to_zero(f, surface.vertices[v]); };
  parallel_for(surface.vertices.size(), project);
  for (int round = 0; round < 3; ++round) {
    swap_to_delaunay(surface);
    smooth_tangentially(f, 2, surface);
  }
  parallel_for(surface.vertices.size(), project);
  swap_to_delaunay(surface);
  return surface;
}

namespace {

std::uint64_t edge_key(Index from, Index to) {
  return static_cast<std::uint64_t>(from) << 32 | static_cast<std::uint32_t>(to);
}

// The facet to the left of each directed edge.
using FacetOfEdge = std::unordered_map<std::uint64_t, Index>;

FacetOfEdge facets_of_edges(const Surface<3>& s) {
  FacetOfEdge facet_of;
  facet_of.reserve(3 * s.facets.size());
  StopCheck stop_check;
  for (std::size_t f = 0; f < s.facets.size(); ++f) {
    stop_check();
    for (int k = 0; k < 3; ++k) facet_of[edge_key(s.facets[f][k], s.facets[f][(k + 1) % 3])] = static_cast<Index>(f);
  }
  return facet_of;
}

Index opposite(const std::array<Index, 3>& facet, Index a, Index b) {
  for (const Index v : facet)
    if (v != a && v != b) return v;
  return no_index;
}

// Whether the angles at c and d, opposite the edge from a to b, add up to more than 180 degrees.
bool exceed_two_right_angles(const Vec<3>& a, const Vec<3>& b, const Vec<3>& c, const Vec<3>& d) {
  const double sine_c = (a - c).cross(b - c).norm(), cosine_c = (a - c).dot(b - c);
  const double sine_d = (a - d).cross(b - d).norm(), cosine_d = (a - d).dot(b - d);
  // The sine of the sum decides nearly all edges.
  if (sine_c * cosine_d + cosine_c * sine_d > 0) return false;
  return std::atan2(sine_c, cosine_c) + std::atan2(sine_d, cosine_d) >= 1.001 * M_PI;
}

}  // namespace

void swap_to_delaunay(Surface<3>& s) {
  FacetOfEdge facet_of = facets_of_edges(s);
  const std::vector<Vec<3>>& x = s.vertices;
  std::vector<int> valence(x.size(), 0);
  for (const auto& facet : s.facets)
    for (const Index v : facet) ++valence[v];
  // Whose edges have all been seen to be, before any change of the facet or a neighbour.
  std::vector<char> is_delaunay(s.facets.size(), false);
  StopCheck stop_check;
  for (int pass = 0; pass < 8; ++pass) {
    int n_swaps = 0;
    for (Index f = 0; f < static_cast<Index>(s.facets.size()); ++f) {
      stop_check();
      if (is_delaunay[f]) continue;
      is_delaunay[f] = true;
      for (int k = 0; k < 3; ++k) {
        const Index a = s.facets[f][k], b = s.facets[f][(k + 1) % 3];
        const Index g = facet_of.at(edge_key(b, a));
        const Index c = opposite(s.facets[f], a, b), d = opposite(s.facets[g], a, b);
        if (!exceed_two_right_angles(x[a], x[b], x[c], x[d])) continue;
        is_delaunay[f] = false;
        if (facet_of.count(edge_key(c, d)) || facet_of.count(edge_key(d, c))) continue;
        if (valence[a] <= 3 || valence[b] <= 3) continue;
        const Vec<3> normal = (x[b] - x[a]).cross(x[c] - x[a]) + (x[a] - x[b]).cross(x[d] - x[b]);
        if ((x[d] - x[c]).cross(x[a] - x[c]).dot(normal) * (x[b] - x[c]).cross(x[d] - x[c]).dot(normal) <= 0) continue;
        // Facets (a, b, c) and (b, a, d) become (c, a, d) and (d, b, c).
        facet_of.erase(edge_key(a, b));
        facet_of.erase(edge_key(b, a));
        s.facets[f] = {c, a, d};
        s.facets[g] = {d, b, c};
        for (const Index h : {f, g})
          for (int q = 0; q < 3; ++q) facet_of[edge_key(s.facets[h][q], s.facets[h][(q + 1) % 3])] = h;
        for (const Index h : {f, g})
          for (int q = 0; q < 3; ++q)
            is_delaunay[facet_of.at(edge_key(s.facets[h][(q + 1) % 3], s.facets[h][q]))] = false;
        --valence[a];
        --valence[b];
        ++valence[c];
        ++valence[d];
        ++n_swaps;
        break;
      }
    }
    if (n_swaps == 0) break;
  }
}

void smooth_tangentially(const ImplicitFunction& f, int n_sweeps, Surface<3>& s) {
  for (int sweep = 0; sweep < n_sweeps; ++sweep) {
    std::vector<Vec<3>> sum(s.vertices.size(), Vec<3>::Zero());
    std::vector<double> weight(s.vertices.size(), 0.0);
    for (const auto& [a, b, c] : s.facets) {
      const Vec<3>&pa = s.vertices[a], &pb = s.vertices[b], &pc = s.vertices[c];
      const double area = (pb - pa).cross(pc - pa).norm();
      for (const Index v : {a, b, c}) {
        sum[v] += area * (pa + pb + pc) / 3;
        weight[v] += area;
      }
    }
    parallel_for(s.vertices.size(), [&](std::size_t v) {
      const Vec<3> x = s.vertices[v];
      const Vec<3> gradient = implicit_gradient(f, x);
      const double squared = std::max(gradient.squaredNorm(), 0.01);
      const Vec<3> step = sum[v] / weight[v] - x;
      const Vec<3> y = x + 0.9 * (step - step.dot(gradient) / squared * gradient);
      s.vertices[v] = y - f(y) / squared * gradient;
    });
  }
}

std::vector<Index> vertices_without_a_fan(const Surface<3>& s) {
  const FacetOfEdge facet_of = facets_of_edges(s);
  std::vector<Index> n_facets(s.vertices.size(), 0), start(s.vertices.size(), no_index);
  std::vector<char> is_bad(s.vertices.size(), false);
  for (std::size_t f = 0; f < s.facets.size(); ++f)
    for (int k = 0; k < 3; ++k) {
      const Index v = s.facets[f][k], next = s.facets[f][(k + 1) % 3];
      ++n_facets[v];
      start[v] = static_cast<Index>(f);
      // One facet to the left of each edge, and one to its right.
      if (facet_of.at(edge_key(v, next)) != static_cast<Index>(f) || !facet_of.contains(edge_key(next, v)))
        is_bad[v] = is_bad[next] = true;
    }
  std::vector<Index> found;
  StopCheck stop_check;
  for (Index v = 0; v < static_cast<Index>(s.vertices.size()); ++v) {
    stop_check();
    if (!is_bad[v] && n_facets[v] > 0) {
      // A walk around v from facet to facet must return after visiting all of them.
      Index f = start[v], n = 0;
      do {
        const auto& facet = s.facets[f];
        const Index before = facet[(std::find(facet.begin(), facet.end(), v) - facet.begin() + 2) % 3];
        f = facet_of.at(edge_key(v, before));
      } while (++n <= n_facets[v] && f != start[v]);
      is_bad[v] = n != n_facets[v];
    }
    if (is_bad[v] || n_facets[v] == 0) found.push_back(v);
  }
  return found;
}

}  // namespace shellmatch
