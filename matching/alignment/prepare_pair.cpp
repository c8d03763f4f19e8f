#include "matching/alignment/prepare_pair.h"

#include "matching/alignment/narrow_gaps.h"
#include "matching/alignment/trial.h"

#include <fmt/format.h>

#include <cmath>
#include <optional>
#include <string>
#include <utility>

namespace shellmatch {

namespace {

// What ends alike stays forward.
constexpr double clearly_better = 0.985;

/// Keeps what is said of an alignment until it is known to be used.
class DeferredNotes final : public Observer {
 public:
  explicit DeferredNotes(Observer& of_run) : of_run_(of_run) {}
  void note(const std::string& text) override { notes_.push_back(text); }
  void trial_iterated() override { of_run_.trial_iterated(); }
  void tell() const {
    for (const std::string& text : notes_) of_run_.note(text);
  }

 private:
  Observer& of_run_;
  std::vector<std::string> notes_;
};

/// The deformed shape first.
template <int Dim>
void exchange(ShapePair<Dim>& shapes) {
  std::swap(shapes.reference, shapes.template_shape);
}

/// One of both directions, with all that the choice asks of it.
template <int Dim>
struct DirectedAlignment {
  Alignment<Dim> alignment;
  DirectionTrial trial;
};

/// Less is better. Distances between whole surfaces hardly tell whether a paw is reached, which drives up the energy;
/// the energy alone takes a shape that does not bend for one that need not (docs/alignment.md). Its root goes with
/// lengths, as those of the match term do.
template <int Dim>
bool is_better(const DirectedAlignment<Dim>& one, const DirectedAlignment<Dim>& other) {
  const bool same_band = one.alignment.pairs.empty() == other.alignment.pairs.empty();
  const auto cost = [&](const DirectionTrial& t) { return same_band ? t.distance * std::sqrt(t.energy) : t.distance; };
  return cost(one.trial) < clearly_better * cost(other.trial);
}

/// \param shapes the deformed one first
template <int Dim>
DirectedAlignment<Dim> tried(const ShapePair<Dim>& shapes, const std::vector<Landmark<Dim>>& landmarks,
                             const ExperimentOptions& options, bool backward, Observer& observer) {
  DirectedAlignment<Dim> result;
  result.alignment = align_shapes(shapes, landmarks, options, observer, backward ? "template" : "reference");
  const Trials<Dim> trials(shapes, landmarks, options, observer);
  result.trial = trials.of_direction(result.alignment, backward ? Carried::template_shape : Carried::reference);
  return result;
}

std::string reached(const DirectionTrial& trial) {
  return std::isfinite(trial.distance)
             ? fmt::format("{:.2g} diagonals with energy {:.2g}", trial.distance, trial.energy)
             : "unknown, as it cannot be tried";
}

/// Both directions are tried on coarse levels; backward is chosen where it ends clearly better.
template <int Dim>
Alignment<Dim> choose_direction(ShapePair<Dim>& shapes, const std::vector<Landmark<Dim>>& landmarks,
                                const ExperimentOptions& options, DirectionSummary& direction, Observer& observer) {
  DeferredNotes of_forward(observer), of_backward(observer);
  if (align_mode(options) != AlignMode::none) observer.stage("alignment");
  DirectedAlignment<Dim> forward = tried(shapes, landmarks, options, false, of_forward);
  exchange(shapes);
  DirectedAlignment<Dim> backward = tried(shapes, exchanged(landmarks), options, true, of_backward);
  exchange(shapes);
  direction.backward = is_better(backward, forward);
  const auto keep = [](const DirectionTrial& trial, std::optional<double>& distance, std::optional<double>& energy) {
    if (!std::isfinite(trial.distance)) return;
    distance = trial.distance;
    energy = trial.energy;
  };
  keep(forward.trial, direction.forward_distance, direction.forward_energy);
  keep(backward.trial, direction.backward_distance, direction.backward_energy);
  (direction.backward ? of_backward : of_forward).tell();
  DirectedAlignment<Dim>&chosen = direction.backward ? backward : forward,
  &other = direction.backward ? forward : backward;
  observer.note(fmt::format("direction: {}; distance after coarse levels {}, in the other direction {}",
                            direction.backward
                                ? "the template is deformed, and the inverse of that map carries the reference"
                                : "the reference is deformed",
                            reached(chosen.trial), reached(other.trial)));
  return std::move(chosen.alignment);
}

/// How near limbs lie to each other, which a user who has chosen no direction is told.
template <int Dim>
void compare_gaps(const ShapePair<Dim>& shapes, MatchDirection wanted, DirectionSummary& direction,
                  Observer& observer) {
  const double of_reference = narrow_gap_share(shapes.reference.surface),
               of_template = narrow_gap_share(shapes.template_shape.surface);
  direction.reference_gaps = of_reference;
  direction.template_gaps = of_template;
  if (wanted == MatchDirection::forward && has_clearly_more_gaps(of_reference, of_template))
    observer.note(fmt::format(
        "limbs of the reference lie closer to each other ({:.0f} % of it) than those of the template ({:.0f} %): the "
        "inverse of the map from template to reference may be more exact (--set align.direction=auto)",
        100 * of_reference, 100 * of_template));
}

}  // namespace

template <int Dim>
std::vector<Landmark<Dim>> exchanged(std::vector<Landmark<Dim>> landmarks) {
  for (Landmark<Dim>& l : landmarks) {
    std::swap(l.on_reference, l.on_template);
    std::swap(l.reference_origin, l.template_origin);
    std::swap(l.reference_name, l.template_name);
  }
  return landmarks;
}

template <int Dim>
PreparedPair<Dim> prepare_pair(ShapePair<Dim>& shapes, const std::vector<Landmark<Dim>>& landmarks,
                               const ExperimentOptions& options, Observer& observer) {
  PreparedPair<Dim> result;
  result.space = shapes.template_shape.original.space;
  if (!landmarks.empty())
    check_landmarks(landmarks, options.landmarks, shapes.reference.surface, shapes.template_shape.surface);
  const MatchDirection wanted = options.align.direction;
  if (wanted != MatchDirection::forward || align_mode(options) != AlignMode::none) {
    result.direction.emplace().backward = wanted == MatchDirection::backward;
    if (align_mode(options) != AlignMode::none) compare_gaps(shapes, wanted, *result.direction, observer);
  }
  if (wanted == MatchDirection::automatic)
    result.alignment = choose_direction(shapes, landmarks, options, *result.direction, observer);
  if (result.is_backward()) exchange(shapes);
  if (wanted != MatchDirection::automatic)
    result.alignment = align_shapes(shapes, result.is_backward() ? exchanged(landmarks) : landmarks, options, observer,
                                    result.is_backward() ? "template" : "reference");
  result.placement = shapes.place(options, result.alignment.pose);
  if (result.is_backward()) exchange(shapes);
  return result;
}

#define SHELLMATCH_INSTANTIATE(Dim)                                                                \
  template std::vector<Landmark<Dim>> exchanged<Dim>(std::vector<Landmark<Dim>>);                  \
  template PreparedPair<Dim> prepare_pair<Dim>(ShapePair<Dim>&, const std::vector<Landmark<Dim>>&, \
                                               const ExperimentOptions&, Observer&)
SHELLMATCH_INSTANTIATE(2);
SHELLMATCH_INSTANTIATE(3);
#undef SHELLMATCH_INSTANTIATE

}  // namespace shellmatch
