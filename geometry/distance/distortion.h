#pragma once
/// \file
/// Distortion of a surface by a deformation: stretching, shearing, folding. All functions compare two
/// surfaces with the same facets, before (`reference`) and after (`deformed`) the deformation.

#include "geometry/distance/signed_distance.h"

#include <vector>

namespace shellmatch {

/// Ratio of the measures of every deformed facet and its reference facet: of areas in space, of lengths in
/// the plane. NaN where the reference facet has measure 0.
template <int Dim>
std::vector<double> facet_measure_ratios(const Surface<Dim>& reference, const Surface<Dim>& deformed);

/// The same for every vertex: the ratio of the sums over its facets. NaN where the sum of the reference is 0.
template <int Dim>
std::vector<double> vertex_measure_ratios(const Surface<Dim>& reference, const Surface<Dim>& deformed);

/// Singular values of the linear map from a reference triangle to its deformed triangle.
struct Stretch {
  double s1, s2;  ///< s1 >= s2 >= 0
};
/// One for each facet; NaN for a reference triangle without area.
std::vector<Stretch> principal_stretches(const Surface<3>& reference, const Surface<3>& deformed);

/// s1 / s2 for each facet: 1 where angles are preserved, infinite where the deformed triangle has no area. In
/// the plane it is always 1, because a segment has no angles.
template <int Dim>
std::vector<double> angle_distortions(const Surface<Dim>& reference, const Surface<Dim>& deformed);

/// Largest turn of a direction in each facet against the principal ones, in degrees: 2 atan(sqrt(s1 / s2)) - 90, half
/// of Tissot's maximum. 0 in the plane.
template <int Dim>
std::vector<double> turned_directions(const Surface<Dim>& reference, const Surface<Dim>& deformed);

/// Whether a facet's normal forms an angle of more than 90 degrees with that of the template's facet nearest to its
/// centre: one entry for each facet, 0 or 1.
template <int Dim>
std::vector<char> facing_away(const Surface<Dim>& deformed, const SignedDistance<Dim>& template_distance);

}  // namespace shellmatch
