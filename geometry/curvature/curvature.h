#pragma once
/// \file
/// Curvatures at the vertices of meshes and closed contours.

#include "base/types.h"
#include "geometry/surface/surface.h"

#include <cstddef>
#include <vector>

namespace shellmatch {

/// Curvatures with respect to the outward normal: positive where the surface is convex, 1/R on a sphere of
/// radius R.
struct VertexCurvature {
  double k1, k2;  ///< k1 >= k2; unit 1/length
  Vec<3> d1, d2;  ///< unit principal directions; (d1, d2, normal) is orthonormal
  Vec<3> normal;  ///< of the fitted polynomial, outward
};

struct CurvatureOptions {
  int degree = 2;         ///< of the polynomial, 2 <= degree <= 4; for smooth data the error is of order h^(degree - 1)
  int n_rings = 2;        ///< of neighbours for the fit, >= 1; more where these are too few
  std::size_t every = 1;  ///< >= 1; 2: at every second vertex alone, NaN at the others
};
// Where a vertex has very many edges, rings are large: the nearest 200 vertices of them are taken, or 10 times as many
// as such rings have where all vertices have six edges if that is more.

/// The curvatures at each vertex from a polynomial through nearby ones: Cazals and Pouget, 'Estimating differential
/// quantities using polynomial fitting of osculating jets', CAGD 22(2), 2005 (CGAL). All entries are NaN where the
/// connected part has fewer vertices than the polynomial has coefficients, or the vertex has no facet.
std::vector<VertexCurvature> vertex_curvatures(const Surface<3>& surface, const CurvatureOptions& options = {});

/// The curvature at every vertex of the parabola fitted by least squares to the vertex and its `n_rings`
/// neighbours on each side: the counterpart in the plane of vertex_curvatures(). Positive
/// where convex; unit 1/length. NaN where the ring has fewer than 2 n_rings + 1 vertices, or the vertex is
/// not on exactly one ring.
/// \pre n_rings >= 1 (checked)
std::vector<double> curve_curvatures(const Surface<2>& curve, int n_rings = 2);

}  // namespace shellmatch
