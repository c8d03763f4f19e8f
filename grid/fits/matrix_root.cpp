#include "grid/fits/matrix_root.h"

#include "base/decompositions.h"
#include "base/error.h"

#include <Eigen/LU>

#include <algorithm>
#include <cmath>

namespace shellmatch {

namespace {

constexpr double smallest_determinant = 1e-6;  // of a matrix scaled to trace Dim

// Trace, second invariant (in the plane the determinant) and determinant.
struct Invariants {
  double first, second, third;
};

template <int Dim>
Invariants invariants(const Mat<Dim>& a) {
  const double trace = a.trace();
  return {trace, 0.5 * (trace * trace - a.squaredNorm()), a.determinant()};
}

// Largest eigenvalue of a symmetric 3x3 matrix of trace 3 m: m + 2 r cos(phi/3) with r^2 = |A - m I|^2/6 and
// cos(phi) = det(A - m I)/(2 r^3).
double largest_eigenvalue(const Mat<3>& a) {
  const double mean = a.trace() / 3;
  const Mat<3> deviator = a - mean * Mat<3>::Identity();
  const double r = std::sqrt(deviator.squaredNorm() / 6);
  if (!(r > 0)) return mean;
  const double cosine = std::clamp((deviator / r).eval().determinant() / 2, -1.0, 1.0);
  return mean + 2 * r * std::cos(std::acos(cosine) / 3);
}

Invariants root_invariants(const Mat<2>&, const Invariants& a) {
  const double determinant = std::sqrt(a.third);
  return {std::sqrt(a.first + 2 * determinant), determinant, determinant};
}

// Let u be the largest eigenvalue of U. The square of the sum of the other two is tr A - u^2 + 2 det U/u.
Invariants root_invariants(const Mat<3>& matrix, const Invariants& a) {
  Invariants u;
  const double largest = std::sqrt(largest_eigenvalue(matrix));
  u.third = std::sqrt(a.third);
  u.first = largest + std::sqrt(std::max(0.0, a.first - largest * largest + 2 * u.third / largest));
  u.second = 0.5 * (u.first * u.first - a.first);
  return u;
}

Mat<2> root_of(const Mat<2>& a, const Invariants& u) { return (a + u.third * Mat<2>::Identity()) / u.first; }

Mat<3> root_of(const Mat<3>& a, const Invariants& u) {
  return (u.first * u.third * Mat<3>::Identity() + (u.first * u.first - u.second) * a - a * a) /
         (u.first * u.second - u.third);
}

Mat<2> inverse_of(const Mat<2>& root, const Mat<2>&, const Invariants& u) {
  return (u.first * Mat<2>::Identity() - root) / u.third;
}

Mat<3> inverse_of(const Mat<3>& root, const Mat<3>& a, const Invariants& u) {
  return (a - u.first * root + u.second * Mat<3>::Identity()) / u.third;
}

template <int Dim>
Mat<Dim> compute(const Mat<Dim>& matrix, bool inverse) {
  // Scaling to trace Dim prevents overflow of the invariants and makes smallest_determinant a relative bound.
  const double scale = matrix.trace() / Dim;
  SHELLMATCH_CHECK(scale > 0, "a matrix whose root is asked for is not positive definite");
  const Mat<Dim> a = matrix / scale;
  const Invariants i = invariants<Dim>(a);
  const double factor = inverse ? 1 / std::sqrt(scale) : std::sqrt(scale);
  // A symmetric matrix is positive definite exactly where all invariants are positive.
  if (i.third < smallest_determinant || i.second <= 0) {
    const Eigenpairs<Dim> eigen = eigenpairs<Dim>(a);
    SHELLMATCH_CHECK(eigen.values[0] > 0, "a matrix whose root is asked for is not positive definite");
    Vec<Dim> values = eigen.values.cwiseSqrt();
    if (inverse) values = values.cwiseInverse().eval();
    return factor * (eigen.vectors * values.asDiagonal() * eigen.vectors.transpose());
  }
  const Invariants u = root_invariants(a, i);
  const Mat<Dim> root = root_of(a, u);
  return factor * (inverse ? inverse_of(root, a, u) : root);
}

}  // namespace

template <int Dim>
Mat<Dim> franca_root(const Mat<Dim>& a) {
  return compute<Dim>(a, false);
}

template <int Dim>
Mat<Dim> franca_inverse_root(const Mat<Dim>& a) {
  return compute<Dim>(a, true);
}

SHELLMATCH_2D_3D(franca_root);
SHELLMATCH_2D_3D(franca_inverse_root);

}  // namespace shellmatch
