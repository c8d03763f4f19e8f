#pragma once
/// \file
/// Deformation graphs (Sumner, Schmid, Pauly, ACM Trans. Graph. 26(3), 2007) on surfaces: rigid motions at nodes spread
/// over a surface, blended by distances along it, so that limbs that touch can move apart.

#include "alignment/spectrum/edge_graph.h"
#include "geometry/surface/surface.h"

#include <Eigen/Geometry>

#include <array>
#include <vector>

namespace shellmatch {

/// Of a node at c: x -> rotation * (x - c) + c + translation.
struct NodeMotion {
  Eigen::Quaterniond rotation = Eigen::Quaterniond::Identity();
  Vec<3> translation = Vec<3>::Zero();
};

class DeformationGraph {
 public:
  static constexpr std::size_t n_influences = 4;

  /// The nodes that move a vertex, the nearest first.
  struct Influence {
    std::array<Index, n_influences> nodes;
    std::array<double, n_influences> weights;  ///< sum 1; those of nodes that are not there are 0
  };
  /// Between nodes that move a vertex together; there is one in either direction.
  struct Edge {
    Index from, to;
    double weight;  ///< the sum of all weights times squared lengths is twice the surface's area
  };

  /// \param n_nodes at most so many, > 0. Components without a node move with the nearest one of others.
  /// \pre the surface has vertices and an area
  DeformationGraph(const Surface<3>& surface, std::size_t n_nodes);

  const std::vector<Vec<3>>& centres() const { return centres_; }
  const std::vector<Edge>& edges() const { return edges_; }
  const Influence& influence(Index vertex) const { return influences_[vertex]; }

  /// A point moved as the vertex is. \param motions one for each node
  Vec<3> moved(Index vertex, const Vec<3>& x, const std::vector<NodeMotion>& motions) const;

 private:
  void add_influences(const Surface<3>& surface, const EdgeGraph& graph, const std::vector<Index>& nodes);
  void add_edges(const Surface<3>& surface);

  std::vector<Vec<3>> centres_;
  std::vector<Influence> influences_;
  std::vector<Edge> edges_;
};

}  // namespace shellmatch
