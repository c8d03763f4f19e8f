#pragma once
/// \file
/// Eigenvalues and Cholesky factors of small symmetric matrices, eight at a time.

#include "energies/autodiff/pack.h"
#include "energies/densities/small_matrix.h"

#include <algorithm>
#include <array>

namespace shellmatch {

/// A square matrix of M rows, in packs of eight.
template <int M>
using SquarePack = std::array<std::array<autodiff::Pack, M>, M>;

/// Factor L with L L^T = h, h positive semidefinite but for rounding. A column whose pivot is below 1e-8 of the
/// trace is left out: what is left of it is at most 1e-4 of the trace by Cauchy and Schwarz, and divided by such a
/// pivot rounding would come out as stiffness.
template <int M>
SquarePack<M> cholesky(const SquarePack<M>& h) {
  using autodiff::Pack;
  Pack trace{};
  for (int i = 0; i < M; ++i) trace += h[i][i];
  const Pack floor = 1e-8 * trace + 1e-300;
  SquarePack<M> l{};
  for (int j = 0; j < M; ++j) {
    Pack d = h[j][j];
    for (int s = 0; s < j; ++s) d -= l[j][s] * l[j][s];
    const Pack root = autodiff::root_of(autodiff::max_of(d, floor));
    const Pack inverse = autodiff::where_greater(d, floor, 1.0 / root);
    l[j][j] = d * inverse;
    for (int i = j + 1; i < M; ++i) {
      Pack v = h[i][j];
      for (int s = 0; s < j; ++s) v -= l[i][s] * l[j][s];
      l[i][j] = v * inverse;
    }
  }
  return l;
}

/// Eigenvalues, ascending in every lane, and the corresponding eigenvectors as columns.
template <int Dim>
struct PackEigenpairs {
  std::array<autodiff::Pack, Dim> values;
  SmallMat<autodiff::Pack, Dim> vectors;
};

namespace detail {

/// Whether the entries beside the diagonal exceed rounding in any lane. False where a lane is not finite.
template <int Dim>
bool is_off_diagonal(const SmallMat<autodiff::Pack, Dim>& a) {
  autodiff::Pack off{}, all{};
  for (int i = 0; i < Dim; ++i)
    for (int j = i; j < Dim; ++j) (i == j ? all : off) += a(i, j) * a(i, j);
  all = off > 1e-30 * (all + off) ? autodiff::Pack{} + 1.0 : autodiff::Pack{};
  return autodiff::sum_lanes(all) > 0;
}

/// The rotation in the plane of axes p and q that makes entry (p, q) vanish, applied to the upper triangle of A and to
/// the vectors.
template <int Dim>
void rotate(SmallMat<autodiff::Pack, Dim>& a, SmallMat<autodiff::Pack, Dim>& vectors, int p, int q) {
  using autodiff::Pack;
  const Pack off = a(p, q), gap = a(q, q) - a(p, p), twice = off + off;
  const Pack length = autodiff::where_greater(gap, Pack{}, gap, -gap);
  const Pack t = autodiff::where_greater(gap, Pack{}, twice, -twice) /
                 autodiff::max_of(length + autodiff::root_of(gap * gap + twice * twice), Pack{} + 1e-300);
  const Pack c = 1.0 / autodiff::root_of(1.0 + t * t), s = t * c;
  const auto turn = [&](Pack& x, Pack& y) {
    const Pack first = c * x - s * y;
    y = s * x + c * y;
    x = first;
  };
  a(p, p) -= t * off;
  a(q, q) += t * off;
  a(p, q) = Pack{};
  for (int k = 0; k < Dim; ++k) {
    if (k != p && k != q) turn(a(std::min(k, p), std::max(k, p)), a(std::min(k, q), std::max(k, q)));
    turn(vectors(k, p), vectors(k, q));
  }
}

}  // namespace detail

/// Eigendecomposition of the symmetric matrices whose upper triangles are those of `a`, by cyclic Jacobi rotations (G.
/// H. Golub and C. F. Van Loan, 'Matrix Computations', 4th edition, algorithm 8.5.3). Lanes that are not finite hold
/// anything.
template <int Dim>
PackEigenpairs<Dim> pack_eigenpairs(SmallMat<autodiff::Pack, Dim> a) {
  using autodiff::Pack;
  PackEigenpairs<Dim> pairs;
  for (int i = 0; i < Dim; ++i) pairs.vectors(i, i) += 1.0;
  constexpr int max_sweeps = 12;  // convergence is quadratic: three to five are needed
  for (int sweep = 0; sweep < max_sweeps && detail::is_off_diagonal(a); ++sweep)
    for (int p = 0; p < Dim; ++p)
      for (int q = p + 1; q < Dim; ++q) detail::rotate(a, pairs.vectors, p, q);
  for (int i = 0; i < Dim; ++i) pairs.values[i] = a(i, i);
  const auto sort = [&](int i, int j) {
    const Pack of_i = pairs.values[i], of_j = pairs.values[j];
    const auto swap = [&](Pack& x, Pack& y) {
      const Pack first = autodiff::where_greater(of_i, of_j, y, x);
      y = autodiff::where_greater(of_i, of_j, x, y);
      x = first;
    };
    swap(pairs.values[i], pairs.values[j]);
    for (int k = 0; k < Dim; ++k) swap(pairs.vectors(k, i), pairs.vectors(k, j));
  };
  sort(0, 1);
  if constexpr (Dim == 3) {
    sort(1, 2);
    sort(0, 1);
  }
  return pairs;
}

}  // namespace shellmatch
