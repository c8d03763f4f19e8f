#pragma once
/// \file
/// Pictures of curves, areas and grids in the plane.

#include "geometry/surface/surface.h"
#include "render/canvas/image.h"

#include <array>
#include <span>
#include <vector>

namespace shellmatch {

/// The part of the plane that a picture shows, whole and undistorted, in its middle.
struct Frame {
  Vec<2> min = Vec<2>::Zero(), max = Vec<2>::Ones();
};

/// A frame around all points with a border of `margin` times the longer side.
/// \pre at least one vertex
Frame fit_frame(std::span<const Surface<2>* const> contours, double margin = 0.06);

/// A closed curve and how it looks. Holds no copy: `contour` must outlive the call.
struct RenderContour {
  const Surface<2>* contour = nullptr;
  Color fill{0.86, 0.88, 0.92};
  double fill_alpha = 0;  ///< 0 draws no area
  Color line = black;
  double line_width = 1.6;  ///< pixels; 0 draws no line
  double line_alpha = 1;
  double point_radius = 0;  ///< pixels; 0 draws no vertices
  std::vector<Color> vertex_colors =
      {};  ///< one per vertex or empty; colours line and points in place of `line`
};

/// Thin straight lines under the contours: the cells of a grid, deformed or not.
struct RenderLines {
  std::vector<std::array<Vec<2>, 2>> segments;
  Color color{0.80, 0.82, 0.85};
  double width = 0.7;  ///< pixels
};

/// The curves' closed rings, each vertex once. Open ends are joined.
std::vector<std::vector<Vec<2>>> rings_of(const Surface<2>& contour);

/// Lines first, then areas, then curves and points, in the order given. y runs upwards.
Image render_contours(std::span<const RenderContour> contours, const Frame& frame, int width, int height,
                      std::span<const RenderLines> lines = {});

/// A smooth closed cycle of soft colours by position along with `position_color`: what is near keeps a
/// similar colour. `box` is the box the colours span.
std::vector<Color> position_colors(const std::vector<Vec<2>>& points, const Box<2>& box);

}  // namespace shellmatch
