#pragma once
/// \file
/// The deformed reference: the surface that was matched, and the shape as it was read.

#include "geometry/distance/signed_distance.h"
#include "geometry/surface/surface.h"
#include "matching/level/deformation.h"

#include <vector>

namespace shellmatch {

/// The surface with its vertices moved by the inverse of phi; unit domain. A vertex that is the image of no point moves as the
/// nearest one that is.
template <int Dim>
Surface<Dim> inversely_deformed_surface(const Surface<Dim>& surface, const Octree<Dim>& grid, const std::vector<Vec<Dim>>& phi);

/// Appends an attribute. Those of the same name go: a result that is used as a reference has those of its own matching.
template <int Dim>
void set_attribute(OriginalShape<Dim>& shape, VertexAttribute attribute);

/// The reference as it was read, carried to the template, with the additional attributes distance_to_template (user's
/// unit) and area_ratio (length_ratio in the plane), which replace attributes of these names. A vertex without
/// an image moves as the nearest vertex that has one.
template <int Dim>
OriginalShape<Dim> deformed_original(const OriginalShape<Dim>& reference, const Deformation<Dim>& deformation,
                                     const SignedDistance<Dim>& template_distance);

}  // namespace shellmatch
