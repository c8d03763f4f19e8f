#pragma once
/// \file
/// Iterated closest points between two surfaces about their centres, from a given rotation.

#include <Eigen/Core>

#include "geometry/distance/facet_tree.h"
#include "geometry/surface/surface.h"

#include <functional>
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

/// x -> rotation x + offset between normalised surfaces.
struct RigidMotion {
  Mat<3> rotation = Mat<3>::Identity();
  Vec<3> offset = Vec<3>::Zero();
  Vec<3> operator()(const Vec<3>& x) const { return rotation * x + offset; }
  Vec<3> inverse(const Vec<3>& y) const { return rotation.transpose() * (y - offset); }
};

/// Each part is 0 for a surface and its moved self; over samples of both surfaces and their nearest points on the
/// other.
struct RigidScore {
  double distance = 0;     ///< root mean square, in the unit of NormalizedSurface
  double orientation = 0;  ///< mean of (1 - n . n') / 2
  double total() const { return distance + orientation; }
};

/// What the search looks at of two surfaces: samples of each, and nearest points.
struct SampledPair {
  std::vector<SurfacePoint> on_first, on_second;
  std::function<SurfacePoint(const Vec<3>&)> nearest_on_first, nearest_on_second;
};

RigidScore rigid_score(const SampledPair& pair, const RigidMotion& motion);

/// Improves a motion: nearest points of both ways without the tenth that is farthest and without those on sides that
/// face away; distances to tangent planes, and with a small weight to the points themselves, so that spheres do not
/// turn. Source: D. Chetverikov, D. Stepanov, P. Krsek: Robust Euclidean alignment of 3D point sets: the trimmed
/// iterative closest point algorithm. Image and Vision Computing 23, 2005;
/// Y. Chen, G. Medioni: Object modelling by registration of multiple range images.
/// Image and Vision Computing 10, 1992
RigidMotion iterated_points(const SampledPair& pair, RigidMotion motion, int n_sweeps);

}  // namespace shellmatch
