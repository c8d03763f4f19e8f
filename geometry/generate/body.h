#pragma once
/// \file
/// A generated body apart from its pose: the tessellation at rest and the map that carries it into the
/// domain. Two bodies with the same rest shape correspond point by point through their poses.

#include "geometry/surface/surface.h"

#include <cmath>
#include <functional>

namespace shellmatch {

/// `pose` is defined on the rest shape at least; where it is a map of a neighbourhood of it, orientation is
/// kept.
template <int Dim>
struct Body {
  Surface<Dim> rest;
  std::function<Vec<Dim>(const Vec<Dim>&)> pose;
};

/// The middle of the domain, where all bodies lie.
template <int Dim>
Vec<Dim> domain_centre() {
  return Vec<Dim>::Constant(0.5);
}

inline double radians(double degrees) { return degrees * (M_PI / 180); }

}  // namespace shellmatch
