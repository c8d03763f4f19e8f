#include "matching/alignment/align_shapes.h"

#include "alignment/clear_margin.h"
#include "alignment/functional_map/map_search.h"
#include "alignment/functional_map/two_way_map.h"
#include "base/error.h"
#include "matching/alignment/choose_pose.h"
#include "matching/alignment/choose_start.h"
#include "matching/alignment/coincidence.h"
#include "matching/alignment/search_starts.h"

#include <Eigen/LU>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>

namespace shellmatch {

namespace {

template <int Dim>
AlignmentSummary summary_of(const Similarity<Dim>& pose) {
  AlignmentSummary s;
  s.angle = angle_in_degrees<Dim>(pose.rotation);
  s.scale = pose.scale;
  s.mirrored = pose.rotation.determinant() < 0;
  return s;
}

/// What a search found, and the choice among it.
template <int Dim>
struct Outcome {
  StartSearch<Dim> search;
  StartChoice choice;
  Start<Dim>& best() { return search.starts[choice.index]; }
};

// A mirrored copy is searched only where something is strange, since it takes as long as the search itself: first maps
// that are clearly better mirrored, a turn to the other side, as of what is mirrored and thin, or no map that is nearly
// isometric.
constexpr double strange_turn = 120;  // degrees

bool is_worth_mirroring(const StartSearch<3>& search, const Start<3>& best, const StartChoice& choice) {
  return best.is_usable() && (search.mirrored_gain > telling_gain || choice.is_doubtful || choice.as_it_lies ||
                              angle_in_degrees<3>(best.alignment.pose.rotation) > strange_turn);
}

template <int Dim>
Outcome<Dim> choice_among(StartSearch<Dim> search, const AlignOptions& options, Trials<Dim>& trials) {
  const StartChoice choice = choose_start(search, options, trials);
  return {std::move(search), choice};
}

/// Spectra are large, and are computed again where an earlier search has left none.
template <int Dim>
StartSearch<Dim> search_by_pairs(const ShapePair<Dim>& shapes, const std::vector<Landmark<Dim>>& landmarks,
                                 const AlignOptions& options, AlignmentFindings<Dim>& findings) {
  const auto search = [&] { return search_starts(shapes, landmarks, options); };
  StartSearch<Dim> result = findings.by_pairs.next(search, [](StartSearch<Dim> found) {
    found.fits_far_better_mirrored = nullptr;
    return found;
  });
  if constexpr (Dim == 3)
    if (!result.fits_far_better_mirrored && !result.is_of_part)
      result.fits_far_better_mirrored = [search](const Start<3>& s) { return search().fits_far_better_mirrored(s); };
  return result;
}

// In diagonals of the template: after a trial from the right pose the shapes are nearer.
constexpr double not_reached = 0.01;

// Several maps of limbs in another pose may be equally good, and all of them nearly right.
bool pairs_stay(Outcome<3>& pairs, Outcome<3>& poses, const AlignOptions& options, const Trials<3>& trials) {
  if (options.bend == BendMode::never || pairs.best().alignment.pairs.empty()) return false;
  const Trial bent = trials.bent(pairs.best().alignment),
              posed = trials(poses.best().is_usable() ? poses.best().alignment : Alignment<3>());
  return posed.template_distance > not_reached || is_more_alike(bent, posed);
}

// A part that was cut off where it is thin has small gaps, and no map of wholes; a whole with holes may have large
// ones.
bool may_be_cut(const ShapePair<3>& shapes) {
  return std::max(shapes.reference.invented_share, shapes.template_shape.invented_share) > least_of_cut;
}

bool is_clear(Outcome<3>& outcome) {
  return outcome.choice.is_usable && !outcome.choice.is_doubtful && outcome.best().score <= nearly_isometric &&
         outcome.choice.margin >= (outcome.search.is_of_part ? clear_margin_of_part : clear_margin);
}

template <int Dim>
Outcome<Dim> search_and_choose(const ShapePair<Dim>& shapes, const std::vector<Landmark<Dim>>& landmarks,
                               const AlignOptions& options, Trials<Dim>& trials, AlignmentFindings<Dim>& findings) {
  Outcome<Dim> outcome = choice_among(search_by_pairs(shapes, landmarks, options, findings), options, trials);
  if constexpr (Dim == 3) {
    if (outcome.search.n_landmarks == 0 && may_be_cut(shapes) && !is_clear(outcome)) {
      const auto search = [&] {
        return (outcome.search.is_of_part ? search_whole_starts : search_partial_starts)(shapes, landmarks, options);
      };
      Outcome<3> other = choice_among(findings.by_pairs.next(search), options, trials);
      if (is_clear(other)) return other;
    }
    // Spectra do not tell the sides of a round shape apart; distances may. Where the spectra themselves differ, they
    // may not.
    if (!outcome.search.is_of_part && outcome.choice.is_doubtful && outcome.best().is_usable() &&
        outcome.best().score <= options.doubtful_score) {
      Outcome<3> poses = choice_among(findings.by_poses.next([&] { return search_poses(shapes, landmarks, options); }),
                                      options, trials);
      poses.search.fits_far_better_mirrored = outcome.search.fits_far_better_mirrored;
      poses.search.mirrored_gain = outcome.search.mirrored_gain;
      if (!poses.choice.is_doubtful && !pairs_stay(outcome, poses, options, trials)) return poses;
    }
  }
  return outcome;
}

/// Whether the pairs of one component of several, which say nothing of the others, are better left.
template <int Dim>
bool others_lie_nearer(const ShapePair<Dim>& shapes, const StartSearch<Dim>& search, const Similarity<Dim>& pose) {
  constexpr double least_searched = 0.9, clearly_nearer = 0.5;
  const bool has_others[2] = {search.reference_share < least_searched, search.template_share < least_searched};
  if (pose.is_identity() || !(has_others[0] || has_others[1])) return false;
  if (has_others[0] && has_others[1]) return distance_after<Dim>(shapes, {}) < distance_after(shapes, pose);
  // Of what one shape has alone, such as the floor of a scan, nothing is asked.
  const std::array<bool, 2> from{!has_others[0], !has_others[1]};
  return distance_after<Dim>(shapes, {}, from) < clearly_nearer * distance_after(shapes, pose, from);
}

/// Why shapes stay as they lie.
struct Stay {
  std::string why;         ///< in words; empty: they do not
  bool coincides = false;  ///< so that nothing is left open
};

/// A start that is chosen loses its pose, and the pairs that say otherwise, to what lies as it belongs.
template <int Dim>
Stay why_they_stay(const ShapePair<Dim>& shapes, const StartSearch<Dim>& search, Alignment<Dim>& start) {
  const Coincidence<Dim> coincidence(shapes);
  if (coincidence.decides()) {
    start.pose = {};
    coincidence.keep_others(start.pairs);
    if (start.pairs.size() < n_least_pairs) start.pairs.clear();
    return {fmt::format("{:.0f} % of one shape coincides with the other as they lie", 100 * coincidence.share()), true};
  }
  if (others_lie_nearer(shapes, search, start.pose)) {
    start.pose = {};
    start.pairs.clear();
    return {"all components together lie nearer as they are"};
  }
  return {};
}

template <int Dim>
std::vector<CorrespondingPointsIn<Dim>> pairs_of(const std::vector<Landmark<Dim>>& landmarks) {
  std::vector<CorrespondingPointsIn<Dim>> pairs;
  for (const Landmark<Dim>& l : landmarks) pairs.push_back({l.on_reference, l.on_template, l.weight});
  return pairs;
}

/// For where no pairs are used: landmarks tell a pose by themselves. The identity if they are too few, or hardly nearer
/// after one.
template <int Dim>
Similarity<Dim> pose_by_landmarks(const std::vector<Landmark<Dim>>& landmarks, const AlignOptions& options) {
  if (options.mode != AlignMode::automatic || landmarks.size() < n_least_landmarks) return {};
  try {
    return choose_pose<Dim>(pairs_of(landmarks), options, Mirroring::never);
  } catch (const InputError&) {  // on a line
    return {};
  }
}

std::string pose_note(std::size_t n_landmarks) {
  return fmt::format("; the pose is that of {} landmarks", n_landmarks);
}

template <int Dim>
Alignment<Dim> search(const ShapePair<Dim>& shapes, const std::vector<Landmark<Dim>>& landmarks,
                      const AlignOptions& options, Observer& observer, AlignmentFindings<Dim>& findings,
                      Trials<Dim>& trials) {
  Outcome<Dim> outcome = search_and_choose(shapes, landmarks, options, trials, findings);
  for (const std::string& note : outcome.search.notes) observer.note("alignment: " + note);
  const StartChoice& choice = outcome.choice;
  Start<Dim>& best = outcome.best();
  bool fits_mirrored = false;
  if constexpr (Dim == 3)
    if (outcome.search.fits_far_better_mirrored && !options.search.mirror && options.mode == AlignMode::automatic &&
        !outcome.search.is_of_part && is_worth_mirroring(outcome.search, best, choice))
      fits_mirrored = findings.fits_mirrored.next([&] { return outcome.search.fits_far_better_mirrored(best); });
  const bool is_trusted = options.mode != AlignMode::automatic || (choice.is_usable && !choice.as_it_lies);
  bool is_used = best.is_usable() && is_trusted;
  Alignment<Dim> result;
  if (is_used) {
    result = std::move(best.alignment);
    result.pairs.resize(result.pairs.size() - best.n_contradicting);
  }
  Stay stay;
  if (options.mode == AlignMode::automatic && (is_used || choice.as_it_lies))
    stay = why_they_stay(trials.tried_shapes(), outcome.search, result);
  const std::string& stays = stay.why;
  if (!stays.empty()) is_used = !result.pairs.empty();
  if (!is_used && stays.empty()) result.pose = pose_by_landmarks(landmarks, options);
  AlignmentSummary& s = result.summary.emplace(summary_of(result.pose));
  s.score = best.score;
  s.landmark_distance = best.landmark_distance;
  if (is_used) s.landmark_trust = result.landmark_trust;
  if (std::isfinite(choice.margin)) s.margin = choice.margin;
  if (outcome.search.is_of_part) s.is_of_part = true;
  s.n_tried = static_cast<int>(choice.n_tried);
  s.pair_share = best.pair_share;
  s.n_pairs = is_used ? static_cast<int>(stays.empty() ? best.n_pairs : result.pairs.size()) : 0;
  const bool is_posed = !is_used && !result.pose.is_identity();
  const bool is_doubtful = choice.is_doubtful && !stay.coincides;
  s.doubtful = is_doubtful && !is_posed;
  s.as_it_lies = !is_posed && (choice.as_it_lies || !stays.empty());
  s.fits_mirrored = fits_mirrored;
  if (fits_mirrored)
    observer.note(
        "alignment: the mirrored reference fits far better: is one of the shapes of the other side, or its x axis "
        "turned over? "
        "--set align.search.mirror=true mirrors it");
  std::string why;
  if (choice.n_tried > 0)
    why += fmt::format(", chosen among {} by {}", choice.n_tried,
                       Dim == 2 ? "score and energy reached" : "the likeness of what corresponds after a trial");
  if (best.landmark_distance)
    why += fmt::format(", {} landmarks {:.3f} roots of the area from where these take them", outcome.search.n_landmarks,
                       *best.landmark_distance);
  if (is_used && result.landmark_trust.value_or(1) < 0.5)
    why +=
        fmt::format(", and so noisy beside such pairs that {:.0f} % of their weight count (--align landmarks keeps it)",
                    100 * *result.landmark_trust);
  if (!stays.empty()) why += ", but " + stays;
  else if (choice.as_it_lies) why += ", not clearly better than the shapes as they lie";
  // Score and margin tell something where they are bad; the summary always has them.
  if (is_doubtful) why = fmt::format(", score {:.2f}, margin {:.2f}", best.score, choice.margin) + why;
  const std::string use = is_posed        ? "; they are not used" + pose_note(landmarks.size())
                          : !is_used      ? "; they are not used"
                          : stays.empty() ? ""
                                          : fmt::format("; {} of them are used", result.pairs.size());
  observer.note(fmt::format("alignment: {}{} pairs{}{}", is_doubtful ? "doubtful: " : "", best.n_pairs, why, use));
  return result;
}

/// What is near everywhere needs no pairs.
template <int Dim>
Alignment<Dim> predicted(const PredictedPose& found, std::size_t n_images, const AlignOptions& options,
                         Observer& observer) {
  Alignment<Dim> result;
  if constexpr (Dim == 3) result.pose = choose_pose<3>(found.pairs, options, Mirroring::never);
  result.is_near = true;
  AlignmentSummary& s = result.summary.emplace(summary_of(result.pose));
  if (std::isfinite(found.margin)) s.margin = found.margin;
  s.n_images = static_cast<int>(n_images);
  observer.note(fmt::format("alignment: pose predicted from {} earlier results, which come as near as {:.2g} diagonals",
                            n_images, found.residual));
  return result;
}

template <int Dim>
Alignment<Dim> without_search(const std::string& why, const std::vector<Landmark<Dim>>& landmarks,
                              const AlignOptions& options, Observer& observer) {
  Alignment<Dim> result;
  result.pose = pose_by_landmarks(landmarks, options);
  const bool is_posed = !result.pose.is_identity();
  observer.note(
      fmt::format("alignment: not searched, as {}{}", why,
                  is_posed ? pose_note(landmarks.size()) : ". Landmarks can tell a pose (--align landmarks)"));
  result.summary = summary_of(result.pose);
  result.summary->as_it_lies = !is_posed;
  return result;
}

// With align.mode auto: a shape for which no pairs can be searched is matched without.
template <int Dim>
Alignment<Dim> search_if_possible(const ShapePair<Dim>& shapes, const std::vector<Landmark<Dim>>& landmarks,
                                  const ExperimentOptions& options, Observer& observer,
                                  AlignmentFindings<Dim>& findings, Trials<Dim>& trials) {
  try {
    if (const auto found = clear_pose(shapes, findings.images, options.align.search, observer))
      return predicted<Dim>(*found, findings.images.size(), options.align, observer);
    return search(shapes, landmarks, options.align, observer, findings, trials);
  } catch (const InputError& error) {
    return without_search(error.what(), landmarks, options.align, observer);
  }
}

template <int Dim>
Alignment<Dim> by_landmarks(const std::vector<Landmark<Dim>>& landmarks, const AlignOptions& options,
                            Observer& observer) {
  if (landmarks.empty())
    throw_input_error("align.mode: landmarks: there are none; expected a file of them (landmarks.file)");
  if (landmarks.size() < Dim)
    throw_input_error("align.mode: landmarks: a pose needs at least {}, and landmarks.file has {}", Dim,
                      landmarks.size());
  Alignment<Dim> result;
  result.pose =
      choose_pose<Dim>(pairs_of(landmarks), options, options.search.mirror ? Mirroring::allowed : Mirroring::never);
  result.summary = summary_of(result.pose);
  result.summary->n_pairs = static_cast<int>(landmarks.size());
  observer.note(fmt::format("alignment by {} landmarks", landmarks.size()));
  return result;
}

}  // namespace

AlignMode align_mode(const ExperimentOptions& options) {
  const AlignMode mode = options.align.mode;
  return mode == AlignMode::automatic && options.input.placement == PlacementKind::as_is ? AlignMode::none : mode;
}

template <int Dim>
Alignment<Dim> align_shapes(const ShapePair<Dim>& shapes, const std::vector<Landmark<Dim>>& landmarks,
                            const ExperimentOptions& options, Observer& observer, AlignmentFindings<Dim>& findings,
                            Trials<Dim>& trials) {
  const AlignMode mode = align_mode(options);
  if (mode == AlignMode::none) return {};
  observer.stage("alignment");
  Alignment<Dim> result =
      mode == AlignMode::automatic   ? search_if_possible(shapes, landmarks, options, observer, findings, trials)
      : mode == AlignMode::landmarks ? by_landmarks(landmarks, options.align, observer)
                                     : search(shapes, landmarks, options.align, observer, findings, trials);
  result.summary->mode = enum_name(mode);
  return result;
}

template Alignment<2> align_shapes<2>(const ShapePair<2>&, const std::vector<Landmark<2>>&, const ExperimentOptions&,
                                      Observer&, AlignmentFindings<2>&, Trials<2>&);
template Alignment<3> align_shapes<3>(const ShapePair<3>&, const std::vector<Landmark<3>>&, const ExperimentOptions&,
                                      Observer&, AlignmentFindings<3>&, Trials<3>&);

}  // namespace shellmatch
