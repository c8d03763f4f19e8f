#include "alignment/pose/fit_pose.h"

#include "base/decompositions.h"
#include "base/error.h"

#include <Eigen/LU>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <random>
#include <vector>

namespace shellmatch {

namespace {

using Pairs = std::span<const CorrespondingPoints>;

/// Weighted least squares. S. Umeyama, IEEE PAMI 13(4), 1991. Nothing where the points lie on a line.
std::optional<Pose> least_squares(Pairs pairs, std::span<const double> weights, PoseKind kind, double handedness) {
  Vec<3> from = Vec<3>::Zero(), to = Vec<3>::Zero();
  double sum = 0;
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    from += weights[i] * pairs[i].on_reference;
    to += weights[i] * pairs[i].on_template;
    sum += weights[i];
  }
  from /= sum;
  to /= sum;
  Mat<3> covariance = Mat<3>::Zero();
  double spread = 0, spread_to = 0;
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    const Vec<3> a = pairs[i].on_reference - from, b = pairs[i].on_template - to;
    covariance += weights[i] * b * a.transpose();
    spread += weights[i] * a.squaredNorm();
    spread_to += weights[i] * b.squaredNorm();
  }
  const Svd<Mat<3>> svd = jacobi_svd(covariance);
  // Two independent directions determine a rotation.
  if (!(svd.values[1] > 1e-9 * std::sqrt(spread * spread_to))) return std::nullopt;
  Vec<3> signs = Vec<3>::Ones();
  if (handedness * (svd.u * svd.v.transpose()).determinant() < 0) signs[2] = -1;
  Pose pose;
  pose.rotation = svd.u * signs.asDiagonal() * svd.v.transpose();
  pose.scale = kind == PoseKind::rigid ? 1 : svd.values.dot(signs) / spread;
  if (!(pose.scale > 0)) return std::nullopt;
  pose.translation = to - pose.scale * (pose.rotation * from);
  return pose;
}

/// Median over the pairs, each counted by its weight.
double weighted_median(Pairs pairs, const Pose& pose) {
  std::vector<std::pair<double, double>> distances;
  double sum = 0;
  for (const CorrespondingPoints& p : pairs) {
    distances.emplace_back((pose(p.on_reference) - p.on_template).norm(), p.weight);
    sum += p.weight;
  }
  std::sort(distances.begin(), distances.end());
  double below = 0;
  for (const auto& [distance, weight] : distances)
    if ((below += weight) >= sum / 2) return distance;
  return distances.back().first;
}

/// Whether the weighted median is less than this, which takes no sorting.
bool median_is_below(Pairs pairs, const Pose& pose, double most) {
  double below = 0, sum = 0;
  for (const CorrespondingPoints& p : pairs) {
    sum += p.weight;
    if ((pose(p.on_reference) - p.on_template).squaredNorm() < most * most) below += p.weight;
  }
  return below >= sum / 2;
}

/// Reweighted least squares, begun at `pose`.
Pose improved(Pairs pairs, Pose pose, PoseKind kind, double handedness) {
  std::vector<double> weights(pairs.size());
  for (int sweep = 0; sweep < 20; ++sweep) {
    // 1.48 times the median estimates the standard deviation, and 4.685 of these is Tukey's usual limit.
    const double limit =
        std::max(4.685 * 1.4826 * weighted_median(pairs, pose), 1e-12 * pose.translation.norm() + 1e-300);
    for (std::size_t i = 0; i < pairs.size(); ++i) {
      const double share = (pose(pairs[i].on_reference) - pairs[i].on_template).norm() / limit;
      weights[i] = share < 1 ? pairs[i].weight * std::pow(1 - share * share, 2) : 0;
    }
    const std::optional<Pose> next = least_squares(pairs, weights, kind, handedness);
    if (!next) break;
    pose = *next;
  }
  pose.residual = weighted_median(pairs, pose);
  return pose;
}

std::optional<Pose> best_pose(Pairs pairs, PoseKind kind, double handedness) {
  constexpr int n_trials = 300;
  std::vector<double> weights;
  for (const CorrespondingPoints& p : pairs) weights.push_back(p.weight);
  std::optional<Pose> best = least_squares(pairs, weights, kind, handedness);
  if (!best) return best;
  best->residual = weighted_median(pairs, *best);
  std::mt19937 random(1);
  for (int trial = 0; trial < n_trials; ++trial) {
    // The generator's numbers are the same everywhere, while the library's distributions are not.
    std::array<CorrespondingPoints, 3> triple;
    for (CorrespondingPoints& p : triple) p = pairs[random() % pairs.size()];
    std::optional<Pose> pose = least_squares(triple, std::array{1.0, 1.0, 1.0}, kind, handedness);
    if (!pose || !median_is_below(pairs, *pose, best->residual)) continue;
    pose->residual = weighted_median(pairs, *pose);
    best = pose;
  }
  return improved(pairs, *best, kind, handedness);
}

/// Distance of the first point of the template from the one farthest from it.
double extent_of(Pairs pairs) {
  double largest = 0;
  for (const CorrespondingPoints& p : pairs) largest = std::max(largest, (p.on_template - pairs[0].on_template).norm());
  return largest;
}

}  // namespace

bool Pose::is_mirrored() const { return rotation.determinant() < 0; }

Pose fit_pose(Pairs pairs, PoseKind kind, Mirroring mirroring) {
  if (pairs.size() < 3) throw_input_error("a pose needs at least three pairs of points; there are {}", pairs.size());
  std::optional<Pose> pose, mirrored;
  if (mirroring != Mirroring::always) pose = best_pose(pairs, kind, 1);
  if (mirroring != Mirroring::never) mirrored = best_pose(pairs, kind, -1);
  // Where few or coplanar points fit both ways, rounding must not decide.
  if (mirrored &&
      (!pose || (mirrored->residual < mirrored_gain * pose->residual && pose->residual > 1e-9 * extent_of(pairs))))
    pose = mirrored;
  if (!pose) throw_input_error("a pose needs pairs of points that do not lie on one line");
  return *pose;
}

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
