#pragma once
/// \file
/// Line plots: energies against iterations or seconds, and whatever studies compare.

#include "render/canvas/canvas.h"

#include <string>
#include <vector>

namespace shellmatch {

struct Series {
  std::string name;          ///< in the legend; empty leaves it out
  std::vector<double> x, y;  ///< of equal length; points that are not finite, or not positive on a
                             ///< logarithmic axis, interrupt the line
  bool dashed = false, points = false;
  bool line = true;         ///< false shows the points alone
  double point_radius = 3;  ///< pixels
  int color = -1;           ///< of series_color(); -1 takes the place among the series
  int dashes = 0;           ///< 1 to 5: patterns told apart; 0 is solid unless `dashed`
};

struct Plot {
  std::string title, x_label, y_label;
  bool log_x = false, log_y = false;
  std::vector<Series> series = {};
  std::vector<std::string> rows = {};  ///< where given: the names at y = 0, 1, ... from the top, in place of numbers
  std::vector<double> marks = {};  ///< upright thin lines at these x, where a level begins for instance
  int width = 900, height = 560;   ///< pixels
};

/// A plot without any point that can be shown says so in its middle.
void draw_plot(const Plot& plot, Canvas& canvas);

/// By the ending of `path`: .png or .svg. \throws EnvironmentError if the file cannot be written.
void write_plot(const Plot& plot, const std::string& path);

}  // namespace shellmatch
