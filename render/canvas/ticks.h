#pragma once
/// \file
/// Where an axis has its marks, and what stands beside them.

#include <string>
#include <vector>

namespace shellmatch {

struct Tick {
  double value;
  std::string label;  ///< empty for a minor mark
};

/// Marks at 1, 2 or 5 times a power of ten within [min, max], about `wanted` of them. \pre min < max, finite
std::vector<Tick> linear_ticks(double min, double max, int wanted = 6);

/// Marks at powers of ten, with labels, and unlabelled ones between them where there are few powers; where
/// [min, max] holds fewer than two powers the marks in between get labels. \pre 0 < min < max, finite
std::vector<Tick> log_ticks(double min, double max, int wanted = 6);

/// A short decimal number: "0.25", "1e-06", "12000".
std::string short_number(double x);

}  // namespace shellmatch
