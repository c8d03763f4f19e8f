#pragma once
/// \file
/// Several pictures side by side, with captions and colour bars.

#include "matching/render/canvas/canvas.h"

#include <optional>
#include <span>
#include <string>

namespace shellmatch {

/// Legend of the colours of a scalar.
struct ColorBar {
  ColorMap map = ColorMap::sequential;
  double min = 0, max = 1;
  std::string label;  ///< the quantity and its unit
};

struct Panel {
  Image image;
  std::string caption;
  std::optional<ColorBar> bar;  ///< below the caption
};

/// Arranges the panels in rows of `columns` (0: all in one row), with a title above unless it is empty.
/// \pre at least one panel. The panels should have the same size.
Image compose_panels(std::span<const Panel> panels, const std::string& title = "", int columns = 0);

/// The same as a canvas of that kind, on which text and bars are drawn and the pictures placed.
Canvas draw_panels(std::span<const Panel> panels, const std::string& title, int columns, CanvasKind kind);

}  // namespace shellmatch
