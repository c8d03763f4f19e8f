#pragma once
/// \file
/// Iterated closest points between two surfaces, from a given rotation.

#include "alignment/rigid/normalized_surface.h"

#include <functional>
#include <vector>

namespace shellmatch {

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
/// iterative closest
///   point algorithm. Image and Vision Computing 23, 2005; Y. Chen, G. Medioni: Object modelling by registration of
///   multiple range images. Image and Vision Computing 10, 1992
RigidMotion iterated_points(const SampledPair& pair, RigidMotion motion, int n_sweeps);

}  // namespace shellmatch
