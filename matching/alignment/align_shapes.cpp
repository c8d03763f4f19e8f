#include "matching/alignment/align_shapes.h"

#include "alignment/pairs/find_pairs.h"
#include "alignment/pose/fit_pose.h"
#include "base/error.h"

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

AlignmentSummary summary_of(const Similarity<3>& pose) {
  AlignmentSummary s;
  s.angle = angle_in_degrees(pose.rotation);
  s.scale = pose.scale;
  s.mirrored = pose.rotation.determinant() < 0;
  return s;
}

std::vector<CorrespondingPoints> as_pairs(const std::vector<Landmark<3>>& landmarks) {
  std::vector<CorrespondingPoints> pairs;
  for (const Landmark<3>& l : landmarks) pairs.push_back({l.on_reference, l.on_template, 1});
  return pairs;
}

// Sizes that differ by less are those of two individuals: the elastic energy is to decide about them.
constexpr double similar_size = 1.25;

Similarity<3> pose_from(const std::vector<CorrespondingPoints>& pairs, const AlignOptions& options) {
  const bool may_mirror = options.search.mirror;
  if (options.mode == AlignMode::rigid) return fit_pose(pairs, PoseKind::rigid, may_mirror).similarity();
  const Similarity<3> similar = fit_pose(pairs, PoseKind::similarity, may_mirror).similarity();
  if (options.mode != AlignMode::automatic) return similar;
  const bool same_size = similar.scale < similar_size && similar.scale > 1 / similar_size;
  const Similarity<3> pose = same_size ? fit_pose(pairs, PoseKind::rigid, may_mirror).similarity() : similar;
  const bool gains = median_distance(pairs, {}) > options.pose_gain * median_distance(pairs, pose);
  return gains ? pose : Similarity<3>{};
}

Alignment<3> search(const ShapePair<3>& shapes, const AlignOptions& options, Observer& observer) {
  const AutomaticPairs found = find_pairs(shapes.reference.surface, shapes.template_shape.surface, options.search);
  const PairCandidate& first = found.candidates.front();
  const bool is_doubtful = !(first.score <= options.doubtful_score && found.margin >= options.doubtful_margin) || first.pairs.size() < 10;
  const bool is_used = first.pairs.size() >= 10 && (!is_doubtful || options.mode != AlignMode::automatic);
  Alignment<3> result;
  if (is_used) {
    result.pose = pose_from(first.pairs, options);
    if (options.weight > 0)
      for (const CorrespondingPoints& pair : first.pairs)
        result.pairs.push_back({fmt::format("pair {}", result.pairs.size() + 1), pair.on_reference, pair.on_template, pair.weight});
  }
  AlignmentSummary& s = result.summary.emplace(summary_of(result.pose));
  s.score = first.score;
  if (std::isfinite(found.margin)) s.margin = found.margin;
  s.n_pairs = is_used ? static_cast<int>(first.pairs.size()) : 0;
  s.doubtful = is_doubtful;
  observer.note(fmt::format("alignment: {}{} pairs, score {:.2f}, margin {:.2f}; {}{}", is_doubtful ? "doubtful: " : "",
                            first.pairs.size(), first.score, found.margin,
                            is_used ? "" : "they are not used, and ", pose_text(result.pose)));
  return result;
}

Alignment<3> align(const ShapePair<3>& shapes, const std::vector<Landmark<3>>& landmarks, const AlignOptions& options,
                   Observer& observer) {
  if (options.mode != AlignMode::landmarks) return search(shapes, options, observer);
  if (landmarks.empty()) throw_input_error("align.mode: landmarks: there are none; expected a file of them (landmarks.file)");
  Alignment<3> result;
  result.pose = fit_pose(as_pairs(landmarks), PoseKind::similarity, options.search.mirror).similarity();
  result.summary = summary_of(result.pose);
  observer.note(fmt::format("alignment by {} landmarks; {}", landmarks.size(), pose_text(result.pose)));
  return result;
}

Alignment<2> align(const ShapePair<2>&, const std::vector<Landmark<2>>&, const AlignOptions& options, Observer&) {
  if (options.mode != AlignMode::automatic)
    throw_input_error("align.mode: {}: is there for surfaces in space alone; expected none or auto for contours",
                      enum_name(options.mode));
  return {};
}

}  // namespace

template <int Dim>
Alignment<Dim> align_shapes(const ShapePair<Dim>& shapes, const std::vector<Landmark<Dim>>& landmarks,
                            const ExperimentOptions& options, Observer& observer) {
  if (options.align.mode == AlignMode::none) return {};
  observer.stage("alignment");
  Alignment<Dim> result = align(shapes, landmarks, options.align, observer);
  if (result.summary) result.summary->mode = enum_name(options.align.mode);
  return result;
}

template Alignment<2> align_shapes<2>(const ShapePair<2>&, const std::vector<Landmark<2>>&, const ExperimentOptions&, Observer&);
template Alignment<3> align_shapes<3>(const ShapePair<3>&, const std::vector<Landmark<3>>&, const ExperimentOptions&, Observer&);

}  // namespace shellmatch
