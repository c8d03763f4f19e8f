#pragma once
/// \file
/// A bounding volume hierarchy over the facets of a surface, for nearest facet queries.
///
/// The hierarchy is wide: a node has eight children, a leaf eight facets, and vector instructions compute the
/// distances to as many at once as a register holds. It is balanced, its leaves are full, and it is stored in two flat
/// arrays.

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

  /// The facet nearest to x; of several at the same distance, the one with the lowest index. no_index where
  /// the squared distance is not finite.
  Index nearest(const Vec<Dim>& x) const;

  /// A facet near x, quickly found, though others may be nearer. no_index as in nearest()
  Index some_near(const Vec<Dim>& x) const;

  /// Is a facet nearer to x than this distance?
  bool reaches(const Vec<Dim>& x, double distance) const;

  /// nearest() for many points, faster the nearer consecutive points lie to each other.
  /// \param facets one entry for each point
  void nearest(std::span<const Vec<Dim>> points, std::span<Index> facets) const;
  /// The same among the facets nearer than limits[i]; no_index where there is none, which is found out much faster.
  void nearest_within(std::span<const Vec<Dim>> points, std::span<const double> limits, std::span<Index> facets) const;

 private:
  static constexpr int width = 8;
  using Eight = std::array<double, width>;

  /// The data of eight facets for the distance; unused entries repeat the first facet.
  struct alignas(64) Leaf {
    Eight corner[Dim];                        ///< coordinates of the first corner
    Eight edge[Dim - 1][Dim];                 ///< vectors from it to the others
    Eight inverse_length2[Dim == 2 ? 1 : 3];  ///< of the edges; 0 for an edge without length
    Eight inverse_normal2;  ///< in space, of the cross product of the edges; 0 for a facet without area
    std::array<Index, width> facet;
  };
  /// Boxes in single precision, rounded outward by more than the error of the distances.
  struct alignas(32) Node {
    std::array<float, width> min[Dim], max[Dim];
    std::array<Index, width> child;  ///< index of a node, or ~index of a leaf; unused: box at infinity
  };
  struct Builder;
  class Stack;

  /// The nearest facet if it is nearer than sqrt(best), or as near with a lower index than `facet`; otherwise `facet`.
  Index nearer(const Vec<Dim>& x, double best, Index facet) const;
  /// The same, or where any facet suffices the first that is found.
  Index search(const Vec<Dim>& x, double best, Index facet, bool any_suffices) const;
  /// \param limits empty for none
  void nearest_of_group(std::span<const Vec<Dim>> points, std::span<const double> limits, Index* facets) const;

  std::vector<Node> nodes_;
  std::vector<Leaf> leaves_;
};

}  // namespace shellmatch
