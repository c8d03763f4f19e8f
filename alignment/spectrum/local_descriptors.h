#pragma once
/// \file
/// What a surface looks like around a vertex, in any position and nearly in any pose. Unlike the spectrum it is extrinsic, so that it
/// tells front from back and arms from legs, and unlike positions it does not depend on where limbs point.

#include "alignment/spectrum/laplacian.h"

namespace shellmatch {

/// n vertices; the unit of length is the root of the area.
struct LocalDescriptors {
  Eigen::VectorXd curvature;  ///< n: mean curvature, smoothed, up to a factor that surfaces share; clipped at the 98 % quantile of its size
  Eigen::MatrixXf spin;       ///< 96 x n: columns of unit length
};

/// Curvature is what a step of implicit heat flow removes along the normal (Desbrun, Meyer, Schroeder and Barr, SIGGRAPH 1999). Spin images
/// are histograms of the surface near a vertex over radius, height along the normal and angle of the normals (Johnson and Hebert, IEEE
/// PAMI 21, 1999), weighted by area; their entries are roots, so that differences are Hellinger's.
/// \param surface, laplacian of area 1
LocalDescriptors local_descriptors(const Surface<3>& surface, const SurfaceLaplacian& laplacian);

}  // namespace shellmatch
