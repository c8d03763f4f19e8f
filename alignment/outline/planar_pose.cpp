#include "alignment/outline/planar_pose.h"

#include "base/error.h"

#include <cmath>

namespace shellmatch {

namespace {

// With points as complex numbers about their means, sum w |z x - y|^2 is least for z = sum w conj(x) y / sum w |x|^2.
Similarity<2> least_squares(std::span<const CorrespondingPointsIn<2>> pairs, PoseKind kind, bool mirror) {
  const auto turned_over = [&](const Vec<2>& x) { return mirror ? Vec<2>(x.x(), -x.y()) : x; };
  double sum = 0;
  Vec<2> from = Vec<2>::Zero(), to = from;
  for (const auto& pair : pairs) {
    sum += pair.weight;
    from += pair.weight * turned_over(pair.on_reference);
    to += pair.weight * pair.on_template;
  }
  if (pairs.size() < 2 || !(sum > 0))
    throw_input_error("a pose in the plane needs at least two pairs of points; there are {}", pairs.size());
  from /= sum;
  to /= sum;
  double real = 0, imaginary = 0, from2 = 0, to2 = 0;
  for (const auto& pair : pairs) {
    const Vec<2> x = turned_over(pair.on_reference) - from, y = pair.on_template - to;
    real += pair.weight * x.dot(y);
    imaginary += pair.weight * (x.x() * y.y() - x.y() * y.x());
    from2 += pair.weight * x.squaredNorm();
    to2 += pair.weight * y.squaredNorm();
  }
  const double size = std::hypot(real, imaginary);
  if (!(from2 > 0) || !(to2 > 0)) throw_input_error("a pose in the plane needs pairs of points that do not coincide");
  Similarity<2> pose;
  // Pairs that contradict each other give no direction.
  const double c = size > 0 ? real / size : 1, s = size > 0 ? imaginary / size : 0;
  pose.rotation << c, -s, s, c;
  if (mirror) pose.rotation.col(1) *= -1;
  if (kind == PoseKind::similarity && size > 0) pose.scale = size / from2;
  Vec<2> mean = from;
  if (mirror) mean.y() *= -1;
  pose.offset = to - pose.scale * (pose.rotation * mean);
  return pose;
}

double squared_residual(std::span<const CorrespondingPointsIn<2>> pairs, const Similarity<2>& pose) {
  double sum = 0;
  for (const auto& pair : pairs) sum += pair.weight * (pose(pair.on_reference) - pair.on_template).squaredNorm();
  return sum;
}

}  // namespace

Similarity<2> fit_planar_pose(std::span<const CorrespondingPointsIn<2>> pairs, PoseKind kind, Mirroring mirroring) {
  if (mirroring != Mirroring::allowed) return least_squares(pairs, kind, mirroring == Mirroring::always);
  const Similarity<2> proper = least_squares(pairs, kind, false), mirrored = least_squares(pairs, kind, true);
  // Two points fit both ways: rounding must not decide.
  double extent = 0;
  for (const auto& pair : pairs) extent += pair.weight * (pair.on_template - pairs[0].on_template).squaredNorm();
  const double residual = squared_residual(pairs, proper);
  const bool gains =
      residual > 1e-18 * extent && squared_residual(pairs, mirrored) < mirrored_gain * mirrored_gain * residual;
  return gains ? mirrored : proper;
}

}  // namespace shellmatch
