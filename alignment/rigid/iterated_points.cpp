#include "alignment/rigid/iterated_points.h"

#include "base/error.h"
#include "geometry/surface/facet_point.h"
#include "geometry/surface/pseudonormals.h"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <utility>

namespace shellmatch {

namespace {

double area_of(const Surface<3>& surface) {
  const double area = surface_measure(surface);
  if (!(area > 0) || !std::isfinite(area)) throw_input_error("a surface without area cannot be aligned");
  return area;
}

}  // namespace

NormalizedSurface::NormalizedSurface(const Surface<3>& input) : surface_(input) {
  const double area = area_of(input);
  const auto corners = [&](std::size_t f) {
    const auto& [a, b, c] = surface_.facets[f];
    return std::array{surface_.vertices[a], surface_.vertices[b], surface_.vertices[c]};
  };
  for (std::size_t f = 0; f < input.facets.size(); ++f) {
    const auto [a, b, c] = corners(f);
    centre_ += facet_measure(input, static_cast<Index>(f)) / area * (a + b + c) / 3;
  }
  for (Vec<3>& x : surface_.vertices) x -= centre_;
  // The midpoints of the edges, a third of the area each, integrate quadratic functions exactly.
  Mat<3> moments = Mat<3>::Zero();
  double sum = 0;
  for (std::size_t f = 0; f < input.facets.size(); ++f) {
    const auto [a, b, c] = corners(f);
    const double share = facet_measure(surface_, static_cast<Index>(f)) / area;
    for (const Vec<3>& x : {Vec<3>((a + b) / 2), Vec<3>((b + c) / 2), Vec<3>((c + a) / 2)})
      moments += share / 3 * x * x.transpose();
    area_up_to_.push_back(sum += share);
  }
  radius_ = std::sqrt(moments.trace());
  for (Vec<3>& x : surface_.vertices) x /= radius_;
  axes_ = Eigen::SelfAdjointEigenSolver<Mat<3>>(moments).eigenvectors();
  if (axes_.determinant() < 0) axes_.col(0) *= -1;
  for (std::size_t f = 0; f < input.facets.size(); ++f)
    normals_.push_back(unit_or_zero<3>(facet_normal(surface_, static_cast<Index>(f))));
  tree_.emplace(surface_);
}

std::vector<SurfacePoint> NormalizedSurface::samples(std::size_t n) const {
  std::vector<SurfacePoint> samples;
  for (std::size_t k = 0; k < n; ++k) {
    const double at = (static_cast<double>(k) + 0.5) / static_cast<double>(n) * area_up_to_.back();
    const auto f =
        static_cast<std::size_t>(std::lower_bound(area_up_to_.begin(), area_up_to_.end(), at) - area_up_to_.begin());
    // Kronecker's sequence of the golden ratio's kind spreads the points over the facets' interiors.
    double u = std::fmod(0.5 + 0.7548776662466927 * static_cast<double>(k), 1.0),
           v = std::fmod(0.5 + 0.5698402909980532 * static_cast<double>(k), 1.0);
    if (u + v > 1) {
      u = 1 - u;
      v = 1 - v;
    }
    const auto& [a, b, c] = surface_.facets[f];
    samples.push_back(
        {(1 - u - v) * surface_.vertices[a] + u * surface_.vertices[b] + v * surface_.vertices[c], normals_[f]});
  }
  return samples;
}

SurfacePoint NormalizedSurface::nearest(const Vec<3>& x) const {
  const Index f = tree_->nearest(x);
  return {closest_point_on_facet<3>(surface_, f, x).point, normals_[static_cast<std::size_t>(f)]};
}

SampleCloud::SampleCloud(std::vector<SurfacePoint> samples)
    : samples_(std::move(samples)), points_(samples_.size(), 3) {
  for (std::size_t i = 0; i < samples_.size(); ++i)
    points_.row(static_cast<Eigen::Index>(i)) = samples_[i].point.transpose().array().cast<float>();
}

const SurfacePoint& SampleCloud::nearest(const Vec<3>& x) const {
  const Eigen::Array3f at = x.cast<float>();
  static thread_local Eigen::ArrayXf squares;
  squares = (points_.col(0) - at[0]).square() + (points_.col(1) - at[1]).square() + (points_.col(2) - at[2]).square();
  // Not minCoeff(&place), which Eigen does not vectorise.
  const auto least = std::find(squares.begin(), squares.end(), squares.minCoeff());
  return samples_[static_cast<std::size_t>(least - squares.begin())];
}

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
