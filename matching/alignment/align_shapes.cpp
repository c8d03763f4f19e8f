#include "matching/alignment/align_shapes.h"

#include "alignment/pairs/find_pairs.h"
#include "alignment/pose/fit_pose.h"
#include "base/error.h"
#include "matching/alignment/choose_pose.h"
#include "matching/alignment/choose_start.h"

#include <Eigen/LU>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace shellmatch {

namespace {

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

std::vector<Landmark<3>> as_landmarks(const std::vector<CorrespondingPoints>& pairs) {
  std::vector<Landmark<3>> landmarks;
  for (const CorrespondingPoints& pair : pairs)
    landmarks.push_back({fmt::format("pair {}", landmarks.size() + 1), pair.on_reference, pair.on_template, pair.weight});
  return landmarks;
}

// Up to this score pairs are as exact as 5000 vertices let them be; gorilla to man scores 0.8, with twice the errors.
constexpr double isometric_score = 0.6;

/// A start for each candidate of the search by spectra, and the margin of the first.
struct Search {
  std::vector<Start<3>> starts;
  double margin;
};

Search search_spectra(const ShapePair<3>& shapes, const AlignOptions& options) {
  const AutomaticPairs found = find_pairs(shapes.reference.surface, shapes.template_shape.surface, options.search);
  Search search{{}, found.margin};
  for (const PairCandidate& candidate : found.candidates) {
    Start<3>& start = search.starts.emplace_back();
    start.n_pairs = candidate.pairs.size();
    start.score = candidate.score;
    start.is_identity = candidate.is_identity && !candidate.is_mirrored;
    if (start.n_pairs < min_pairs) continue;
    start.alignment.pose = choose_pose(candidate.pairs, options);
    start.alignment.spread = std::max(1.0, std::pow(candidate.score / isometric_score, 3));
    if (options.weight > 0) start.alignment.pairs = as_landmarks(candidate.pairs);
  }
  return search;
}

Alignment<3> search(const ShapePair<3>& shapes, const ExperimentOptions& options, Observer& observer) {
  const AlignOptions& align = options.align;
  const bool is_automatic = align.mode == AlignMode::automatic;
  Search found = search_spectra(shapes, align);
  const StartChoice choice = choose_start(shapes, found.starts, found.margin, options, observer);
  Start<3>& best = found.starts[choice.index];
  const bool has_pairs = best.n_pairs >= min_pairs;
  const bool is_doubtful = !has_pairs || !(best.score <= align.doubtful_score && choice.margin >= align.doubtful_margin);
  const bool is_used = has_pairs && !(is_automatic && (is_doubtful || choice.as_it_lies));
  Alignment<3> result;
  if (is_used) result = std::move(best.alignment);
  AlignmentSummary& s = result.summary.emplace(summary_of(result.pose));
  s.score = best.score;
  if (std::isfinite(choice.margin)) s.margin = choice.margin;
  s.n_tried = static_cast<int>(choice.n_tried);
  s.n_pairs = is_used ? static_cast<int>(best.n_pairs) : 0;
  s.doubtful = is_doubtful;
  std::string why;
  if (choice.n_tried > 0) why += fmt::format(", chosen among {} by the energy reached", choice.n_tried);
  if (choice.as_it_lies) why += ", not clearly better than the shapes as they lie";
  observer.note(fmt::format("alignment: {}{} pairs, score {:.2f}, margin {:.2f}{}; {}{}", is_doubtful ? "doubtful: " : "",
                            best.n_pairs, best.score, choice.margin, why, is_used ? "" : "they are not used, and ",
                            pose_text(result.pose)));
  return result;
}

Alignment<3> align(const ShapePair<3>& shapes, const std::vector<Landmark<3>>& landmarks, const ExperimentOptions& options,
                   Observer& observer) {
  if (options.align.mode != AlignMode::landmarks) return search(shapes, options, observer);
  if (landmarks.empty()) throw_input_error("align.mode: landmarks: there are none; expected a file of them (landmarks.file)");
  Alignment<3> result;
  result.pose = fit_pose(as_pairs(landmarks), PoseKind::similarity, options.align.search.mirror).similarity();
  result.summary = summary_of(result.pose);
  observer.note(fmt::format("alignment by {} landmarks; {}", landmarks.size(), pose_text(result.pose)));
  return result;
}

Alignment<2> align(const ShapePair<2>&, const std::vector<Landmark<2>>&, const ExperimentOptions& options, Observer&) {
  if (options.align.mode != AlignMode::automatic)
    throw_input_error("align.mode: {}: is there for surfaces in space alone; expected none or auto for contours",
                      enum_name(options.align.mode));
  return {};
}

}  // namespace

template <int Dim>
Alignment<Dim> align_shapes(const ShapePair<Dim>& shapes, const std::vector<Landmark<Dim>>& landmarks,
                            const ExperimentOptions& options, Observer& observer) {
  const AlignMode mode = options.align.mode;
  // Who takes coordinates as they are means that the shapes lie as they belong.
  if (mode == AlignMode::none || (mode == AlignMode::automatic && options.input.placement == PlacementKind::as_is)) return {};
  observer.stage("alignment");
  Alignment<Dim> result = align(shapes, landmarks, options, observer);
  if (result.summary) result.summary->mode = enum_name(mode);
  return result;
}

template Alignment<2> align_shapes<2>(const ShapePair<2>&, const std::vector<Landmark<2>>&, const ExperimentOptions&, Observer&);
template Alignment<3> align_shapes<3>(const ShapePair<3>&, const std::vector<Landmark<3>>&, const ExperimentOptions&, Observer&);

}  // namespace shellmatch
