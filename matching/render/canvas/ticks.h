#pragma once
/// \file
/// Positions and labels of the ticks of an axis.

#include <string>
#include <vector>

namespace shellmatch {

struct Tick {
  double value;
  std::string label;  ///< empty for a minor tick
};

/// About `wanted` ticks at multiples of 1, 2 or 5 times a power of ten in [min, max]. \pre min < max, finite
std::vector<Tick> linear_ticks(double min, double max, int wanted = 6);

/// Labelled ticks at powers of ten, and unlabelled ticks between them if there are few powers. If [min, max]
/// contains fewer than two powers, the ticks between them are labelled. \pre 0 < min < max, finite
std::vector<Tick> log_ticks(double min, double max, int wanted = 6);

/// A short decimal number: "0.25", "1e-06", "12000".
std::string short_number(double x);

}  // namespace shellmatch
