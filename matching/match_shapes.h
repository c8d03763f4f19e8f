#pragma once
/// \file
/// Matching as a function: two shapes and options in, a result out. No file is read or written.

#include "geometry/surface/surface.h"
#include "matching/experiment/options.h"
#include "matching/progress/observer.h"
#include "matching/result/match_result.h"

namespace shellmatch {

/// Finds the map that carries the reference onto the template: places both in the unit domain by one similarity, runs
/// the cascade and measures what came of it. `make_shape` (geometry/repair/make_shape.h) makes a shape of vertices and
/// polygons, `open_shape` (matching/experiment/shape_source.h) of a file.
/// \param options  `profile_defaults(Profile::standard)` with what is to differ. Of `input` only placement and margin
///   count; `pictures` and `resume` are for those who write files. `threads` is set for the whole process.
/// \param observer is told how it goes on and may stop it; a plain `Observer` is silent.
/// \throws InputError for options that do not fit together or shapes that cannot be placed, EnvironmentError where the
///   memory of the machine is too small, and whatever the observer throws
template <int Dim>
MatchResult<Dim> match_shapes(const Shape<Dim>& reference, const Shape<Dim>& template_shape,
                              const ExperimentOptions& options, Observer& observer);

}  // namespace shellmatch
