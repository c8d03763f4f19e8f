#pragma once
/// \file
/// The Laplacian of a triangle mesh from its edge lengths, with its eigenvalues and eigenfunctions.

#include <Eigen/SparseCore>

#include "geometry/surface/surface.h"

namespace shellmatch {

/// The generalised eigenvalue problem stiffness u = lambda mass u of linear finite elements.
struct SurfaceLaplacian {
  Eigen::SparseMatrix<double> stiffness;  ///< positive semidefinite, rows sum to zero; without unit
  Eigen::VectorXd mass;                   ///< lumped: a third of the area of the triangles around each vertex
};

/// Lengths of the edges opposite to the corners of each facet. In every facet the same length is added to all three so
/// that the sum of any two exceeds the third by at least `mollification` times the mean length of all edges: thus no
/// triangle is flat, and well shaped ones stay as they are. Sharp and Crane, 'A Laplacian for nonmanifold triangle
/// meshes', SGP 2020, section 4.5, there with one length for the whole mesh.
std::vector<Vec<3>> mollified_edge_lengths(const Surface<3>& surface, double mollification);

/// Cotangent Laplacian from mollified edge lengths. Any facets are admitted, also around an edge of three facets or a
/// border. \pre every vertex has a facet; some edge has a length
SurfaceLaplacian surface_laplacian(const Surface<3>& surface, double mollification);

struct LaplacianEigenpairs {
  Eigen::VectorXd values;     ///< ascending; the first is zero on a connected surface
  Eigen::MatrixXd functions;  ///< a column for each value, a row for each vertex; orthonormal in the mass matrix
};

/// The `n` pairs of least eigenvalue: Lanczos with implicit restarts for the inverse. On a connected surface the first
/// function is constant and positive. The sign of the others is arbitrary, but the same in every call. Of a multiple
/// eigenvalue near the last one, copies may be missing, of which Spectra says nothing
/// (findings/spectra-multiple-eigenvalues.sh).
/// \pre 0 < n < number of vertices \throws InputError if the Laplacian is not finite or the iteration does not converge
LaplacianEigenpairs least_eigenpairs(const SurfaceLaplacian& laplacian, int n);

}  // namespace shellmatch
