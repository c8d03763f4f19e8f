#include "matching/match_shapes.h"

#include "base/parallel.h"
#include "matching/cascade/size_estimate.h"
#include "matching/experiment/yaml_options.h"
#include "matching/match_placed_shapes.h"

#include <utility>

namespace shellmatch {

template <int Dim>
MatchResult<Dim> match_shapes(const Shape<Dim>& reference, const Shape<Dim>& template_shape,
                              const ExperimentOptions& options, Observer& observer,
                              const std::vector<Landmark<Dim>>& landmarks) {
  check_experiment(options);
  set_n_threads(options.threads);
  RunClock clock;
  Recorder recorder(observer);
  MatchInputs<Dim> inputs;
  inputs.shapes = {reference, template_shape};
  share_space(inputs.shapes, observer);
  inputs.landmarks = landmarks;
  inputs.prepared = prepare_pair(inputs.shapes, landmarks, options, observer);
  check_size<Dim>(refined_measures(inputs.shapes.reference.surface, inputs.shapes.template_shape.surface, options),
                  options.cascade.min_level, options.cascade.max_level, "");
  return match_placed_shapes(std::move(inputs), options, recorder, clock);
}

template MatchResult<2> match_shapes<2>(const Shape<2>&, const Shape<2>&, const ExperimentOptions&, Observer&,
                                         const std::vector<Landmark<2>>&);
template MatchResult<3> match_shapes<3>(const Shape<3>&, const Shape<3>&, const ExperimentOptions&, Observer&,
                                         const std::vector<Landmark<3>>&);

}  // namespace shellmatch
