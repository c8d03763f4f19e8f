#pragma once
/// \file
/// Distances between two surfaces: of the vertices of each to the other one.

#include "geometry/distance/measured_parts.h"
#include "geometry/distance/signed_distance.h"

#include <vector>

namespace shellmatch {

/// Statistics of distances, in their unit. NaN for an empty set.
struct DistanceStatistics {
  double mean, p95, max;  ///< p95: the 95 % quantile
};

/// The q-quantile of n values: the element q (n - 1), rounded, of the sorted list; NaN for n = 0.
/// \pre 0 <= q <= 1; no value is NaN.
double quantile(std::vector<double> values, double q);

DistanceStatistics statistics(std::vector<double> values);

/// Unsigned distance of every point to the surface.
template <int Dim>
std::vector<double> distances_to(const std::vector<Vec<Dim>>& points, const SignedDistance<Dim>& surface);

/// The template counts as covered where the deformed reference is at most so far away, in diagonals of the template.
inline constexpr double covered_within = 0.01;

/// Accuracy of a matching. Both statistics are divided by the diagonal of the template's bounding box.
template <int Dim>
struct MatchQuality {
  DistanceStatistics deformed_to_template;  ///< vertices of the deformed reference to the template's surface
  DistanceStatistics template_to_deformed;  ///< vertices of the template to the deformed reference's surface
  /// Share of the template's area (length) that is farther than `covered_within` diagonals from the deformed reference.
  double uncovered;
  /// The vertices with the greatest distances.
  Vec<Dim> farthest_of_deformed, farthest_of_template;
};

/// Two-sided distances. Vertices without a facet are ignored. \param parts the vertices at which they are measured; where one of the
/// surfaces has none, all figures of its direction are NaN. \pre neither surface is empty.
template <int Dim>
MatchQuality<Dim> match_quality(const Surface<Dim>& deformed, const SignedDistance<Dim>& template_distance, const MeasuredParts<Dim>& parts = {});

}  // namespace shellmatch
