#pragma once
/// \file
/// A surface bent toward another one by pairs of points.

#include "alignment/pairs/corresponding_points.h"
#include "geometry/surface/surface.h"

#include <span>
#include <vector>

namespace shellmatch {

/// Positions of the vertices after a bend that takes the pairs' points on the reference to those on the template, as
/// rigid as possible (Sorkine, Alexa, 'As-rigid-as-possible surface modeling', SGP 2007) on the edges of a deformation
/// graph. Pairs that others contradict lose their pull. The same bits for every number of threads.
/// \param surface with vertices and an area, in the pose of the template, as the points on the reference are
std::vector<Vec<3>> bend_by_pairs(const Surface<3>& surface, std::span<const CorrespondingPoints> pairs);

}  // namespace shellmatch
