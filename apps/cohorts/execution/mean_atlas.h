#pragma once
/// \file
/// The mean of an atlas' images, which is the atlas of the next round.

#include "apps/cohorts/execution/atlas.h"
#include "geometry/statistics/procrustes.h"

#include <cstddef>
#include <vector>

namespace shellmatch {

template <int Dim>
struct MeanAtlas {
  OriginalShape<Dim> shape;                ///< the atlas with its vertices at their means
  std::vector<NamedPoint<Dim>> landmarks;  ///< likewise
  /// Root mean square distance of the mean's points from the atlas' surface, over the atlas' diagonal. Points
  /// may slide along the surface, which does not change the shape.
  double change = 0;
  double spread = 0;        ///< of the images about the mean, root mean square over the surface and the atlas' diagonal
  std::size_t nearest = 0;  ///< the column of the image that is nearest to the mean
};

/// \param images of Atlas::points, one column for each subject, at least one
template <int Dim>
MeanAtlas<Dim> mean_atlas(const Atlas<Dim>& atlas, const PointSets& images, ProcrustesKind kind);

}  // namespace shellmatch
