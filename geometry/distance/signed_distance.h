#pragma once
/// \file
/// Exact signed distance to a closed oriented surface.

#include "base/types.h"
#include "geometry/surface/surface.h"

#include <memory>
#include <span>
#include <vector>

namespace shellmatch {

/// Result of a closest point query at x.
template <int Dim>
struct ClosestPoint {
  double signed_distance;  ///< negative inside
  Vec<Dim> point;          ///< nearest point of the surface
  Vec<Dim> normal;         ///< unit gradient of the distance at x: (x - point) / signed_distance away from the
                           ///< surface, the pseudonormal of the nearest feature on it
  Index facet;             ///< a facet that contains `point`
};

/// Closest point queries on a closed, outward oriented surface. The sign comes from the angle-weighted
/// pseudonormal of the nearest feature (vertex, edge or facet): Baerentzen and Aanaes, 'Signed distance
/// computation using the angle weighted pseudonormal', IEEE TVCG 11(3), 2005. That is right for surfaces that do not
/// cross themselves. Next to facets that do, a point that seems to be inside is outside if the surface does not wind
/// about it: one folded triangle on an outermost ridge would turn all points beyond it inside out.
/// Immutable after construction; queries may run in parallel.
template <int Dim>
class SignedDistance {
 public:
  /// Keeps copies. \param crossing facets that cross or touch others; in the plane they are not used \pre the surface
  /// is not empty and has finite coordinates
  explicit SignedDistance(Surface<Dim> surface, const std::vector<Index>& crossing = {});
  ~SignedDistance();
  SignedDistance(SignedDistance&&) noexcept;
  SignedDistance& operator=(SignedDistance&&) noexcept;

  /// Of facets at the same distance, the one with the lowest index is used. \pre x is finite (checked).
  ClosestPoint<Dim> closest(const Vec<Dim>& x) const;
  double operator()(const Vec<Dim>& x) const { return closest(x).signed_distance; }

  /// The signed distances of many points, equal to those of one at a time, and faster the nearer consecutive points lie
  /// to each other. \param distances one entry for each point
  void operator()(std::span<const Vec<Dim>> x, std::span<double> distances) const;
  /// The closest points of many, in the same way. \param found one entry for each point
  void closest(std::span<const Vec<Dim>> x, std::span<ClosestPoint<Dim>> found) const;

  /// Unit pseudonormal of the surface at a point that was found: that of the corner or edge where the point lies on
  /// one, or so near that rounding could have chosen either side. Zero where the normals around it cancel.
  const Vec<Dim>& pseudonormal(const ClosestPoint<Dim>& found) const;

  const Surface<Dim>& surface() const;

 private:
  ClosestPoint<Dim> closest_on(Index facet, const Vec<Dim>& x) const;
  template <class Take>
  void for_each_closest(std::span<const Vec<Dim>> x, Take&& take) const;

  struct Tree;
  std::unique_ptr<Tree> tree_;
};

}  // namespace shellmatch
