#include "matching/alignment/prepare_pair.h"

#include "base/stop.h"
#include "matching/alignment/choose_pose.h"
#include "matching/alignment/trial.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <utility>

namespace shellmatch {

namespace {

// What ends alike stays forward.
constexpr double clearly_cheaper = 0.985;

/// The deformed shape first.
template <int Dim>
void exchange(ShapePair<Dim>& shapes) {
  std::swap(shapes.reference, shapes.template_shape);
}

/// Less is better. Distances between whole surfaces hardly tell whether a paw is reached, which drives up the energy;
/// the energy alone takes a shape that does not bend for one that need not (docs/alignment.md). Its root goes with
/// lengths, as those of the match term do.
double cost(const DirectionTrial& trial) { return trial.distance * std::sqrt(trial.energy); }

std::string reached(const DirectionTrial& trial) {
  return std::isfinite(trial.distance)
             ? fmt::format("{:.2g} diagonals with energy {:.2g}", trial.distance, trial.energy)
             : "unknown, as it cannot be tried";
}

struct DirectionTrials {
  DirectionTrial chosen, other;
};

/// Tries both directions on coarse levels; backward is chosen where it ends clearly better.
template <int Dim>
DirectionTrials choose_direction(const Trials<Dim>& trials, const Alignment<Dim>& alignment,
                                 DirectionSummary& direction) {
  Activity trying(trials_activity, 2);
  trying.next();
  const DirectionTrial forward = trials.of_direction(alignment, Carried::reference);
  trying.next();
  const DirectionTrial backward =
      trials.of_exchanged_shapes().of_direction(inverse(alignment), Carried::template_shape);
  direction.backward = cost(backward) < clearly_cheaper * cost(forward);
  const auto keep = [](const DirectionTrial& trial, std::optional<double>& distance, std::optional<double>& energy) {
    if (!std::isfinite(trial.distance)) return;
    distance = trial.distance;
    energy = trial.energy;
  };
  keep(forward, direction.forward_distance, direction.forward_energy);
  keep(backward, direction.backward_distance, direction.backward_energy);
  return direction.backward ? DirectionTrials{backward, forward} : DirectionTrials{forward, backward};
}

std::string direction_text(const DirectionSummary& direction, const DirectionTrials& trials) {
  return fmt::format("direction: {}; distance after coarse levels {}, in the other direction {}",
                     direction.backward ? "the template is deformed, and the inverse of that map carries the reference"
                                        : "the reference is deformed",
                     reached(trials.chosen), reached(trials.other));
}

// Where maps of space keep up, few pairs are missed, and those are wrong ones.
constexpr double many_missed = 0.005;
// Ends of limbs that touch something have no pairs. Where they arrive, the disorder was 0.08 at most; else 0.26 and
// more.
constexpr double limbs_astray = 0.1;

/// Bends the reference where no map of space reaches the pairs, or the ends of limbs, and one from the bent surface
/// does. Returns whether.
bool bend_if_needed(const Trials<3>& trials, const ShapePair<3>& shapes, const std::vector<Landmark<3>>& landmarks,
                    const ExperimentOptions& options, const DirectionTrial& reached, PreparedPair<3>& pair,
                    Observer& observer) {
  if (options.align.bend == BendMode::never || pair.alignment.pairs.empty()) return false;
  const bool misses_pairs = reached.missed > many_missed;
  if (!misses_pairs && reached.limb_disorder <= limbs_astray) return false;
  Alignment<3> bent = bent_start(pair.alignment, shapes.reference.surface, landmarks);
  const DirectionTrial trial = trials.of_direction(bent, Carried::reference);
  const bool is_better =
      misses_pairs ? trial.missed < reached.missed : trial.missed <= many_missed && trial.limb_disorder <= limbs_astray;
  if (!is_better) return false;
  const std::string what = misses_pairs ? fmt::format("miss {:.2g} % of the pairs", 100 * reached.missed)
                                        : "do not bring ends of limbs to ends of limbs";
  observer.note(
      fmt::format("bend: as maps of space {}, the reference's surface is bent by the pairs first and then "
                  "deformed: the map is one of the surface (--set align.bend=never keeps it one of space)",
                  what));
  pair.alignment = std::move(bent);
  pair.direction->backward = false;
  return true;
}

/// Whether directions may end differently and one of them rightly: something leads points to where they belong, or a
/// shape has gaps. Where the deformed shape goes on behind a gap of the other, it slides from the gap's edge, near
/// which curvatures are those of what was made up.
template <int Dim>
bool may_differ(const ShapePair<Dim>& shapes, const Alignment<Dim>& alignment,
                const std::vector<Landmark<Dim>>& landmarks) {
  const bool has_gap = std::max(shapes.reference.invented_share, shapes.template_shape.invented_share) > 0;
  return has_gap || !alignment.pairs.empty() || !landmarks.empty();
}

}  // namespace

template <int Dim>
PreparedPair<Dim> prepare_pair(ShapePair<Dim>& shapes, const std::vector<Landmark<Dim>>& landmarks,
                               const ExperimentOptions& options, Observer& observer, AlignmentFindings<Dim>& findings) {
  PreparedPair<Dim> result;
  result.space = shapes.template_shape.original.space;
  if (!landmarks.empty())
    check_landmarks(landmarks, options.landmarks, shapes.reference.surface, shapes.template_shape.surface);
  const bool is_aligned = align_mode(options) != AlignMode::none;
  Trials<Dim> trials(shapes, landmarks, options, observer, &findings.trials);
  result.alignment = align_shapes(shapes, landmarks, options, observer, findings, trials);
  const MatchDirection wanted = options.align.direction;
  if (is_aligned || wanted == MatchDirection::backward)
    result.direction.emplace().backward = wanted == MatchDirection::backward;
  if (wanted == MatchDirection::automatic && is_aligned && may_differ(shapes, result.alignment, landmarks)) {
    const DirectionTrials tried = choose_direction(trials, result.alignment, *result.direction);
    bool is_bent = false;
    if constexpr (Dim == 3)
      is_bent = bend_if_needed(trials, shapes, landmarks, options, tried.chosen, result, observer);
    if (!is_bent) observer.note(direction_text(*result.direction, tried));
  }
  if (result.is_backward()) {
    result.alignment = inverse(std::move(result.alignment));
    exchange(shapes);
  }
  if (is_aligned)
    observer.note("pose: " + pose_text(result.alignment.pose, result.is_backward() ? "template" : "reference"));
  const SurfaceBend<Dim>* const bend = result.alignment.bend.get();
  if (bend != nullptr) result.unbent = shapes.reference.surface;
  result.placement = shapes.place(options, result.alignment.pose, bend);
  if (bend != nullptr) result.unbent = transformed(std::move(result.unbent), result.alignment.pose, result.placement);
  if (result.is_backward()) exchange(shapes);
  return result;
}

template PreparedPair<2> prepare_pair<2>(ShapePair<2>&, const std::vector<Landmark<2>>&, const ExperimentOptions&,
                                         Observer&, AlignmentFindings<2>&);
template PreparedPair<3> prepare_pair<3>(ShapePair<3>&, const std::vector<Landmark<3>>&, const ExperimentOptions&,
                                         Observer&, AlignmentFindings<3>&);

}  // namespace shellmatch
