#pragma once
/// \file
/// What the report shows as colours: one value for each vertex of the surfaces that were matched.

#include "matching/result/match_result.h"

#include <cstddef>
#include <vector>

namespace shellmatch {

/// Lengths are in the unit of the template's file. NaN where a value is not defined.
struct SurfaceFigures {
  // For each vertex of the reference:
  std::vector<double> distance_to_template;  ///< of its image
  std::vector<double> measure_ratio;         ///< area (length in the plane) after over before
  std::vector<double> angle_change;  ///< largest turn of a tangent direction against the principal ones in degrees,
                                     ///< mean over the facets around; empty in the plane
  std::vector<double>
      curvature_change;  ///< mean curvature of the template next to the image, minus that of the reference; 1/length
  // For each vertex of the template:
  std::vector<double> distance_to_deformed;
};

/// \param enough_fits of curvatures of one surface: of larger ones the other vertices have that of one that is near. A
/// picture has no more pixels.
template <int Dim>
SurfaceFigures surface_figures(const MatchResult<Dim>& result, std::size_t enough_fits = 200'000);

/// A length of the unit domain times this is one in the unit of the template's file.
template <int Dim>
double unit_of_template(const MapFrame<Dim>& frame) {
  return 1 / (frame.placement.scale * (frame.is_backward ? frame.pose.scale : 1));
}

}  // namespace shellmatch
