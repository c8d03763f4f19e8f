#include "energies/elements/determinants.h"

#include "energies/autodiff/compiled.h"
#include "energies/densities/bernstein.h"

namespace shellmatch {

using autodiff::Pack;

namespace {

/// Least Bernstein coefficient. Active: positions of the corners; passive: 1 / side^Dim.
template <int Dim>
struct LeastDeterminant {
  static constexpr int n_active = n_corners<Dim> * Dim, n_passive = 1;
  template <class T, class P>
  static constexpr T evaluate(const T* active, const P* passive) {
    using autodiff::max_of;
    const auto b = bernstein_determinant<Dim>(active);
    T negative = -b[0];
    for (const T& coefficient : b) negative = max_of(negative, -coefficient);
    return -negative * passive[0];
  }
};

}  // namespace

template <int Dim>
Pack least_determinant(const ElementBatch<Dim>& batch) {
  Pack scale = batch.inverse_side;
  for (int k = 1; k < Dim; ++k) scale *= batch.inverse_side;
  return autodiff::Compiled<LeastDeterminant<Dim>>::value(batch.u.data(), &scale);
}

// A coefficient is a mean of determinants of one edge along each direction, as the product of the columns' Bernstein
// polynomials is one again. The edges along a direction lie in a box about its middle m, so that their determinant is
// that of the middles and of what is left, column by column: |r . (m x m)|, |m . (r x r)| and |r . (r x r)| at most.
template <int Dim>
Pack determinant_bound(const ElementBatch<Dim>& batch) {
  using autodiff::max_of;
  const auto size_of = [](Pack x) { return max_of(x, -x); };
  SmallMat<Pack, Dim> middle, radius;  // columns: by direction
  for (int k = 0; k < Dim; ++k)
    for (int a = 0; a < Dim; ++a) {
      Pack most, negative_least;
      for (int c = 0; c < n_corners<Dim>; ++c) {
        if ((c >> k) & 1) continue;
        const Pack edge = batch.u[(c | 1 << k) * Dim + a] - batch.u[c * Dim + a];
        most = c == 0 ? edge : max_of(most, edge);
        negative_least = c == 0 ? -edge : max_of(negative_least, -edge);
      }
      middle(a, k) = 0.5 * (most - negative_least);
      radius(a, k) = 0.5 * (most + negative_least);
    }
  const auto cofactors = cofactor(middle);
  Pack loss{};
  for (int k = 0; k < Dim; ++k)
    for (int a = 0; a < Dim; ++a) loss += radius(a, k) * size_of(cofactors(a, k));
  if constexpr (Dim == 2) {
    loss += radius(0, 0) * radius(1, 1) + radius(1, 0) * radius(0, 1);
  } else {
    for (int k = 0; k < 3; ++k)
      for (int a = 0; a < 3; ++a) {
        const int i = (k + 1) % 3, j = (k + 2) % 3, b = (a + 1) % 3, c = (a + 2) % 3;
        const Pack across = radius(b, i) * radius(c, j) + radius(c, i) * radius(b, j);
        loss += (k == 0 ? size_of(middle(a, k)) + radius(a, k) : size_of(middle(a, k))) * across;
      }
  }
  Pack bound = determinant(middle) - loss;
  for (int k = 0; k < Dim; ++k) bound *= batch.inverse_side;
  return bound;
}

SHELLMATCH_2D_3D(determinant_bound);
SHELLMATCH_2D_3D(least_determinant);

}  // namespace shellmatch
