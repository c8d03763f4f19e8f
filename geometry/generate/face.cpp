#include "geometry/generate/face.h"

#include "geometry/implicit/mesh_implicit.h"

namespace shellmatch {

namespace {

double ball(const Vec<3>& x, double px, double py, double pz, double radius) {
  return (x - Vec<3>(px, py, pz)).norm() - radius;
}

// A smoothed absolute value of x makes the face symmetric without a crease in the plane of symmetry.
double face(const Vec<3>& y, const FaceOptions& o) {
  const Vec<3> x(std::sqrt((y.x() - 0.5) * (y.x() - 0.5) + 1e-4) - 0.005, y.y(), y.z());
  const double smile = o.smile;
  double d = ellipsoid_function(x - Vec<3>(0, 0.6, 0.45), Vec<3>(0.205 * o.width, 0.235, 0.25));
  d = smooth_union(d, ellipsoid_function(x - Vec<3>(0, 0.44, 0.53), Vec<3>(0.142 * o.jaw, 0.17, 0.155)), 0.09);
  d = smooth_union(d, rounded_cone(x, Vec<3>(0, 0.2, 0.40), Vec<3>(0, 0.42, 0.43), 0.1, 0.092), 0.06);
  // Eye sockets, eyeballs, brows.
  d = smooth_difference(d, ball(x, 0.078, 0.567, 0.722, 0.046), 0.05);
  d = smooth_union(d, ball(x, 0.077, 0.565, 0.64, 0.034), 0.012);
  d = smooth_union(
      d, rounded_cone(x, Vec<3>(0.03, 0.612, 0.668), Vec<3>(0.115, 0.622, 0.632), 0.02 * o.brow, 0.014 * o.brow), 0.03);
  // Nose: bridge, tip, wings.
  const double n = o.nose;
  d = smooth_union(
      d, rounded_cone(x, Vec<3>(0, 0.585, 0.672), Vec<3>(0, 0.492, 0.688 + 0.042 * n), 0.015 * n, 0.023 * n), 0.03);
  d = smooth_union(d, ball(x, 0.022 * n, 0.487, 0.68 + 0.018 * n, 0.019 * n), 0.025);
  // Cheeks, chin, lips. A smile lifts and widens the corners of the mouth and fills the cheeks.
  d = smooth_union(d, ball(x, 0.098, 0.49 + 0.015 * smile, 0.605 + 0.008 * smile, 0.048 + 0.007 * smile), 0.06);
  d = smooth_union(d, ball(x, 0, 0.318, 0.642, 0.036), 0.05);
  const Vec<3> corner(0.05 + 0.03 * smile, 0.401 + 0.042 * smile, 0.66 - 0.002 * smile);
  const auto lip = [&](double height, double forward, double thickness) {
    const Vec<3> middle(0, height - 0.004 * smile, forward);
    const Vec<3> between(0.026 + 0.014 * smile, height + 0.006 * smile, forward - 0.005);
    return smooth_union(rounded_cone(x, middle, between, thickness, 0.95 * thickness),
                        rounded_cone(x, between, corner, 0.95 * thickness, 0.45 * thickness), 0.01);
  };
  d = smooth_union(d, smooth_union(lip(0.417, 0.674, 0.016), lip(0.384, 0.669, 0.017), 0.012), 0.025);
  // Ears: tilted flat ellipsoids with a hollow.
  const Vec<3> ear = Eigen::AngleAxisd(radians(20), Vec<3>::UnitY()) * (x - Vec<3>(0.2 * o.width, 0.545, 0.455));
  d = smooth_union(d, ellipsoid_function(ear, o.ears * Vec<3>(0.03, 0.062, 0.044)), 0.03);
  return smooth_difference(
      d, ellipsoid_function(ear - Vec<3>(0.036, 0.006, 0.01), o.ears * Vec<3>(0.016, 0.034, 0.022)), 0.02);
}

}  // namespace

Body<3> face_body(const FaceOptions& options, double edge_length) {
  return {mesh_implicit([&](const Vec<3>& x) { return face(x, options); }, edge_length, "face"),
          [](const Vec<3>& x) { return x; }};
}

}  // namespace shellmatch
