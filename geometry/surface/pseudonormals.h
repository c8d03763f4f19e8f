#pragma once
/// \file
/// Angle-weighted pseudonormals: for every facet, edge and vertex a direction whose product with x - p has
/// the sign of the distance for every x whose nearest point p lies on that feature. Baerentzen and Aanaes,
/// 'Signed distance computation using the angle weighted pseudonormal', IEEE TVCG 11(3), 2005.

#include "geometry/surface/facet_point.h"

#include <array>
#include <vector>

namespace shellmatch {

/// x / |x| without overflow or underflow of squares; 0 for x = 0, and where x is not a number. It has the same bits
/// wherever x lies in memory, other than Eigen's stableNormalized() (3.4), and being compiled once, in every program.
template <int Dim>
Vec<Dim> unit_or_zero(const Vec<Dim>& x);

template <int Dim>
class Pseudonormals {
 public:
  /// A facet without area gets the normal of the facet beyond its longest edge, so that the sign is right
  /// where such triangles close the gap between a long edge and shorter collinear ones.
  explicit Pseudonormals(const Surface<Dim>& surface);

  /// Unit pseudonormal of a feature of facet f; zero where the normals around it cancel.
  const Vec<Dim>& operator()(const Surface<Dim>& surface, Index f, FeatureMask feature) const;

 private:
  std::vector<Vec<Dim>> facets_, edges_, vertices_;
  std::vector<std::array<Index, 3>> edges_of_facet_;  ///< in space: edges (0, 1), (1, 2), (2, 0)
};

}  // namespace shellmatch
