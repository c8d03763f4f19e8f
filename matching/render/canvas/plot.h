#pragma once
/// \file
/// Line plots.

#include "matching/render/canvas/canvas.h"

#include <string>
#include <vector>

namespace shellmatch {

struct Series {
  std::string name;          ///< in the legend; empty for no entry
  std::vector<double> x, y;  ///< of equal length; a point that is not finite, or not positive on a
                             ///< logarithmic axis, interrupts the line
  bool dashed = false, points = false;
  bool line = true;         ///< false shows the points alone
  double point_radius = 3;  ///< pixels
  int color = -1;           ///< index of series_color(); -1: the index of the series
  int dashes = 0;           ///< dash pattern 1 to 5; 0 is solid unless `dashed`
};

struct Plot {
  std::string title, x_label, y_label;
  bool log_x = false, log_y = false;
  std::vector<Series> series = {};
  std::vector<std::string> rows = {};  ///< labels at y = 0, 1, ... from the top, in place of numbers; empty: numbers
  std::vector<double> marks = {};      ///< thin vertical lines at these x
  int width = 900, height = 560;       ///< pixels
};

/// A plot without a point to show has a text that says so.
void draw_plot(const Plot& plot, Canvas& canvas);

/// Writes the format of the file name's extension, .png or .svg. \throws EnvironmentError if the file cannot
/// be written.
void write_plot(const Plot& plot, const std::string& path);

}  // namespace shellmatch
