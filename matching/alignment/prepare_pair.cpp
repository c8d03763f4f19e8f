#include "matching/alignment/prepare_pair.h"

#include "matching/alignment/narrow_gaps.h"

#include <fmt/format.h>

#include <utility>

namespace shellmatch {

namespace {

template <int Dim>
std::optional<DirectionSummary> chosen_direction(const ShapePair<Dim>& shapes, const ExperimentOptions& options, Observer& observer) {
  const MatchDirection wanted = options.align.direction;
  DirectionSummary d;
  d.backward = wanted == MatchDirection::backward;
  if (wanted != MatchDirection::automatic && align_mode(options) == AlignMode::none) return d.backward ? std::optional(d) : std::nullopt;
  const double of_reference = narrow_gap_share(shapes.reference.surface), of_template = narrow_gap_share(shapes.template_shape.surface);
  d.reference_gaps = of_reference;
  d.template_gaps = of_template;
  const std::string gaps = fmt::format("limbs of the reference lie closer to each other ({:.0f} % of it) than those of the template ({:.0f} %)",
                                       100 * of_reference, 100 * of_template);
  if (!has_clearly_more_gaps(of_reference, of_template)) return d;
  if (wanted == MatchDirection::automatic) {
    d.backward = true;
    observer.note(gaps + ": the template is deformed, and the inverse of that map carries the reference");
  } else if (wanted == MatchDirection::forward) {
    observer.note(gaps + ": the inverse of the map from template to reference may be more exact (--set align.direction=auto)");
  }
  return d;
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
PreparedPair<Dim> prepare_pair(ShapePair<Dim>& shapes, const std::vector<Landmark<Dim>>& landmarks, const ExperimentOptions& options,
                               Observer& observer) {
  PreparedPair<Dim> result;
  result.space = shapes.template_shape.original.space;
  result.direction = chosen_direction(shapes, options, observer);
  if (!landmarks.empty()) check_landmarks(landmarks, options.landmarks, shapes.reference.surface, shapes.template_shape.surface);
  if (result.is_backward()) std::swap(shapes.reference, shapes.template_shape);
  result.alignment = align_shapes(shapes, result.is_backward() ? exchanged(landmarks) : landmarks, options, observer,
                                  result.is_backward() ? "template" : "reference");
  result.placement = shapes.place(options, result.alignment.pose);
  if (result.is_backward()) std::swap(shapes.reference, shapes.template_shape);
  return result;
}

#define SHELLMATCH_INSTANTIATE(Dim)                                                                                              \
  template std::vector<Landmark<Dim>> exchanged<Dim>(std::vector<Landmark<Dim>>);                                               \
  template PreparedPair<Dim> prepare_pair<Dim>(ShapePair<Dim>&, const std::vector<Landmark<Dim>>&, const ExperimentOptions&, Observer&)
SHELLMATCH_INSTANTIATE(2);
SHELLMATCH_INSTANTIATE(3);
#undef SHELLMATCH_INSTANTIATE

}  // namespace shellmatch
