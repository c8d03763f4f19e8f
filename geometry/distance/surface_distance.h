#pragma once
/// \file
/// How far apart two surfaces are: distances of the vertices of each to the other one.

#include "geometry/distance/signed_distance.h"

#include <vector>

namespace shellmatch {

/// Summary of distances; unit: that of the distances. NaN where there are none.
struct DistanceStatistics {
  double mean, p95, max;  ///< p95: 95 of 100 distances are not larger
};

/// The q-quantile of the values, the element at place q (n - 1), rounded, of the sorted list; NaN where there
/// is none. \pre 0 <= q <= 1; no value is NaN.
double quantile(std::vector<double> values, double q);

DistanceStatistics statistics(std::vector<double> values);

/// Unsigned distance of every point to the surface.
template <int Dim>
std::vector<double> distances_to(const std::vector<Vec<Dim>>& points, const SignedDistance<Dim>& surface);

/// What a matching has reached: both statistics are divided by the diagonal of the template's bounding box.
template <int Dim>
struct MatchQuality {
  DistanceStatistics deformed_to_template;  ///< vertices of the deformed reference to the template's surface
  DistanceStatistics template_to_deformed;  ///< vertices of the template to the deformed reference's surface
};

/// Two-sided distances. Vertices that no facet uses do not count. \pre neither surface is empty.
template <int Dim>
MatchQuality<Dim> match_quality(const Surface<Dim>& deformed, const SignedDistance<Dim>& template_distance);

}  // namespace shellmatch
