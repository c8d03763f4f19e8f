#pragma once
/// \file
/// The two shapes of an experiment, as read, and their common placement in the unit domain.

#include "geometry/surface/placement.h"
#include "geometry/io/read_shape.h"
#include "matching/experiment/options.h"
#include "matching/progress/observer.h"

#include <variant>

namespace shellmatch {

template <int Dim>
struct ShapePair {
  Shape<Dim> reference, template_shape;

  /// Moves both surfaces into the unit domain, as `options.input` asks for. Returns the similarity that did it.
  /// \throws InputError for shapes that are to stay where they are and reach beyond the domain
  Similarity<Dim> place(const ExperimentOptions& options);
};

using AnyShapePair = std::variant<ShapePair<2>, ShapePair<3>>;

/// Reads both and tells the observer what was mended. \throws InputError, also for shapes of two dimensions
AnyShapePair open_shape_pair(const InputOptions& input, Observer& observer);

}  // namespace shellmatch
