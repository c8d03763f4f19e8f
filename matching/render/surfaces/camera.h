#pragma once
/// \file
/// Cameras and rays.

#include "geometry/surface/surface.h"

#include <optional>
#include <span>

namespace shellmatch {

/// right, up and backward are orthonormal and right-handed; backward points from the target to the eye.
struct Camera {
  Vec<3> target = Vec<3>::Zero();
  Vec<3> right = Vec<3>::UnitX(), up = Vec<3>::UnitY(), backward = Vec<3>::UnitZ();
  double half_height = 1;  ///< half of the picture's height, measured in the plane through the target
  double distance = 0;     ///< from the target to the eye; 0 is infinite: parallel projection
};

/// A ray x = origin + t direction, |direction| = 1.
struct Ray {
  Vec<3> origin, direction;
};

/// The ray through a point of the picture: y in [-1, 1] upwards, x to the right in the same unit. In parallel
/// projection the ray starts at the distance `clearance` in front of the plane through the target.
Ray camera_ray(const Camera& camera, double x, double y, double clearance);

struct ViewOptions {
  std::optional<double> azimuth = {};    ///< degrees around the up axis from +z towards +x; chosen if not given
  std::optional<double> elevation = {};  ///< degrees above the horizon; chosen if not given
  std::optional<Vec<3>> up = {};         ///< +y, or +z where the surfaces are so seen better; chosen if not given
  double field_of_view = 18;             ///< vertical angle in degrees; 0 means parallel projection
  double margin = 0.05;                  ///< free border, as a share of the picture
};

/// A camera that shows all surfaces entirely, so that panels with this camera are comparable. Unless the
/// options set azimuth and elevation, it is the one of several three-quarter views from the front that shows
/// most of the surfaces.
/// \pre at least one vertex; aspect = width/height > 0.
Camera fit_camera(std::span<const Surface<3>* const> surfaces, double aspect, const ViewOptions& options = {});

}  // namespace shellmatch
