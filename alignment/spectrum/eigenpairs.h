#pragma once
/// \file
/// Eigenvalues and eigenfunctions of a surface's Laplacian.

#include "alignment/spectrum/laplacian.h"

namespace shellmatch {

struct Eigenpairs {
  Eigen::VectorXd values;     ///< ascending; the first is zero on a connected surface
  Eigen::MatrixXd functions;  ///< a column for each value, a row for each vertex; orthonormal in the mass matrix
};

/// The `n` pairs of least eigenvalue: Lanczos with implicit restarts for the inverse. On a connected surface the first
/// function is constant and positive. The sign of the others is arbitrary, but the same in every call.
/// \pre 0 < n < number of vertices \throws InputError if the Laplacian is not finite or the iteration does not converge
Eigenpairs least_eigenpairs(const SurfaceLaplacian& laplacian, int n);

}  // namespace shellmatch
