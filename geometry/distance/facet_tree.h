#pragma once
/// \file
/// Tree of bounding boxes over the facets of a surface that finds the facet nearest to a point.
///
/// It is shallow and wide: a node has eight children whose boxes lie side by side, a leaf eight facets. The
/// distances to all eight are computed at once by vector instructions.
/// The tree is balanced, its leaves are full, and everything lies in two flat arrays.

#include "base/types.h"
#include "geometry/surface/surface.h"

#include <array>
#include <span>
#include <vector>

namespace shellmatch {

template <int Dim>
class FacetTree {
 public:
  /// \pre the surface has facets and its coordinates are finite.
  explicit FacetTree(const Surface<Dim>& surface);

  /// The facet nearest to x; of several at the same distance the one with the lowest index.
  /// no_index where x is not finite or so far away that the square of its distance is not.
  Index nearest(const Vec<Dim>& x) const;

 private:
  static constexpr int width = 8;
  // Vectors of the compiler: one register, two or four, whatever the machine has.
  typedef double Lanes __attribute__((vector_size(width * sizeof(double))));
  typedef float FloatLanes __attribute__((vector_size(width * sizeof(float))));

  /// Facets as the distance needs them; empty places repeat the first facet.
  struct Leaf {
    Lanes corner[Dim];                        ///< coordinates of the first corner
    Lanes edge[Dim - 1][Dim];                 ///< vectors from there to the others
    Lanes inverse_length2[Dim == 2 ? 1 : 3];  ///< of the edges; 0 for an edge without length
    Lanes inverse_normal2;  ///< in space: of the product of the edges; 0 for a facet without area
    std::array<Index, width> facet;
  };
  /// Boxes in single precision, rounded outward by more than the error of the distances.
  struct Node {
    FloatLanes min[Dim], max[Dim];
    std::array<Index, width> child;  ///< a node, or ~ a leaf. Empty places have a box at infinity.
  };
  struct Builder;

  static void squared_distances(const Node& node, const Vec<Dim>& x, Lanes& result);
  static void squared_distances(const Leaf& leaf, const Vec<Dim>& x, Lanes& result);

  std::vector<Node> nodes_;
  std::vector<Leaf> leaves_;
};

}  // namespace shellmatch
