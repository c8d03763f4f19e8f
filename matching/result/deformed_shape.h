#pragma once
/// \file
/// The reference after the deformation: the surface that was matched, and the shape as it was read.

#include "geometry/distance/signed_distance.h"
#include "geometry/surface/surface.h"
#include "matching/level/deformation.h"

#include <vector>

namespace shellmatch {

/// The same surface with its facets split until none is longer than `length`: what is measured is then the image
/// of the curve, not the polygon through the images of its corners. In space the surface itself, as meshes are as
/// fine as their shape asks for.
template <int Dim>
Surface<Dim> subdivided(const Surface<Dim>& surface, double length);

/// The surface with its vertices moved by phi; unit domain.
template <int Dim>
Surface<Dim> deformed_surface(const Surface<Dim>& reference, const Octree<Dim>& grid, const std::vector<Vec<Dim>>& phi);

/// The reference as it was read, moved by the deformation, with the attributes distance_to_template (user's unit)
/// and area_ratio (length_ratio in the plane) besides its own.
template <int Dim>
OriginalShape<Dim> deformed_original(const OriginalShape<Dim>& reference, const Deformation<Dim>& deformation,
                                     const SignedDistance<Dim>& template_distance);

}  // namespace shellmatch
