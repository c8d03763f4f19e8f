#pragma once
/// \file
/// Distances between two surfaces: of points of each to the other one, weighted by area (length).

#include "geometry/distance/measured_parts.h"
#include "geometry/distance/signed_distance.h"

#include <limits>
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

/// The same of values that count by their weights >= 0: p95 is the least value that 95 % of the weight do not exceed,
/// max the largest value of any weight. Where all weights are 0, all count alike. \pre as many weights as values; no
/// value is NaN
DistanceStatistics weighted_statistics(const std::vector<double>& values, const std::vector<double>& weights);

/// Unsigned distance of every point to the surface.
template <int Dim>
std::vector<double> distances_to(const std::vector<Vec<Dim>>& points, const SignedDistance<Dim>& surface);
/// The same without the normals that signs need, which take as long to prepare as the search for the nearest facets.
/// \pre the surface has facets (checked), all coordinates are finite (those of the points are checked)
template <int Dim>
std::vector<double> distances_to(const std::vector<Vec<Dim>>& points, const Surface<Dim>& surface);

/// The template counts as covered where the deformed reference is at most so far away, in diagonals of the template.
inline constexpr double covered_within = 0.01;

/// Accuracy of a matching. Both statistics are divided by the diagonal of the template's bounding box. They are
/// integrals over the surfaces, which do not depend on where a mesh has its vertices, as Cignoni, Rocchini and Scopigno
/// (1998) measure simplified surfaces: each vertex, and each point that was added within a large facet, counts by the
/// area (length) around it.
template <int Dim>
struct MatchQuality {
  DistanceStatistics deformed_to_template;  ///< points of the deformed reference to the template's surface
  DistanceStatistics template_to_deformed;  ///< points of the template to the deformed reference's surface
  /// Share of the template's area (length) that is farther than `covered_within` diagonals from the deformed reference.
  double uncovered;
  /// The points with the greatest distances.
  Vec<Dim> farthest_of_deformed, farthest_of_template;
};

/// Two-sided distances. Vertices without a facet are ignored.
/// \param deformed  measured at its vertices: where its facets are large, the undeformed ones are to be subdivided
/// before, so that they bend \param parts     of the two, where distances are measured; where one of the surfaces has
/// none, all figures of its direction are NaN \param spacing   > 0; edges of the template that are longer are
/// subdivided \param most_points > 0; of surfaces with more vertices, every second, third, ... is measured \pre neither
/// surface is empty
template <int Dim>
MatchQuality<Dim> match_quality(const Surface<Dim>& deformed, const SignedDistance<Dim>& template_distance,
                                const MeasuredParts<Dim>& parts = {},
                                double spacing = std::numeric_limits<double>::infinity(),
                                std::size_t most_points = std::numeric_limits<std::size_t>::max());

}  // namespace shellmatch
