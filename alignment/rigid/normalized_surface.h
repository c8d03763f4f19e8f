#pragma once
/// \file
/// A surface about its centre, with samples and nearest points, and samples alone.

#include "geometry/distance/facet_tree.h"
#include "geometry/surface/surface.h"

#include <Eigen/Core>
#include <optional>
#include <vector>

namespace shellmatch {

struct SurfacePoint {
  Vec<3> point, normal;  ///< the normal has length 1
};

/// About the centre of its area, in roots of the mean square distance from it.
class NormalizedSurface {
 public:
  /// \throws InputError where the surface has no area
  explicit NormalizedSurface(const Surface<3>& input);

  const Vec<3>& centre() const { return centre_; }  ///< in the coordinates of the input
  double radius() const { return radius_; }         ///< the unit
  const Mat<3>& axes() const { return axes_; }  ///< principal axes as columns, the shortest first; a proper rotation

  /// n points, each in the midst of an equal share of the area in the order of the facets.
  std::vector<SurfacePoint> samples(std::size_t n) const;
  SurfacePoint nearest(const Vec<3>& x) const;

 private:
  Surface<3> surface_;
  Vec<3> centre_ = Vec<3>::Zero();
  double radius_ = 1;
  Mat<3> axes_;
  std::vector<double> area_up_to_;  ///< of all facets up to and with each
  std::vector<Vec<3>> normals_;     ///< unit, of the facets
  std::optional<FacetTree<3>> tree_;
};

/// Points in place of their surface: the nearest of some hundred, found in a quarter of the time of the nearest point
/// between them.
class SampleCloud {
 public:
  /// \pre there are samples
  explicit SampleCloud(std::vector<SurfacePoint> samples);
  const std::vector<SurfacePoint>& samples() const { return samples_; }
  const SurfacePoint& nearest(const Vec<3>& x) const;

 private:
  std::vector<SurfacePoint> samples_;
  Eigen::ArrayX3f points_;
};

}  // namespace shellmatch
