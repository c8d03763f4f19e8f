#include "matching/prediction/predict_pose.h"

#include "alignment/pose/fit_pose.h"
#include "alignment/rigid/find_rigid_pairs.h"
#include "base/parallel.h"
#include "matching/pairs/coverage.h"

#include <Eigen/Cholesky>
#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>

namespace shellmatch {

namespace {

constexpr std::size_t n_samples = 1000, n_poses = 2;
constexpr int n_sweeps = 10, n_rigid_sweeps = 8;
constexpr double point_weight = 0.1;     // beside 1 for the tangent plane
constexpr double least_agreement = 0.5;  // of normals, as cosine
constexpr double closeness = 0.01;       // expected of the fit, in diagonals of the template
constexpr double same_angle = 0.5;       // radians: such poses have come to the same

/// The images' mean and the differences from it.
struct ImageModel {
  Surface<3> mean;
  std::vector<std::vector<Vec<3>>> differences;
};

/// The facets whose corners all images know.
Surface<3> known_part(const Surface<3>& reference, const std::vector<std::vector<Vec<3>>>& images) {
  Surface<3> known{reference.vertices, {}};
  for (const auto& facet : reference.facets) {
    const auto is_known = [&](Index v) {
      return std::ranges::all_of(images, [&](const auto& image) { return image[v].allFinite(); });
    };
    if (std::ranges::all_of(facet, is_known)) known.facets.push_back(facet);
  }
  return known;
}

/// Vertices spread over a surface, whatever its place and size.
std::vector<Index> spread_vertices(Surface<3> surface, std::size_t most) {
  Box<3> box;
  for (const auto& facet : surface.facets)
    for (const Index v : facet) box.add(surface.vertices[v]);
  const double size = std::max((box.max - box.min).maxCoeff(), std::numeric_limits<double>::min());
  for (Vec<3>& x : surface.vertices) x = (x - box.min) / size;
  std::vector<Index> vertices;
  for (const auto& sample : sample_vertices<3>(surface, most, [](const Vec<3>&) { return true; }))
    vertices.push_back(sample.vertex);
  return vertices;
}

/// In the frame of the first image, on which the others are laid without a change of their size.
ImageModel model_of(const Surface<3>& known, const std::vector<Index>& samples,
                    std::vector<std::vector<Vec<3>>> images) {
  for (std::size_t i = 1; i < images.size(); ++i) {
    std::vector<CorrespondingPoints> pairs;
    for (const Index v : samples) pairs.push_back({images[i][v], images[0][v]});
    const Pose pose = fit_pose(pairs, PoseKind::rigid);
    for (Vec<3>& x : images[i]) x = pose(x);
  }
  ImageModel model{known, images};
  for (std::size_t v = 0; v < known.vertices.size(); ++v) {
    Vec<3> sum = Vec<3>::Zero();
    for (const auto& image : images) sum += image[v];
    const bool is_known = sum.allFinite();
    model.mean.vertices[v] =
        is_known ? Vec<3>(sum / static_cast<double>(images.size())) : Vec<3>(images[0][samples[0]]);
    for (auto& difference : model.differences)
      difference[v] = is_known ? Vec<3>(difference[v] - model.mean.vertices[v]) : Vec<3>(Vec<3>::Zero());
  }
  if (images.size() < 2) model.differences.clear();
  return model;
}

/// Samples and nearest points of a surface in the coordinates of the input.
class Target {
 public:
  explicit Target(const Surface<3>& surface) : surface_(surface) {}
  SurfacePoint nearest(const Vec<3>& x) const {
    return moved_back(surface_.nearest((x - surface_.centre()) / surface_.radius()));
  }
  std::vector<SurfacePoint> samples() const {
    std::vector<SurfacePoint> samples = surface_.samples(n_samples);
    for (SurfacePoint& sample : samples) sample = moved_back(sample);
    return samples;
  }

 private:
  SurfacePoint moved_back(const SurfacePoint& p) const {
    return {surface_.centre() + surface_.radius() * p.point, p.normal};
  }
  NormalizedSurface surface_;
};

/// The combination of mean and differences, with a pose, that comes nearest to the target.
class Fit {
 public:
  Fit(const ImageModel& model, const std::vector<Index>& samples, const Pose& start, const Target& target,
      double diagonal)
      : model_(model),
        samples_(samples),
        target_(target),
        diagonal_(diagonal),
        pose_(start),
        factors_(Eigen::VectorXd::Zero(static_cast<Eigen::Index>(model.differences.size()))) {}

  void sweep() {
    move();
    const Eigen::Index n_modes = factors_.size(), n = 7 + n_modes;
    Eigen::MatrixXd normal_matrix = Eigen::MatrixXd::Zero(n, n);
    Eigen::VectorXd right = Eigen::VectorXd::Zero(n);
    Vec<3> centre = Vec<3>::Zero();
    for (const Index v : samples_) centre += shape_.vertices[v] / static_cast<double>(samples_.size());
    Eigen::Matrix<double, 3, Eigen::Dynamic> design(3, n);
    for (std::size_t k = 0; k < samples_.size(); ++k) {
      const double weight = weights_[k];
      if (weight == 0) continue;
      const Index v = samples_[k];
      const Vec<3> arm = (shape_.vertices[v] - centre) / diagonal_;
      design.leftCols<3>() << 0, arm.z(), -arm.y(), -arm.z(), 0, arm.x(), arm.y(), -arm.x(), 0;
      design.col(3) = arm;
      design.middleCols<3>(4).setIdentity();
      for (Eigen::Index m = 0; m < n_modes; ++m)
        design.col(7 + m) = pose_.scale / diagonal_ * (pose_.rotation * model_.differences[m][v]);
      const Vec<3> normal = goals_[k].normal;
      const Mat<3> metric = weight * (normal * normal.transpose() + point_weight * Mat<3>::Identity());
      normal_matrix += design.transpose() * metric * design;
      right += design.transpose() * (metric * ((goals_[k].point - shape_.vertices[v]) / diagonal_));
    }
    const double scale =
        closeness * closeness * (static_cast<double>(n_modes) - 1) / static_cast<double>(samples_.size());
    for (Eigen::Index m = 0; m < n_modes; ++m) {
      const double prior = static_cast<double>(samples_.size()) * std::max(scale, 0.0) + 1e-12;
      normal_matrix(7 + m, 7 + m) += prior;
      right[7 + m] -= prior * factors_[m];
    }
    normal_matrix.diagonal().array() += 1e-9 * normal_matrix.trace() / static_cast<double>(n);
    const Eigen::VectorXd step = normal_matrix.ldlt().solve(right);
    const Vec<3> turn = step.head<3>();
    const double angle = turn.norm(), growth = std::exp(std::clamp(step[3], -0.2, 0.2));
    const Mat<3> rotation =
        angle > 0 ? Mat<3>(Eigen::AngleAxisd(angle, turn / angle).toRotationMatrix()) : Mat<3>(Mat<3>::Identity());
    pose_.translation = growth * (rotation * (pose_.translation - centre)) + centre + diagonal_ * step.segment<3>(4);
    pose_.rotation = rotation * pose_.rotation;
    pose_.scale *= growth;
    factors_ += step.tail(n_modes);
  }

  /// Where the fit has come to. \pre no sweep has followed
  void move() {
    shape_ = model_.mean;
    for (std::size_t v = 0; v < shape_.vertices.size(); ++v) {
      for (Eigen::Index m = 0; m < factors_.size(); ++m)
        shape_.vertices[v] += factors_[m] * model_.differences[static_cast<std::size_t>(m)][v];
      shape_.vertices[v] = pose_(shape_.vertices[v]);
    }
    const std::vector<Vec<3>> normals = vertex_normals(shape_);
    goals_.resize(samples_.size());
    weights_.resize(samples_.size());
    parallel_for(samples_.size(), [&](std::size_t k) {
      const Index v = samples_[k];
      goals_[k] = target_.nearest(shape_.vertices[v]);
      const double agreement = normals[v].dot(goals_[k].normal);
      weights_[k] = agreement > least_agreement ? agreement * agreement : 0;
    });
  }

  /// Both ways: from the samples, and from those of the target.
  void measure(PredictedPose& result) const {
    const Target shape(shape_);
    const std::vector<SurfacePoint> others = target_.samples();
    std::vector<double> distances(samples_.size() + others.size());
    parallel_for(distances.size(), [&](std::size_t i) {
      distances[i] =
          i < samples_.size()
              ? (goals_[i].point - shape_.vertices[samples_[i]]).norm()
              : (shape.nearest(others[i - samples_.size()].point).point - others[i - samples_.size()].point).norm();
    });
    double sum = 0;
    for (const double d : distances) sum += d * d;
    result.residual = std::sqrt(sum / static_cast<double>(distances.size())) / diagonal_;
    result.farthest = *std::ranges::max_element(distances) / diagonal_;
  }

  const Mat<3>& rotation() const { return pose_.rotation; }
  const std::vector<SurfacePoint>& goals() const { return goals_; }
  const std::vector<double>& weights() const { return weights_; }

 private:
  const ImageModel& model_;
  const std::vector<Index>& samples_;
  const Target& target_;
  double diagonal_;
  Pose pose_;
  Eigen::VectorXd factors_;
  Surface<3> shape_;
  std::vector<SurfacePoint> goals_;  // of the samples
  std::vector<double> weights_;      // of these; 0 where none faces
};

}  // namespace

PredictedPose predict_pose(const Surface<3>& reference, const std::vector<std::vector<Vec<3>>>& images,
                           const Surface<3>& template_surface, const AlignmentOptions& options) {
  const Surface<3> known = known_part(reference, images);
  if (known.facets.empty()) return {};
  const std::vector<Index> samples = spread_vertices(known, n_samples);
  const ImageModel model = model_of(known, samples, images);
  AlignmentOptions few = options;
  few.refined = n_poses;
  few.mirror = false;
  const Target target(template_surface);
  const double diagonal = bounding_box(template_surface.vertices).diagonal();
  PredictedPose best;
  best.margin = std::numeric_limits<double>::infinity();
  Mat<3> rotation;
  for (const RigidCandidate& candidate :
       find_rigid_pairs(model.mean, template_surface, few, n_rigid_sweeps).candidates) {
    Fit fit(model, samples, candidate.pose, target, diagonal);
    for (int sweep = 0; sweep < n_sweeps; ++sweep) fit.sweep();
    fit.move();
    PredictedPose found;
    fit.measure(found);
    for (std::size_t k = 0; k < samples.size(); ++k)
      if (fit.weights()[k] > 0)
        found.pairs.push_back({reference.vertices[samples[k]], fit.goals()[k].point, fit.weights()[k]});
    if (found.pairs.empty()) continue;
    found.margin = best.margin;
    const bool is_first = best.pairs.empty(), is_nearer = is_first || found.residual < best.residual;
    if (!is_first && Eigen::AngleAxisd(rotation.transpose() * fit.rotation()).angle() > same_angle)
      (is_nearer ? found : best).margin =
          is_nearer ? best.residual / found.residual : std::min(best.margin, found.residual / best.residual);
    if (!is_nearer) continue;
    best = std::move(found);
    rotation = fit.rotation();
  }
  return best;
}

}  // namespace shellmatch
