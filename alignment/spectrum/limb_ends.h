#pragma once
/// \file
/// Whether a map of space takes the ends of limbs of one surface to those of another one.

#include "alignment/options.h"
#include "alignment/spectrum/surface_tips.h"

#include <vector>

namespace shellmatch {

/// The largest component of a surface, and its tips.
struct LimbEnds {
  std::vector<Vec<3>> vertices;  ///< in the coordinates of the input
  std::vector<SurfaceTip> tips;  ///< lengths in roots of the area
  double share = 1;              ///< of the component, of the input's area
};

/// \throws InputError if no facet has an area
LimbEnds limb_ends(const Surface<3>& surface, const AlignmentOptions& options);

/// tip_disorder() of the map that takes each vertex of the reference to one of `images`, where the vertices of the
/// template are `places`; what is nearest corresponds.
double limb_disorder(const LimbEnds& reference, const std::vector<Vec<3>>& images, const LimbEnds& template_shape,
                     const std::vector<Vec<3>>& places);

}  // namespace shellmatch
