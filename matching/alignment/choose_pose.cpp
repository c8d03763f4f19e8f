#include "matching/alignment/choose_pose.h"

#include "alignment/pose/fit_pose.h"

#include <Eigen/LU>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

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
                            Mirroring mirroring, LengthUnit unit) {
  if (options.mode == AlignMode::rigid) return fitted_pose(pairs, PoseKind::rigid, mirroring);
  const Similarity<Dim> similar = fitted_pose(pairs, PoseKind::similarity, mirroring);
  if (options.mode != AlignMode::automatic) return similar;
  const bool same_size =
      unit == LengthUnit::shared || (similar.scale < similar_size && similar.scale > 1 / similar_size);
  const Similarity<Dim> pose = same_size ? fitted_pose(pairs, PoseKind::rigid, mirroring) : similar;
  const bool gains = median_distance(pairs, Similarity<Dim>{}) > options.pose_gain * median_distance(pairs, pose);
  return gains ? pose : Similarity<Dim>{};
}

#define SHELLMATCH_INSTANTIATE(Dim)                                                                              \
  template double angle_in_degrees<Dim>(const Mat<Dim>&);                                                        \
  template std::string pose_text<Dim>(const Similarity<Dim>&, std::string_view);                                 \
  template Similarity<Dim> choose_pose<Dim>(const std::vector<CorrespondingPointsIn<Dim>>&, const AlignOptions&, \
                                            Mirroring, LengthUnit)
SHELLMATCH_INSTANTIATE(2);
SHELLMATCH_INSTANTIATE(3);
#undef SHELLMATCH_INSTANTIATE

}  // namespace shellmatch
