#include "geometry/surface/pseudonormals.h"

#include "base/stop.h"
#include "geometry/surface/facet_edges.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <map>

namespace shellmatch {

template <int Dim>
Vec<Dim> unit_or_zero(const Vec<Dim>& x) {
  const double largest = x.cwiseAbs().maxCoeff();
  if (!(largest > 0)) return Vec<Dim>::Zero();
  const Vec<Dim> scaled = x / largest;
  return scaled / scaled.norm();
}

SHELLMATCH_2D_3D(unit_or_zero);

namespace {

/// Angle of facet f at its corner i. In the plane all segments have equal weight at their ends.
double corner_angle(const Surface<2>&, Index, int) { return 1; }

double corner_angle(const Surface<3>& surface, Index f, int i) {
  const auto& facet = surface.facets[f];
  const Vec<3>& a = surface.vertices[facet[i]];
  const Vec<3> u = surface.vertices[facet[(i + 1) % 3]] - a, v = surface.vertices[facet[(i + 2) % 3]] - a;
  // atan2 is accurate for small angles, for which the arc cosine loses half of the digits.
  return std::atan2(u.cross(v).norm(), u.dot(v));
}

/// Numbers the edges of all facets, each given by its two vertices; returns the number of edges.
std::size_t number_edges(const Surface<3>& surface, std::vector<std::array<Index, 3>>& edges_of_facet) {
  edges_of_facet.assign(surface.facets.size(), {no_index, no_index, no_index});
  std::size_t n_edges = 0;
  for_each_edge(sorted_edges(surface.facets, surface.vertices.size()),
                [&](const FacetEdge* begin, const FacetEdge* end) {
                  for (const FacetEdge* e = begin; e != end; ++e)
                    edges_of_facet[e->facet][e->begin] = static_cast<Index>(n_edges);
                  ++n_edges;
                });
  // Sides between equal corners belong together by these.
  std::map<Index, Index> loops;
  for (std::size_t f = 0; f < surface.facets.size(); ++f)
    for (int e = 0; e < 3; ++e)
      if (edges_of_facet[f][e] == no_index) {
        const auto [loop, is_new] = loops.try_emplace(surface.facets[f][e], static_cast<Index>(n_edges));
        n_edges += is_new ? 1 : 0;
        edges_of_facet[f][e] = loop->second;
      }
  return n_edges;
}

/// The longest edge of a facet, 0 to 2.
int longest_edge(const Surface<3>& surface, Index f) {
  const auto& facet = surface.facets[f];
  Vec<3> lengths;
  for (int e = 0; e < 3; ++e) lengths[e] = (surface.vertices[facet[(e + 1) % 3]] - surface.vertices[facet[e]]).norm();
  int longest;
  lengths.maxCoeff(&longest);
  return longest;
}

std::vector<Vec<3>> sums_at_edges(const std::vector<std::array<Index, 3>>& edges_of_facet, std::size_t n_edges,
                                  const std::vector<Vec<3>>& normals) {
  std::vector<Vec<3>> sums(n_edges, Vec<3>::Zero());
  for (std::size_t f = 0; f < normals.size(); ++f)
    for (const Index e : edges_of_facet[f]) sums[e] += normals[f];
  return sums;
}

/// In a facet without area, the two shorter edges lie on the longest one. Such a facet gets the normal of the
/// facet beyond its longest edge, which is the geometric neighbour of those beyond the shorter edges.
/// Connected sets of such facets are filled ring by ring; facets without a normal after `max_rings` keep the
/// zero normal.
void fill_degenerate(const Surface<3>& surface, const std::vector<std::array<Index, 3>>& edges_of_facet,
                     std::size_t n_edges, const std::vector<Index>& degenerate, std::vector<Vec<3>>& normals) {
  constexpr int max_rings = 16;
  std::vector<Index> missing = degenerate;
  bool any_edge = false;  // set where the longest edges lead to no normal: then all edges are tried
  for (int ring = 0; ring < max_rings && !missing.empty(); ++ring) {
    const std::vector<Vec<3>> sums = sums_at_edges(edges_of_facet, n_edges, normals);
    std::vector<Index> still_missing;
    for (const Index f : missing) {
      const auto& edges = edges_of_facet[f];
      normals[f] = unit_or_zero<3>(any_edge ? Vec<3>(sums[edges[0]] + sums[edges[1]] + sums[edges[2]])
                                            : sums[edges[longest_edge(surface, f)]]);
      if (normals[f].isZero(0)) still_missing.push_back(f);
    }
    any_edge = still_missing.size() == missing.size();
    missing = std::move(still_missing);
  }
}

/// Sums of the normals on both sides of every edge. At its longest edge, a facet without area contributes the
/// mean of the normals beyond its two other edges.
std::vector<Vec<3>> edge_normals(const Surface<3>& surface, const std::vector<std::array<Index, 3>>& edges_of_facet,
                                 std::size_t n_edges, const std::vector<Index>& degenerate,
                                 const std::vector<Vec<3>>& normals) {
  const std::vector<Vec<3>> sums = sums_at_edges(edges_of_facet, n_edges, normals);
  std::vector<Vec<3>> result = sums;
  for (const Index f : degenerate) {
    const auto& facet = surface.facets[f];
    const int longest = longest_edge(surface, f);
    Vec<3> beyond = Vec<3>::Zero();
    for (const int e : {(longest + 1) % 3, (longest + 2) % 3})
      beyond += (surface.vertices[facet[(e + 1) % 3]] - surface.vertices[facet[e]]).norm() *
                (sums[edges_of_facet[f][e]] - normals[f]);
    result[edges_of_facet[f][longest]] += unit_or_zero<3>(beyond) - normals[f];
  }
  for (Vec<3>& n : result) n = unit_or_zero<3>(n);
  return result;
}

}  // namespace

template <int Dim>
Pseudonormals<Dim>::Pseudonormals(const Surface<Dim>& surface)
    : facets_(surface.facets.size()), vertices_(surface.vertices.size(), Vec<Dim>::Zero()) {
  for (std::size_t f = 0; f < facets_.size(); ++f)
    facets_[f] = unit_or_zero<Dim>(facet_normal(surface, static_cast<Index>(f)));
  if constexpr (Dim == 3) {
    std::vector<Index> degenerate;
    for (std::size_t f = 0; f < facets_.size(); ++f) {
      const auto& [a, b, c] = surface.facets[f];
      if (!is_degenerate(surface.vertices[b] - surface.vertices[a], surface.vertices[c] - surface.vertices[a]))
        continue;
      facets_[f].setZero();
      degenerate.push_back(static_cast<Index>(f));
    }
    const std::size_t n_edges = number_edges(surface, edges_of_facet_);
    fill_degenerate(surface, edges_of_facet_, n_edges, degenerate, facets_);
    edges_ = edge_normals(surface, edges_of_facet_, n_edges, degenerate, facets_);
  }
  StopCheck stop_check;
  for (std::size_t f = 0; f < facets_.size(); ++f, stop_check())
    for (int i = 0; i < Dim; ++i)
      vertices_[surface.facets[f][i]] += corner_angle(surface, static_cast<Index>(f), i) * facets_[f];
  for (Vec<Dim>& n : vertices_) n = unit_or_zero<Dim>(n);
}

template <int Dim>
const Vec<Dim>& Pseudonormals<Dim>::operator()(const Surface<Dim>& surface, Index f, FeatureMask feature) const {
  if (feature == inside_facet<Dim>) return facets_[f];
  if (std::has_single_bit(feature)) return vertices_[surface.facets[f][std::countr_zero(feature)]];
  // Edges (0, 1), (1, 2), (2, 0) have the masks 3, 6 and 5.
  return edges_[edges_of_facet_[f][feature == 3 ? 0 : feature == 6 ? 1 : 2]];
}

template class Pseudonormals<2>;
template class Pseudonormals<3>;

}  // namespace shellmatch
