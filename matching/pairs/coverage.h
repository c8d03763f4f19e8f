#pragma once
/// \file
/// Coverage: the match term asks every point of phi(M1) to lie on M2, and nothing asks every point of M2 to be reached.
/// Samples of M2 do: the point of phi(M1) nearest to each is pulled into the plane that touches M2 there.

#include "energies/pairs/point_pairs.h"
#include "geometry/surface/surface.h"
#include "grid/octree/octree.h"
#include "matching/experiment/pair_options.h"
#include "matching/level/pair_mask.h"

#include <span>
#include <vector>

namespace shellmatch {

template <int Dim>
class Coverage {
 public:
  /// Samples vertices of the template, every one or, where there are more than options.samples, so many that each stands for
  /// the same area (length). \param reference must outlive this object; all in the unit domain. Neither samples nor the
  /// points that are pulled lie where a shape has no data
  Coverage(const Surface<Dim>& reference, const Surface<Dim>& template_shape, const CoverageOptions& options,
           const ObservedPair<Dim>& observed = {});

  /// Point to plane pairs for the present phi, with the area that each sample stands for as weight. A sample makes none
  /// where the nearest part of phi(M1) faces away from it: that belongs to another limb, or to the other side of this one.
  PointPairs<Dim> pairs(const Octree<Dim>& grid, std::span<const Vec<Dim>> phi) const;

 private:
  struct Sample {
    Vec<Dim> y, normal;
    double area;
  };
  const Surface<Dim>* reference_;
  ObservedPair<Dim> observed_;
  std::vector<Sample> samples_;
  double tolerance_;  ///< sides of the domain
};

}  // namespace shellmatch
