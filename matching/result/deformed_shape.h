#pragma once
/// \file
/// The deformed reference as it was read, and where its vertices lie on the template.

#include "geometry/distance/signed_distance.h"
#include "geometry/surface/surface.h"
#include "matching/level/deformation.h"

#include <vector>

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
