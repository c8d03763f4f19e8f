#pragma once
/// \file
/// What a surface looks like around a vertex, in any position and nearly in any pose. Unlike the spectrum it is extrinsic, so that it
/// tells front from back and arms from legs, and unlike positions it does not depend on where limbs point.

#include "alignment/spectrum/laplacian.h"

namespace shellmatch {

/// Spin images of all vertices, columns of unit length (96 x n): histograms of the surface within a radius over distance, height along the
/// smoothed normal and angle of the smoothed normals, weighted by area (Johnson and Hebert, IEEE PAMI 21, 1999). Entries are roots, so that
/// differences are Hellinger's.
/// \param surface, laplacian of area 1, whose root is the unit of length
/// \param radius above 0; the larger, the more a whole limb is seen, and the farther from a border something is missing
Eigen::MatrixXf spin_images(const Surface<3>& surface, const SurfaceLaplacian& laplacian, double radius);

}  // namespace shellmatch
