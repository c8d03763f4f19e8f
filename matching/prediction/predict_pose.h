#pragma once
/// \file
/// How a surface lies on another one, predicted from where earlier matchings have carried its points.

#include "alignment/options.h"
#include "alignment/pairs/corresponding_points.h"
#include "geometry/surface/surface.h"

#include <vector>

namespace shellmatch {

struct PredictedPose {
  std::vector<CorrespondingPoints> pairs;  ///< vertices of the reference and points of the template, for a pose
  double residual = 0;                     ///< root mean square distance both ways, in diagonals of the template
  double farthest = 0;                     ///< the greatest of these distances
  double margin = 0;  ///< by which factor the residual of another pose is greater, at least; infinite without another
};

/// The mean of the images is laid onto the template by distance (alignment/rigid/find_rigid_pairs.h), in the best
/// poses, that of the surfaces as they lie among them. From each the mean and the differences of the images from it are
/// combined so that they come nearest: distances to tangent planes, and with a small weight to the points themselves.
/// The combination is as likely as the images have it (T. F. Cootes, C. J. Taylor: Statistical models of appearance for
/// medical image analysis and computer vision. Proc. SPIE 4322, 2001). The pose that ends nearest is taken.
/// \param images at least one; where the vertices of the reference, as many, lie on other shapes; a coordinate that is
/// not finite: on none
/// \returns no pairs where the images know nothing of the surface \throws InputError for surfaces without area
PredictedPose predict_pose(const Surface<3>& reference, const std::vector<std::vector<Vec<3>>>& images,
                           const Surface<3>& template_surface, const AlignmentOptions& options);

}  // namespace shellmatch
