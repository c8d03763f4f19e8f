#pragma once

#include "grid/octree/octree.h"

#include <array>
#include <memory>
#include <utility>
#include <vector>

namespace shellmatch {

/// Finds the free nodes that are nearest to a place, in integer coordinates of nodes, in which equal distances compare
/// equal.
template <int Dim>
class NearestNodes {
 public:
  struct Member {
    Index position;  ///< among the free nodes
    double square;   ///< of the distance
  };
  /// Working memory of one thread.
  struct Scratch {
    std::vector<Member> ball;
    std::vector<double> squares;
    double guess = 0;  ///< squared radius of a ball that contains enough nodes
  };

  explicit NearestNodes(const Octree<Dim>& grid);
  ~NearestNodes();

  /// Fills scratch.ball with the free nodes that are no farther from the node at `centre` than its n-th nearest
  /// neighbour, by ascending position, so that sums over them have the same bits whatever the order in which a search
  /// finds them. Returns the squared distances of the nearest and of the farthest of them. \pre there are at least n +
  /// 1 free nodes
  std::pair<double, double> find(const std::array<double, Dim>& centre, std::size_t n, Scratch& scratch) const;

 private:
  struct Tree;
  std::unique_ptr<const Tree> tree_;
};

}  // namespace shellmatch
