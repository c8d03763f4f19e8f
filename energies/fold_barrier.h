#pragma once
/// \file
/// A barrier that keeps det Dphi positive throughout every cell. det Dphi is a polynomial on a cell, of degree 2
/// in each direction in space and bilinear in the plane; it is positive where its Bernstein coefficients are.
/// The barrier acts on these coefficients: what it certifies at the coefficients holds at every point, and
/// subdivision only forms convex combinations of them, so that refinement keeps the certificate.

#include "energies/autodiff/pack.h"
#include "energies/small_matrix.h"
#include "grid/octree.h"

#include <cmath>

namespace shellmatch {

/// Bernstein coefficients of det Dphi on the unit cell per direction: 2 in the plane, 3 in space.
template <int Dim>
inline constexpr int n_bernstein = Dim == 2 ? 2 : 3;
/// And in all: 4 or 27.
template <int Dim>
inline constexpr int n_bernstein_total = Dim == 2 ? 4 : 27;

/// Bernstein coefficients of det(d phi/d xi), xi in the unit cell, from the positions of the corners (corner
/// after corner, Dim components each). Divide by side^Dim for det Dphi. The first direction runs fastest.
template <int Dim, class T>
constexpr std::array<T, n_bernstein_total<Dim>> bernstein_determinant(const T* dofs) {
  constexpr int n = n_bernstein<Dim>;
  // det at the points {0, 1} or {0, 1/2, 1} in each direction; d phi/d xi_k does not depend on xi_k.
  std::array<T, n_bernstein_total<Dim>> b;
  for (int i = 0; i < n_bernstein_total<Dim>; ++i) {
    const int place[3] = {i % n, (i / n) % n, i / (n * n)};
    SmallMat<T, Dim> j;
    for (int k = 0; k < Dim; ++k)
      for (int a = 0; a < Dim; ++a) {
        // Mean over the edges along k that surround the point: all of those at distance 1/2, or the one at 0.
        T sum{};
        int count = 0;
        for (int c = 0; c < n_corners<Dim>; ++c) {
          if ((c >> k) & 1) continue;
          bool counts = true;
          for (int m = 0; m < Dim; ++m)
            if (m != k && place[m] != ((c >> m) & 1) * (n - 1) && !(n == 3 && place[m] == 1)) counts = false;
          if (!counts) continue;
          sum = sum + (dofs[(c | (1 << k)) * Dim + a] - dofs[c * Dim + a]);
          ++count;
        }
        j(a, k) = count == 1 ? sum : sum * (1.0 / count);
      }
    b[i] = determinant(j);
  }
  if constexpr (Dim == 3) {
    // Along each direction, values at 0, 1/2, 1 become coefficients: only the middle one changes.
    for (int stride = 1; stride <= 9; stride *= 3)
      for (int i = 0; i < 27; ++i)
        if ((i / stride) % 3 == 1) b[i] = 2.0 * b[i] - 0.5 * (b[i - stride] + b[i + stride]);
  }
  return b;
}

/// Mean over the coefficients b of B(b / d0), B(x) = (1 - x)^3 / x for 0 < x < 1 and 0 beyond: twice
/// continuously differentiable, infinite as x -> 0, NaN for x <= 0. Active: the corners' positions; passive:
/// 1 / (d0 side^Dim).
template <int Dim>
struct FoldBarrierFunctor {
  static constexpr int n_active = n_corners<Dim> * Dim;
  static constexpr int n_passive = 1;
  template <class T, class P>
  static constexpr T evaluate(const T* active, const P* passive) {
    using autodiff::max_of;
    using std::sqrt;
    const auto b = bernstein_determinant<Dim>(active);
    T sum(0.0);
    for (const T& coefficient : b) {
      const T x = coefficient * passive[0];
      const T root = sqrt(x);  // NaN for x < 0
      const T gap = max_of(1.0 - x, T(0.0));
      sum = sum + gap * gap * gap / (root * root);
    }
    return sum * (1.0 / n_bernstein_total<Dim>);
  }
};

}  // namespace shellmatch
