#include "matching/alignment/choose_pose.h"

#include "alignment/pose/fit_pose.h"

#include <Eigen/LU>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace shellmatch {

namespace {

double median_distance(const std::vector<CorrespondingPoints>& pairs, const Similarity<3>& pose) {
  std::vector<double> distances;
  for (const CorrespondingPoints& pair : pairs) distances.push_back((pose(pair.on_reference) - pair.on_template).norm());
  const auto middle = distances.begin() + static_cast<std::ptrdiff_t>(distances.size() / 2);
  std::nth_element(distances.begin(), middle, distances.end());
  return *middle;
}

// Sizes that differ by less are those of two individuals: the elastic energy is to decide about them.
constexpr double similar_size = 1.25;

}  // namespace

double angle_in_degrees(const Mat<3>& rotation) {
  const double handed = rotation.determinant() < 0 ? -1 : 1;
  return std::acos(std::clamp((handed * rotation.trace() - 1) / 2, -1.0, 1.0)) * 180 / std::numbers::pi;
}

std::string pose_text(const Similarity<3>& pose) {
  if (pose.is_identity()) return "the reference begins as it lies";
  return fmt::format("the reference is turned by {:.0f} degrees{}{}", angle_in_degrees(pose.rotation),
                     pose.rotation.determinant() < 0 ? " and mirrored" : "",
                     pose.scale == 1 ? "" : fmt::format(" and scaled by {:.3g}", pose.scale));
}

Similarity<3> choose_pose(const std::vector<CorrespondingPoints>& pairs, const AlignOptions& options) {
  const bool may_mirror = options.search.mirror;
  if (options.mode == AlignMode::rigid) return fit_pose(pairs, PoseKind::rigid, may_mirror).similarity();
  const Similarity<3> similar = fit_pose(pairs, PoseKind::similarity, may_mirror).similarity();
  if (options.mode != AlignMode::automatic) return similar;
  const bool same_size = similar.scale < similar_size && similar.scale > 1 / similar_size;
  const Similarity<3> pose = same_size ? fit_pose(pairs, PoseKind::rigid, may_mirror).similarity() : similar;
  const bool gains = median_distance(pairs, {}) > options.pose_gain * median_distance(pairs, pose);
  return gains ? pose : Similarity<3>{};
}

}  // namespace shellmatch
