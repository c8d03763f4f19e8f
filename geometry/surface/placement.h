#pragma once
/// \file
/// Placement of the two shapes in the unit square or cube by a common similarity, which preserves their
/// relative position, and its inverse for the output.

#include "base/types.h"
#include "geometry/surface/surface.h"

namespace shellmatch {

/// The map x -> scale rotation x + offset; scale > 0. A placement, from the user's coordinates to the unit domain, does
/// not rotate; a pose, which moves the reference before that, does.
template <int Dim>
struct Similarity {
  double scale = 1;
  Vec<Dim> offset = Vec<Dim>::Zero();
  Mat<Dim> rotation = Mat<Dim>::Identity();  ///< orthogonal; of determinant -1 where it mirrors
  Vec<Dim> operator()(const Vec<Dim>& x) const { return scale * (rotation * x) + offset; }
  Vec<Dim> inverse(const Vec<Dim>& y) const { return rotation.transpose() * (y - offset) / scale; }
  bool is_identity() const { return scale == 1 && offset.isZero(0) && rotation == Mat<Dim>::Identity(); }
};

template <int Dim>
Similarity<Dim> inverse(const Similarity<Dim>& map) {
  if (map.is_identity()) return map;
  return {1 / map.scale, map.inverse(Vec<Dim>::Zero()), map.rotation.transpose()};
}

/// The similarity that centres both shapes together in [margin, 1 - margin]^Dim.
/// \pre both are not empty; 0 <= margin < 1/2. \throws InputError if they have no extent.
template <int Dim>
Similarity<Dim> fit_placement(const Shape<Dim>& reference, const Shape<Dim>& template_shape, double margin);

/// The identity. \throws InputError naming shape and vertex where a shape is not inside
/// [clearance, 1 - clearance]^Dim.
template <int Dim>
Similarity<Dim> as_is_placement(const Shape<Dim>& reference, const Shape<Dim>& template_shape, double clearance);

/// Transforms the computational surface; the original keeps the user's coordinates. A similarity that mirrors turns the
/// facets over, so that they still face outward.
template <int Dim>
void apply_similarity(const Similarity<Dim>& placement, Surface<Dim>& surface);
/// The surface moved by one similarity after the other.
template <int Dim>
Surface<Dim> transformed(Surface<Dim> surface, const Similarity<Dim>& first, const Similarity<Dim>& then) {
  apply_similarity(first, surface);
  apply_similarity(then, surface);
  return surface;
}
/// The surface of a shape, and its observed and unobserved parts; the original stays.
template <int Dim>
void apply_similarity(const Similarity<Dim>& placement, Shape<Dim>& shape);

}  // namespace shellmatch
