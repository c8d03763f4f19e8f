#include "matching/alignment/choose_pose.h"

#include "alignment/pose/fit_pose.h"

#include <Eigen/LU>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace shellmatch {

namespace {

Similarity<3> fitted_pose(const std::vector<CorrespondingPoints>& pairs, PoseKind kind, Mirroring mirroring) {
  return fit_pose(pairs, kind, mirroring).similarity();
}

Similarity<2> fitted_pose(const std::vector<CorrespondingPointsIn<2>>& pairs, PoseKind kind, Mirroring mirroring) {
  return fit_planar_pose(pairs, kind, mirroring);
}

// Sizes that differ by less are those of two individuals: the elastic energy is to decide about them.
constexpr double similar_size = 1.25;

// Of the thousand pairs of a search, so many neighbours lie within a fourteenth of the root of the area: hardly
// anything bends between them, and errors of a few hundredths average out.
constexpr std::size_t near_pairs = 16, many_pairs = 50;
constexpr std::size_t most_centres = 500;  // for speed

/// How many times as large the template is: the median over points of what the distances of their nearest neighbours
/// are multiplied by.
template <int Dim>
double local_size(const std::vector<CorrespondingPointsIn<Dim>>& pairs) {
  std::vector<double> ratios;
  std::vector<std::pair<double, std::size_t>> nearest(pairs.size());
  for (std::size_t i = 0; i < pairs.size(); i += 1 + pairs.size() / most_centres) {
    for (std::size_t j = 0; j < pairs.size(); ++j)
      nearest[j] = {(pairs[j].on_reference - pairs[i].on_reference).norm(), j};
    std::ranges::partial_sort(nearest, nearest.begin() + near_pairs + 1);
    double here = 0, there = 0;
    for (std::size_t k = 0; k <= near_pairs; ++k) {
      here += nearest[k].first;
      there += (pairs[nearest[k].second].on_template - pairs[i].on_template).norm();
    }
    if (here > 0 && there > 0) ratios.push_back(there / here);
  }
  if (ratios.empty()) return 1;
  std::ranges::nth_element(ratios, ratios.begin() + static_cast<std::ptrdiff_t>(ratios.size() / 2));
  return ratios[ratios.size() / 2];
}

/// The best pose of this scale.
template <int Dim>
Similarity<Dim> pose_of_scale(std::vector<CorrespondingPointsIn<Dim>> pairs, double scale, Mirroring mirroring) {
  for (auto& pair : pairs) pair.on_reference *= scale;
  Similarity<Dim> pose = fitted_pose(pairs, PoseKind::rigid, mirroring);
  pose.scale = scale;
  return pose;
}

}  // namespace

template <int Dim>
double angle_in_degrees(const Mat<Dim>& rotation) {
  double angle = 0;
  if constexpr (Dim == 2) {
    angle = std::abs(std::atan2(rotation(1, 0), rotation(0, 0)));
  } else {
    const double handed = rotation.determinant() < 0 ? -1 : 1;
    angle = std::acos(std::clamp((handed * rotation.trace() - 1) / 2, -1.0, 1.0));
  }
  return angle * 180 / std::numbers::pi;
}

template <int Dim>
std::string pose_text(const Similarity<Dim>& pose, std::string_view moved) {
  if (pose.is_identity()) return fmt::format("the {} begins as it lies", moved);
  return fmt::format("the {} is turned by {:.0f} degrees{}{}", moved, angle_in_degrees<Dim>(pose.rotation),
                     pose.rotation.determinant() < 0 ? " and mirrored" : "",
                     pose.scale == 1 ? "" : fmt::format(" and scaled by {:.3g}", pose.scale));
}

template <int Dim>
Similarity<Dim> choose_pose(const std::vector<CorrespondingPointsIn<Dim>>& pairs, const AlignOptions& options,
                            Mirroring mirroring) {
  if (options.mode == AlignMode::rigid) return fitted_pose(pairs, PoseKind::rigid, mirroring);
  if (options.mode != AlignMode::automatic) return fitted_pose(pairs, PoseKind::similarity, mirroring);
  double size =
      pairs.size() < many_pairs ? fitted_pose(pairs, PoseKind::similarity, mirroring).scale : local_size(pairs);
  if (size < similar_size && size > 1 / similar_size) size = 1;
  const Similarity<Dim> pose = pose_of_scale(pairs, size, mirroring);
  const bool gains = median_distance(pairs, Similarity<Dim>{}) > options.pose_gain * median_distance(pairs, pose);
  return gains ? pose : Similarity<Dim>{};
}

SHELLMATCH_2D_3D(angle_in_degrees);
SHELLMATCH_2D_3D(pose_text);
SHELLMATCH_2D_3D(choose_pose);

}  // namespace shellmatch
