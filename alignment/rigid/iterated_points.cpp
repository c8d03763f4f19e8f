#include "alignment/rigid/iterated_points.h"

#include <Eigen/Cholesky>
#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

namespace shellmatch {

namespace {

/// A moved point of the first surface, the one of the second that it is to meet, and both normals.
struct MetPoints {
  Vec<3> moved, goal, moved_normal, goal_normal;
  double distance() const { return (moved - goal).norm(); }
};

std::vector<MetPoints> met_points(const SampledPair& pair, const RigidMotion& motion) {
  std::vector<MetPoints> met;
  for (const SurfacePoint& x : pair.on_first) {
    const Vec<3> moved = motion(x.point);
    const SurfacePoint y = pair.nearest_on_second(moved);
    met.push_back({moved, y.point, motion.rotation * x.normal, y.normal});
  }
  for (const SurfacePoint& y : pair.on_second) {
    const SurfacePoint x = pair.nearest_on_first(motion.inverse(y.point));
    met.push_back({motion(x.point), y.point, motion.rotation * x.normal, y.normal});
  }
  return met;
}

Mat<3> cross_matrix(const Vec<3>& x) {
  Mat<3> m;
  m << 0, -x.z(), x.y(), x.z(), 0, -x.x(), -x.y(), x.x(), 0;
  return m;
}

}  // namespace

RigidScore rigid_score(const SampledPair& pair, const RigidMotion& motion) {
  RigidScore score;
  const std::vector<MetPoints> met = met_points(pair, motion);
  for (const MetPoints& m : met) {
    score.distance += (m.moved - m.goal).squaredNorm() / static_cast<double>(met.size());
    score.orientation += 0.5 * (1 - m.moved_normal.dot(m.goal_normal)) / static_cast<double>(met.size());
  }
  score.distance = std::sqrt(score.distance);
  return score;
}

RigidMotion iterated_points(const SampledPair& pair, RigidMotion motion, int n_sweeps) {
  constexpr double kept = 0.9, point_weight = 0.05;
  for (int sweep = 0; sweep < n_sweeps; ++sweep) {
    std::vector<MetPoints> met = met_points(pair, motion);
    std::vector<double> distances;
    for (const MetPoints& m : met) distances.push_back(m.distance());
    const auto last = distances.begin() + static_cast<std::ptrdiff_t>(kept * static_cast<double>(distances.size() - 1));
    std::nth_element(distances.begin(), last, distances.end());
    // Unknowns: a small turn w about the origin and a step t, x -> x + w x x + t.
    Eigen::Matrix<double, 6, 6> matrix = Eigen::Matrix<double, 6, 6>::Identity() * 1e-9;
    Eigen::Matrix<double, 6, 1> right = Eigen::Matrix<double, 6, 1>::Zero();
    for (const MetPoints& m : met) {
      if (m.distance() > *last || m.moved_normal.dot(m.goal_normal) <= 0) continue;
      Eigen::Matrix<double, 3, 6> derivative;
      derivative << -cross_matrix(m.moved), Mat<3>::Identity();
      const Mat<3> weight = m.goal_normal * m.goal_normal.transpose() + point_weight * Mat<3>::Identity();
      matrix += derivative.transpose() * weight * derivative;
      right += derivative.transpose() * weight * (m.goal - m.moved);
    }
    const Eigen::Matrix<double, 6, 1> step = matrix.ldlt().solve(right);
    const double angle = step.head<3>().norm();
    const Mat<3> turn =
        angle > 0 ? Eigen::AngleAxisd(angle, step.head<3>() / angle).toRotationMatrix() : Mat<3>(Mat<3>::Identity());
    motion.rotation = turn * motion.rotation;
    motion.offset = turn * motion.offset + step.tail<3>();
    if (step.norm() < 1e-4) break;
  }
  return motion;
}

}  // namespace shellmatch
