#pragma once
/// \file
/// The two shapes of an experiment as they are read, and their common placement in the unit domain.

#include "geometry/surface/placement.h"
#include "geometry/io/read_shape.h"
#include "geometry/volume/volume.h"
#include "matching/experiment/options.h"
#include "matching/progress/observer.h"

#include <variant>

namespace shellmatch {

template <int Dim>
struct ShapePair {
  Shape<Dim> reference, template_shape;
  Space space = Space::ras;  ///< the frame of volumes beside them

  /// Moves the reference's surface by `pose` and then both into the unit domain according to `options.input`. Returns the
  /// similarity that does the latter.
  /// \throws InputError for placement as-is of shapes that reach beyond the domain
  Similarity<Dim> place(const ExperimentOptions& options, const Similarity<Dim>& pose = {});
};

using AnyShapePair = std::variant<ShapePair<2>, ShapePair<3>>;

/// Reads both shapes and reports their repairs to the observer. \throws InputError, also for shapes of different
/// dimensions
AnyShapePair open_shape_pair(const InputOptions& input, Observer& observer);

}  // namespace shellmatch
