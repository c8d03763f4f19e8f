#pragma once
/// \file
/// Where the vertices of the deformed reference lie on the template as it was read, and how far the template's vertices
/// are from the deformed reference.

#include "geometry/distance/signed_distance.h"
#include "geometry/surface/surface.h"
#include "matching/level/deformation.h"

namespace shellmatch {

/// Adds to each vertex of the deformed reference the point of the template that is nearest to it, in the numbering of
/// the template's file, counted from 0: in space `template_face`, three vertices of that face `template_v0`,
/// `template_v1`, `template_v2` and their barycentric coordinates `template_b0`, `template_b1`, `template_b2` (>= 0,
/// sum 1); in the plane `template_ring` and two of each. Of a face with more corners the vertices are those of the
/// triangle that holds the point. Repairs are not seen: faces are those of the file. \param placement of both shapes in
/// the unit domain
template <int Dim>
void add_correspondence(OriginalShape<Dim>& deformed, const OriginalShape<Dim>& template_shape,
                        const Similarity<Dim>& placement);

/// The template as it was read with the additional attribute `distance_to_deformed` (user's unit): where that is large,
/// the deformed reference does not reach. \param distance_to_deformed the reference's surface, deformed, in the unit
/// domain
template <int Dim>
OriginalShape<Dim> template_with_distance(const OriginalShape<Dim>& template_shape, const MapFrame<Dim>& frame,
                                          const SignedDistance<Dim>& distance_to_deformed);

}  // namespace shellmatch
