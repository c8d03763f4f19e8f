#pragma once
/// \file
/// Crude triangulation of a zero level on the body-centred cubic lattice, the first stage of mesh_implicit.

#include "geometry/implicit/implicit_function.h"
#include "geometry/surface/surface.h"

#include <memory>
#include <vector>

namespace shellmatch {

/// Triangulates the zero level of f within [0.04, 0.96]^3, oriented outward, tetrahedron by tetrahedron of a
/// body-centred cubic lattice with cubes of side `spacing`. Lattice points close to the surface are first
/// moved onto it, which avoids thin triangles: Labelle and Shewchuk, 'Isosurface stuffing', ACM TOG 26(3),
/// 2007, with their two thresholds. Vertices are on the zero level up to the error of linear interpolation.
class Lattice {
 public:
  Lattice(const ImplicitFunction& f, double spacing);
  ~Lattice();
  Lattice(const Lattice&) = delete;
  Lattice& operator=(const Lattice&) = delete;

  Surface<3> triangulate();

  /// Lattice points within a cube's diagonal of these places are no longer moved. Where none is, the triangles bound a
  /// body whatever the function, but may be thin.
  void keep_points_near(const std::vector<Vec<3>>& places);
  /// None at all.
  void keep_all_points();

 private:
  class Body;
  std::unique_ptr<Body> body_;
};

}  // namespace shellmatch
