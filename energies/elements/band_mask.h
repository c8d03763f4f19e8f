#pragma once
/// \file
/// A weight in [0, 1] on the terms of the band: 0 where one of the shapes has no data.

#include "base/types.h"

#include <optional>

namespace shellmatch {

template <int Dim>
class BandMask {
 public:
  virtual ~BandMask() = default;
  /// For the reference's point x and the point y = phi(x) of the template's domain.
  virtual double weight(const Vec<Dim>& x, const Vec<Dim>& y) const = 0;
  /// The weight, where it is the same for all points at most `x_radius` from x and `y_radius` from y; none where it may
  /// not be. Most elements are far from the edges of a mask.
  virtual std::optional<double> constant(const Vec<Dim>& x, double x_radius, const Vec<Dim>& y,
                                         double y_radius) const = 0;
};

}  // namespace shellmatch
