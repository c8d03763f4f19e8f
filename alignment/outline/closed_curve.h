#pragma once
/// \file
/// Closed curves of an outline, smoothed and sampled at equal distances.

#include "geometry/surface/surface.h"

#include <vector>

namespace shellmatch {

/// The closed polygons of an outline: lists of its vertices in the direction of its segments, those of several that
/// meet at a vertex in the order of the segments. Segments that belong to no closed polygon are left out.
std::vector<std::vector<Index>> closed_polygons(const Surface<2>& outline);

/// n samples of a curve that a polygon becomes where a Gaussian removes its small teeth.
struct ClosedCurve {
  std::vector<Vec<2>> points;                  ///< n, at equal distances along the smoothed curve
  std::vector<Vec<2>> normals;                 ///< of length 1, to the right of the direction
  std::vector<Vec<2>> on_input;                ///< the points of the polygon itself that became `points`
  std::array<std::vector<double>, 3> turning;  ///< angle between the chords behind and ahead of a sample, of 2, 5 and
                                               ///< 10 % of the length, over pi: curvature at three scales, -1 to 1
  double length = 0;                           ///< of the smoothed curve
  bool is_hole = false;                        ///< runs clockwise

  std::size_t size() const { return points.size(); }
};

/// \param smoothing standard deviation of the Gaussian, share of the polygon's length
/// \pre the polygon has a length; n >= 8
ClosedCurve smoothed_curve(const std::vector<Vec<2>>& polygon, std::size_t n, double smoothing);

}  // namespace shellmatch
