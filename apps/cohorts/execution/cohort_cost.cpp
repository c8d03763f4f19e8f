#include "apps/cohorts/execution/cohort_cost.h"

#include "apps/cohorts/subjects/mirrored.h"
#include "matching/cascade/size_estimate.h"
#include "matching/input/shape_source.h"

#include <algorithm>

namespace shellmatch {

namespace {

// A minimisation takes up to some hundred steps of some microseconds for each node; a core of 2020 needs
// about a tenth of it.
constexpr double seconds_per_node = 2e-3, least_seconds = 120, reserve = 2;

template <int Dim>
SizeEstimate size_of(Surface<Dim> surface, const ExperimentOptions& options) {
  const Box<Dim> box = bounding_box(surface.vertices);
  const double side = (box.max - box.min).maxCoeff(), scale = (1 - 2 * options.input.margin) / side;
  for (Vec<Dim>& x : surface.vertices) x = (x - box.min) * scale + Vec<Dim>::Constant(options.input.margin);
  return estimate_size<Dim>(refined_measures(surface, surface, options), options.cascade.min_level,
                            options.cascade.max_level);
}

}  // namespace

CohortCost estimate_cost(const Cohort& cohort) {
  CohortCost cost{std::max(1, cohort.experiment.threads), cohort.options.limits.seconds,
                  cohort.options.limits.memory_mb};
  if (cost.seconds > 0 && cost.memory_mb > 0) return cost;
  const std::string& atlas = cohort.options.atlas.shape;
  const auto subject = std::ranges::find(cohort.subjects, atlas, &Subject::id);
  const InputOptions& input = cohort.experiment.input;
  const AnyShape shape =
      open_shape(subject == cohort.subjects.end() ? atlas : subject->source, input.close, volume_space(input));
  const SizeEstimate size = std::visit([&](const auto& s) { return size_of(s.surface, cohort.experiment); }, shape);
  if (cost.seconds == 0) cost.seconds = least_seconds + reserve * seconds_per_node * size.n_nodes / cost.threads;
  if (cost.memory_mb == 0) cost.memory_mb = reserve * size.memory_bytes / 1e6;
  return cost;
}

}  // namespace shellmatch
