#include "matching/match_shapes.h"

#include "base/error.h"
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
  ShapePair<Dim> shapes{reference, template_shape};
  share_space(shapes, observer);
  leave_out_buried(shapes, options.input, observer);
  return match_shapes(std::move(shapes), options, observer, landmarks);
}

template <int Dim>
MatchResult<Dim> match_shapes(ShapePair<Dim> shapes, const ExperimentOptions& options, Observer& observer,
                              const std::vector<Landmark<Dim>>& landmarks, const Correspondence<Dim>& truth) {
  check_experiment(options);
  if (!options.start.map.empty() || !options.start.images.empty())
    throw_input_error("start.{}: is for the program's files, and this matching has none; leave it out",
                      options.start.map.empty() ? "images" : "map");
  set_n_threads(options.threads);
  RunClock clock;
  Recorder recorder(observer);
  MatchInputs<Dim> inputs;
  inputs.shapes = std::move(shapes);
  inputs.landmarks = landmarks;
  inputs.truth = truth;
  inputs.prepared = prepare_pair(inputs.shapes, landmarks, options, observer);
  check_size<Dim>(refined_measures(inputs.shapes.reference.surface, inputs.shapes.template_shape.surface, options),
                  options.cascade.min_level, options.cascade.max_level, "");
  return match_placed_shapes(std::move(inputs), options, recorder, clock);
}

#define SHELLMATCH_INSTANTIATE(Dim)                                                                           \
  template MatchResult<Dim> match_shapes<Dim>(const Shape<Dim>&, const Shape<Dim>&, const ExperimentOptions&, \
                                              Observer&, const std::vector<Landmark<Dim>>&);                  \
  template MatchResult<Dim> match_shapes<Dim>(ShapePair<Dim>, const ExperimentOptions&, Observer&,            \
                                              const std::vector<Landmark<Dim>>&, const Correspondence<Dim>&)
SHELLMATCH_INSTANTIATE(2);
SHELLMATCH_INSTANTIATE(3);
#undef SHELLMATCH_INSTANTIATE

}  // namespace shellmatch
