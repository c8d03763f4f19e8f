#pragma once
/// \file
/// Several pictures side by side, with captions and colour bars.

#include "render/canvas/canvas.h"

#include <optional>
#include <span>
#include <string>

namespace shellmatch {

/// Explains the colours of a scalar.
struct ColorBar {
  ColorMap map = ColorMap::sequential;
  double min = 0, max = 1;
  std::string label;  ///< what is shown, with its unit
};

struct Panel {
  Image image;
  std::string caption;
  std::optional<ColorBar> bar;  ///< below the caption
};

/// The panels in rows of `columns` (0: all in one row), a title above where it is not empty.
/// \pre at least one panel; panels of one size look best.
Image compose_panels(std::span<const Panel> panels, const std::string& title = "", int columns = 0);

}  // namespace shellmatch
