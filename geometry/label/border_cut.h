#pragma once
/// \file
/// Where the border of an image cuts a label: the surface is closed there, which says nothing of the body.

#include "geometry/label/label_region.h"
#include "geometry/surface/surface.h"

#include <vector>

namespace shellmatch {

/// The facets, ascending, that lie within one voxel (of a label in blocks: one block) of the border of the volume
/// beside chosen voxels at it. Smoothing rounds the edge of the cut, which reaches no deeper. \param surface of the
/// label, in RAS \param volume canonical(), of which `region` was made
std::vector<Index> facets_at_border(const Surface<3>& surface, const Volume& volume, const VoxelChoice& choice,
                                    const LabelRegion& region);

}  // namespace shellmatch
