#pragma once
/// \file
/// A generated body: the triangulation of its rest shape, and the pose, which maps the rest shape into the
/// domain. The poses of two bodies with the same rest shape define their correspondence point by point.

#include "geometry/surface/surface.h"

#include <cmath>
#include <functional>

namespace shellmatch {

/// `pose` is defined on the rest shape at least. Where it is defined on a neighbourhood, it preserves
/// orientation.
template <int Dim>
struct Body {
  Surface<Dim> rest;
  std::function<Vec<Dim>(const Vec<Dim>&)> pose;
};

/// The centre of the domain and of all bodies.
template <int Dim>
Vec<Dim> domain_centre() {
  return Vec<Dim>::Constant(0.5);
}

inline double radians(double degrees) { return degrees * (M_PI / 180); }

}  // namespace shellmatch
