#pragma once
/// \file
/// How coordinates of a file in the plane became those of its shape.

#include "base/types.h"

namespace shellmatch {

/// (x, y) -> (scale x, y_scale y + y_offset): units, and an axis that points down the rows of a picture.
struct PlaneFrame {
  double scale = 1, y_scale = 1, y_offset = 0;

  bool is_identity() const { return scale == 1 && y_scale == 1 && y_offset == 0; }
  Vec<2> operator()(const Vec<2>& x) const { return {scale * x.x(), y_scale * x.y() + y_offset}; }
  /// In space coordinates stay as they are.
  Vec<3> operator()(const Vec<3>& x) const { return x; }

  /// First this one, then y -> factor y + offset.
  PlaneFrame then(double factor, double offset) const { return {scale, factor * y_scale, factor * y_offset + offset}; }
};

}  // namespace shellmatch
