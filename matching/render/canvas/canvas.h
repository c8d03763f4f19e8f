#pragma once
/// \file
/// A canvas for lines, areas, text and images, raster or SVG. The adapter of Cairo is its implementation.

#include "matching/render/canvas/image.h"

#include <memory>
#include <span>
#include <string>
#include <vector>

namespace shellmatch {

/// Lengths in pixels. `dashes` holds alternating lengths of dashes and gaps; empty for a solid line.
struct LineStyle {
  Color color = black;
  double width = 1;
  double alpha = 1;
  std::vector<double> dashes;
};

/// `anchor_x`: 0 places the left end of the text at the position, 1/2 its middle, 1 its right end.
/// `anchor_y`: 0 places the base line there, 1/2 the middle of a capital letter, 1 its top.
struct TextStyle {
  double size = 14;  ///< of the font, pixels
  bool bold = false;
  Color color = black;
  double anchor_x = 0, anchor_y = 0;
  double turn = 0;  ///< degrees, counter-clockwise
};

enum class CanvasKind { raster, svg, pdf };

/// Coordinates are pixels, x to the right, y downwards, (0, 0) the upper left corner. Fonts: DejaVu Sans.
class Canvas {
 public:
  /// \pre width and height > 0
  Canvas(int width, int height, CanvasKind kind = CanvasKind::raster, const Color& background = white);
  ~Canvas();
  Canvas(Canvas&&) noexcept;
  Canvas& operator=(Canvas&&) noexcept;

  int width() const;
  int height() const;

  void polyline(std::span<const Vec<2>> points, bool closed, const LineStyle& style);
  /// Fills the area of all rings together by the even-odd rule, so that inner rings are holes.
  void fill(std::span<const std::vector<Vec<2>>> rings, const Color& color, double alpha = 1);
  void rectangle(const Vec<2>& upper_left, const Vec<2>& size, const Color& color, double alpha = 1);
  void disc(const Vec<2>& centre, double radius, const Color& color, double alpha = 1);
  void text(const std::string& words, const Vec<2>& position, const TextStyle& style);
  double text_width(const std::string& words, const TextStyle& style);
  void image(const Image& picture, int x, int y);
  /// Restricts drawing to the rectangle until unclip() is called. Must not be nested.
  void clip(const Vec<2>& upper_left, const Vec<2>& size);
  void unclip();

  /// The picture. \pre the canvas is a raster
  Image to_image() const;
  /// The bytes of a PNG, SVG or PDF file, depending on the kind of the canvas. Nothing can be drawn after that.
  std::string bytes();
  /// Writes PNG, SVG or PDF, depending on the kind of the canvas. \throws EnvironmentError if the file cannot be
  /// written.
  void write(const std::string& path);

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace shellmatch
