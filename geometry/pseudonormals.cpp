#include "geometry/pseudonormals.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <numeric>

namespace shellmatch {

namespace {

template <int Dim>
Vec<Dim> unit_or_zero(const Vec<Dim>& x) {
  const double length = x.stableNorm();
  return length > 0 ? Vec<Dim>(x / length) : Vec<Dim>(Vec<Dim>::Zero());
}

/// Angle of facet f at its corner i; in the plane every segment counts with the same weight at its ends.
double corner_angle(const Surface<2>&, Index, int) { return 1; }

double corner_angle(const Surface<3>& surface, Index f, int i) {
  const auto& facet = surface.facets[f];
  const Vec<3>& a = surface.vertices[facet[i]];
  const Vec<3> u = surface.vertices[facet[(i + 1) % 3]] - a, v = surface.vertices[facet[(i + 2) % 3]] - a;
  // atan2 keeps small angles exact, where the arc cosine would lose half of the digits.
  return std::atan2(u.cross(v).norm(), u.dot(v));
}

/// Numbers the edges of all facets, an edge by its two vertices; returns how many there are.
std::size_t number_edges(const Surface<3>& surface, std::vector<std::array<Index, 3>>& edges_of_facet) {
  struct Side {
    std::uint64_t key;
    Index facet;
    int edge;
  };
  std::vector<Side> sides;
  sides.reserve(3 * surface.facets.size());
  for (std::size_t f = 0; f < surface.facets.size(); ++f)
    for (int e = 0; e < 3; ++e) {
      const auto [low, high] = std::minmax(surface.facets[f][e], surface.facets[f][(e + 1) % 3]);
      sides.push_back({static_cast<std::uint64_t>(low) << 32 | static_cast<std::uint32_t>(high),
                       static_cast<Index>(f), e});
    }
  std::sort(sides.begin(), sides.end(), [](const Side& a, const Side& b) {
    return a.key != b.key ? a.key < b.key : a.facet != b.facet ? a.facet < b.facet : a.edge < b.edge;
  });
  edges_of_facet.resize(surface.facets.size());
  std::size_t n_edges = 0;
  for (std::size_t i = 0; i < sides.size(); ++i) {
    if (i == 0 || sides[i].key != sides[i - 1].key) ++n_edges;
    edges_of_facet[sides[i].facet][sides[i].edge] = static_cast<Index>(n_edges - 1);
  }
  return n_edges;
}

/// Facets without area have a zero normal at first: gives them the mean of their neighbours' normals, weighted
/// by the lengths of the edges between them, one ring of such facets after the other. Whoever lies deeper
/// among them than `max_rings` keeps the zero normal.
void fill_degenerate(const Surface<3>& surface, const std::vector<std::array<Index, 3>>& edges_of_facet,
                     std::size_t n_edges, std::vector<Vec<3>>& normals) {
  constexpr int max_rings = 16;
  std::vector<Index> missing;
  for (std::size_t f = 0; f < normals.size(); ++f)
    if (normals[f].isZero(0)) missing.push_back(static_cast<Index>(f));
  for (int ring = 0; ring < max_rings && !missing.empty(); ++ring) {
    std::vector<Vec<3>> sum(n_edges, Vec<3>::Zero());
    for (std::size_t f = 0; f < normals.size(); ++f)
      for (const Index e : edges_of_facet[f]) sum[e] += normals[f];
    std::vector<Vec<3>> found(missing.size());
    for (std::size_t i = 0; i < missing.size(); ++i) {
      const auto& facet = surface.facets[missing[i]];
      Vec<3> mean = Vec<3>::Zero();
      for (int e = 0; e < 3; ++e)
        mean += (surface.vertices[facet[(e + 1) % 3]] - surface.vertices[facet[e]]).norm() *
                sum[edges_of_facet[missing[i]][e]];
      found[i] = unit_or_zero<3>(mean);
    }
    std::vector<Index> still_missing;
    for (std::size_t i = 0; i < missing.size(); ++i) {
      normals[missing[i]] = found[i];
      if (found[i].isZero(0)) still_missing.push_back(missing[i]);
    }
    missing = std::move(still_missing);
  }
}

}  // namespace

template <int Dim>
Pseudonormals<Dim>::Pseudonormals(const Surface<Dim>& surface)
    : facets_(surface.facets.size()), vertices_(surface.vertices.size(), Vec<Dim>::Zero()) {
  for (std::size_t f = 0; f < facets_.size(); ++f) {
    facets_[f] = unit_or_zero<Dim>(facet_normal(surface, static_cast<Index>(f)));
    if constexpr (Dim == 3) {
      const auto& [a, b, c] = surface.facets[f];
      if (is_degenerate(surface.vertices[b] - surface.vertices[a], surface.vertices[c] - surface.vertices[a]))
        facets_[f].setZero();
    }
  }
  if constexpr (Dim == 3) {
    const std::size_t n_edges = number_edges(surface, edges_of_facet_);
    fill_degenerate(surface, edges_of_facet_, n_edges, facets_);
    edges_.assign(n_edges, Vec<3>::Zero());
    for (std::size_t f = 0; f < facets_.size(); ++f)
      for (const Index e : edges_of_facet_[f]) edges_[e] += facets_[f];
    for (Vec<Dim>& n : edges_) n = unit_or_zero<Dim>(n);
  }
  for (std::size_t f = 0; f < facets_.size(); ++f)
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
