#pragma once
/// \file
/// det Dphi on a cell as a polynomial: of degree 2 in each direction in space and bilinear in the plane. It is positive
/// where its Bernstein coefficients are. Subdivision forms convex combinations of them only, so that refinement keeps
/// what they certify.

#include "energies/densities/small_matrix.h"
#include "grid/octree/octree.h"

#include <array>

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
[[gnu::noinline]] constexpr std::array<T, n_bernstein_total<Dim>> bernstein_determinant(const T* dofs) {
  constexpr int n = n_bernstein<Dim>, n_edges = n_corners<Dim> / 2, n_places = n_bernstein_total<Dim> / n;
  // d phi/d xi_k is the same all along xi_k, and multilinear in the other directions: differences along edges, in space
  // also half way between them, which are means.
  std::array<std::array<std::array<T, Dim>, n_places>, Dim> slope;
  for (int k = 0; k < Dim; ++k)
    for (int a = 0; a < Dim; ++a) {
      std::array<T, n_edges> edge;
      for (int e = 0; e < n_edges; ++e) {
        const int c = (e & ((1 << k) - 1)) | (e >> k << (k + 1));  // the edge's lower end
        edge[e] = dofs[(c | (1 << k)) * Dim + a] - dofs[c * Dim + a];
      }
      auto& at = slope[k];
      if constexpr (Dim == 2) {
        for (int e = 0; e < n_edges; ++e) at[e][a] = edge[e];
      } else {
        for (int e = 0; e < n_edges; ++e) at[2 * (e & 1) + 6 * (e >> 1)][a] = edge[e];
        for (const int row : {0, 6}) at[row + 1][a] = 0.5 * (at[row][a] + at[row + 2][a]);
        for (int i = 0; i < 3; ++i) at[3 + i][a] = 0.5 * (at[i][a] + at[6 + i][a]);
      }
    }
  // det at the points {0, 1} or {0, 1/2, 1} in each direction.
  std::array<T, n_bernstein_total<Dim>> b;
  for (int i = 0; i < n_bernstein_total<Dim>; ++i) {
    const int place[3] = {i % n, (i / n) % n, i / (n * n)};
    SmallMat<T, Dim> j;
    for (int k = 0; k < Dim; ++k) {
      int at = 0;  // of the other directions, the first runs fastest
      for (int m = Dim - 1; m >= 0; --m)
        if (m != k) at = n * at + place[m];
      for (int a = 0; a < Dim; ++a) j(a, k) = slope[k][at][a];
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

}  // namespace shellmatch
