#pragma once
/// \file
/// Distances along the edges of a surface, and well spread samples of its vertices.

#include "geometry/surface/surface.h"

#include <functional>
#include <utility>
#include <vector>

namespace shellmatch {

/// The vertices and edges of a surface with their lengths.
class EdgeGraph {
 public:
  explicit EdgeGraph(const Surface<3>& surface);

  std::size_t n_vertices() const { return begin_.size() - 1; }
  double mean_edge_length() const;

  /// Calls f(w) for every vertex w that an edge joins to v.
  template <class F>
  void for_each_neighbour(Index v, F&& f) const {
    for (std::size_t e = begin_[v]; e < begin_[v + 1]; ++e) f(edges_[e].to);
  }

  /// Calls f(v, distance) for every vertex v with a path to it from `source` that is shorter than `reach`, the nearest
  /// first, until f returns false.
  void for_each_within(Index source, double reach, const std::function<bool(Index, double)>& f) const;

  /// Length of the shortest path along edges from `source` to every vertex; infinite where there is none. Paths along
  /// edges are some per cent longer than those across facets.
  std::vector<double> distances_from(Index source) const;
  /// That of one vertex; quick where it is near.
  double distance(Index source, Index goal) const;
  /// Replaces entries of `distances`, which belong to other sources, by distances from `source` where these are
  /// shorter.
  void lower_distances(Index source, std::vector<double>& distances) const;
  /// For every vertex the place in `sources` of the one that is nearest along edges, the first of several; none where
  /// all are `reach` away or more.
  std::vector<std::size_t> nearest_of(const std::vector<Index>& sources, double reach) const;
  static constexpr std::size_t none = static_cast<std::size_t>(-1);

 private:
  void lower_distances_up_to(Index goal, Index source, std::vector<double>& distances) const;

  struct Edge {
    Index to;
    double length;
  };
  std::vector<std::size_t> begin_;  ///< of each vertex' edges
  std::vector<Edge> edges_;
};

/// `n` vertices, or all if there are fewer, each the farthest from those before it: the first m of them are such
/// samples for every m.
std::vector<Index> farthest_point_samples(const EdgeGraph& graph, Index first, std::size_t n);

/// Of each of some points, others near it: distances in rising order, and indices.
using NeighbourLists = std::vector<std::vector<std::pair<double, std::size_t>>>;

/// Of each vertex, the n others of `vertices` that are nearest along edges; fewer where no more can be reached.
/// \pre `vertices` are distinct
NeighbourLists nearest_along(const EdgeGraph& graph, const std::vector<Index>& vertices, std::size_t n);

}  // namespace shellmatch
