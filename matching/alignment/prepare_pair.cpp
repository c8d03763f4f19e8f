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
  if (wanted == MatchDirection::automatic || align_mode(options) != AlignMode::none) {
    d.reference_gaps = narrow_gap_share(shapes.reference.surface);
    d.template_gaps = narrow_gap_share(shapes.template_shape.surface);
  } else if (!d.backward) {
    return std::nullopt;
  }
  const std::string gaps = fmt::format("limbs of the reference lie closer to each other ({:.0f} % of it) than those of the template ({:.0f} %)",
                                       100 * d.reference_gaps, 100 * d.template_gaps);
  if (!has_clearly_more_gaps(d.reference_gaps, d.template_gaps)) return d;
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
  }
  return landmarks;
}

template <int Dim>
PreparedPair<Dim> prepare_pair(ShapePair<Dim>& shapes, const std::vector<Landmark<Dim>>& landmarks, const ExperimentOptions& options,
                               Observer& observer) {
  PreparedPair<Dim> result;
  result.space = shapes.space;
  result.direction = chosen_direction(shapes, options, observer);
  if (result.is_backward()) std::swap(shapes.reference, shapes.template_shape);
  result.alignment = align_shapes(shapes, result.is_backward() ? exchanged(landmarks) : landmarks, options, observer);
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
