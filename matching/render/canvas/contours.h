#pragma once
/// \file
/// Pictures of curves, areas and grids in the plane.

#include "geometry/surface/surface.h"
#include "matching/render/canvas/image.h"

#include <array>
#include <span>
#include <vector>

namespace shellmatch {

/// The part of the plane that a picture shows: entire, undistorted and centred.
struct Frame {
  Vec<2> min = Vec<2>::Zero(), max = Vec<2>::Ones();
};

/// A frame around all points with a border of `margin` times the longer side.
/// \pre at least one vertex
Frame fit_frame(std::span<const Surface<2>* const> contours, double margin = 0.06);

/// A closed curve and its style. Keeps a pointer: `contour` must outlive the call.
struct RenderContour {
  const Surface<2>* contour = nullptr;
  Color fill{0.86, 0.88, 0.92};
  double fill_alpha = 0;  ///< 0 draws no area
  Color line = black;
  double line_width = 1.6;  ///< pixels; 0 draws no line
  double line_alpha = 1;
  std::vector<double> dashes = {};        ///< as LineStyle::dashes, of lines of one colour
  double point_radius = 0;                ///< pixels; 0 draws no vertices
  std::vector<Color> vertex_colors = {};  ///< one per vertex, or empty; replaces `line` for line and points
};

/// Thin straight lines drawn under the contours, such as the cells of a grid.
struct RenderLines {
  std::vector<std::array<Vec<2>, 2>> segments;
  Color color{0.80, 0.82, 0.85};
  double width = 0.7;  ///< pixels
};

/// The closed rings of the curve, each vertex once. Open ends are joined.
std::vector<std::vector<Vec<2>>> rings_of(const Surface<2>& contour);

/// Draws lines first, then areas, then curves and points, each in the order given. The y axis points upwards.
Image render_contours(std::span<const RenderContour> contours, const Frame& frame, int width, int height,
                      std::span<const RenderLines> lines = {});

/// Colours by position in the plane, the counterpart of position_color(): nearby points have similar colours.
/// `box` is the box that the range of colours spans.
std::vector<Color> position_colors(const std::vector<Vec<2>>& points, const Box<2>& box);

}  // namespace shellmatch
