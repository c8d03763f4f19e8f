#pragma once
/// \file
/// The deformed reference as it was read.

#include "geometry/distance/signed_distance.h"
#include "geometry/surface/surface.h"
#include "matching/level/deformation.h"

#include <vector>

namespace shellmatch {

/// Appends an attribute. Those of the same name go: a result that is used as a reference has those of its own matching.
template <int Dim>
void set_attribute(OriginalShape<Dim>& shape, VertexAttribute attribute);

/// The reference as it was read, with its vertices where they were carried, and with the additional attributes
/// distance_to_template (user's unit) and area_ratio (length_ratio in the plane), which replace attributes of these
/// names. \param carried user's coordinates
template <int Dim>
OriginalShape<Dim> deformed_original(const OriginalShape<Dim>& reference, std::vector<Vec<Dim>> carried,
                                     const Deformation<Dim>& deformation, const SignedDistance<Dim>& template_distance);

}  // namespace shellmatch
