#pragma once
/// \file
/// Matching as a function: two shapes and options in, a result out. No file is read or written.

#include "geometry/surface/surface.h"
#include "matching/experiment/options.h"
#include "matching/input/shape_pair.h"
#include "matching/pairs/landmarks.h"
#include "matching/progress/observer.h"
#include "matching/result/correspondence.h"
#include "matching/result/match_result.h"

#include <vector>

namespace shellmatch {

/// Finds the map that carries the reference onto the template: places both in the unit domain by one similarity, runs
/// the cascade and measures the result. `make_shape` (geometry/repair/make_shape.h) makes a shape from vertices and
/// polygons, `open_shape` (matching/input/shape_source.h) from a file.
/// \param options `profile_defaults(Profile::standard)` with the changes wanted. Of `input`, only placement,
///   margin, buried and unit are used; `start.map` and `start.images` must be empty; of `landmarks`, all but the files
///   are used; `report` keeps `levels`; `pictures` and `resume` are ignored. `threads` is set for the whole process.
/// \param observer receives the progress and can stop the matching; a plain `Observer` does nothing
/// \param landmarks points that correspond, in the coordinates of the shapes
/// \throws InputError for contradictory options, shapes that cannot be placed or landmarks far from them,
/// EnvironmentError if the machine has too little memory, and whatever the observer throws
template <int Dim>
MatchResult<Dim> match_shapes(const Shape<Dim>& reference, const Shape<Dim>& template_shape,
                              const ExperimentOptions& options, Observer& observer,
                              const std::vector<Landmark<Dim>>& landmarks = {});

/// The same of a pair that open_shape_pair() has opened. \param truth true positions of vertices, by which the summary
/// states the error
template <int Dim>
MatchResult<Dim> match_shapes(ShapePair<Dim> shapes, const ExperimentOptions& options, Observer& observer,
                              const std::vector<Landmark<Dim>>& landmarks, const Correspondence<Dim>& truth = {});

}  // namespace shellmatch
