#include "energies/densities/positive_hessian.h"

#include "energies/densities/pack_eigen.h"

namespace shellmatch {

using autodiff::Pack;

namespace {

Pack size_of(const Pack& x) { return autodiff::where_greater(x, Pack{}, x, -x); }

/// Adds value q q^T to the upper triangle of h.
template <int N>
void add_mode(const std::array<Pack, N>& q, Pack value, SquarePack<N>& h) {
  value = autodiff::max_of(value, Pack{});
  for (int i = 0; i < N; ++i) {
    const Pack scaled = value * q[i];
    for (int j = i; j < N; ++j) h[i][j] += scaled * q[j];
  }
}

}  // namespace

template <int Dim>
Stretches<Dim> principal_stretches(const SmallMat<Pack, Dim>& a) {
  SmallMat<Pack, Dim> square;  // A^T A
  for (int i = 0; i < Dim; ++i)
    for (int j = 0; j < Dim; ++j)
      for (int k = 0; k < Dim; ++k) square(i, j) += a(k, i) * a(k, j);
  Stretches<Dim> found;
  auto& [u, v, s] = found;
  v = pack_eigenpairs<Dim>(square).vectors;
  const Pack turned = determinant(v);
  for (int k = 0; k < Dim; ++k) v(k, 0) = turned < 0 ? -v(k, 0) : v(k, 0);
  SmallMat<Pack, Dim> image;  // A V: orthogonal columns
  for (int i = 0; i < Dim; ++i)
    for (int j = 0; j < Dim; ++j)
      for (int k = 0; k < Dim; ++k) image(i, j) += a(i, k) * v(k, j);
  for (int i = Dim - 1; i > 0; --i) {  // ascending eigenvalues: the smallest is column 0
    Pack square_length{};
    for (int k = 0; k < Dim; ++k) square_length += image(k, i) * image(k, i);
    s[i] = autodiff::root_of(square_length);
    for (int k = 0; k < Dim; ++k)
      u(k, i) = autodiff::where_greater(s[i], Pack{} + 1e-12, image(k, i) / s[i], Pack{} + (k == i ? 1.0 : 0.0));
  }
  if constexpr (Dim == 3) {
    for (int k = 0; k < 3; ++k) {
      const int p = (k + 1) % 3, q = (k + 2) % 3;
      u(k, 0) = u(p, 1) * u(q, 2) - u(q, 1) * u(p, 2);
    }
  } else {
    u(0, 0) = u(1, 1);
    u(1, 0) = -u(0, 1);
  }
  s[0] = Pack{};
  for (int k = 0; k < Dim; ++k) s[0] += u(k, 0) * image(k, 0);
  return found;
}

template <int Dim>
SquarePack<Dim * Dim> projected_hessian(const Stretches<Dim>& a, const autodiff::SecondOrder<Dim, Pack>& psi) {
  constexpr int n = Dim * Dim;
  constexpr double root_half = 0.70710678118654752440;
  using Mode = std::array<Pack, n>;
  std::array<std::array<Mode, Dim>, Dim> outer;  // u_i v_j^T
  for (int i = 0; i < Dim; ++i)
    for (int j = 0; j < Dim; ++j)
      for (int k = 0; k < n; ++k) outer[i][j][k] = a.u(k / Dim, i) * a.v(k % Dim, j);
  SquarePack<n> h{};
  for (int i = 0; i < Dim; ++i)
    for (int j = i + 1; j < Dim; ++j) {
      Mode twist, flip;
      for (int k = 0; k < n; ++k) {
        twist[k] = root_half * (outer[i][j][k] - outer[j][i][k]);
        flip[k] = root_half * (outer[i][j][k] + outer[j][i][k]);
      }
      const Pack sum = a.s[i] + a.s[j], gap = a.s[i] - a.s[j];
      add_mode<n>(twist, autodiff::where_greater(size_of(sum), Pack{} + 1e-9, (psi.g[i] + psi.g[j]) / sum), h);
      add_mode<n>(flip,
                  autodiff::where_greater(size_of(gap), Pack{} + 1e-4, (psi.g[i] - psi.g[j]) / gap,
                                          0.5 * (psi.h(i, i) + psi.h(j, j)) - psi.h(i, j)),
                  h);
    }
  SmallMat<Pack, Dim> second;
  for (int i = 0; i < Dim; ++i)
    for (int j = 0; j < Dim; ++j) second(i, j) = psi.h(i, j);
  const PackEigenpairs<Dim> stretch = pack_eigenpairs<Dim>(second);
  for (int m = 0; m < Dim; ++m) {
    Mode mode{};
    for (int i = 0; i < Dim; ++i)
      for (int k = 0; k < n; ++k) mode[k] += stretch.vectors(i, m) * outer[i][i][k];
    add_mode<n>(mode, stretch.values[m], h);
  }
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < i; ++j) h[i][j] = h[j][i];
  return h;
}

#define SHELLMATCH_INSTANTIATE(Dim)                                        \
  template Stretches<Dim> principal_stretches(const SmallMat<Pack, Dim>&); \
  template SquarePack<Dim * Dim> projected_hessian(const Stretches<Dim>&, const autodiff::SecondOrder<Dim, Pack>&);
SHELLMATCH_INSTANTIATE(2)
SHELLMATCH_INSTANTIATE(3)
#undef SHELLMATCH_INSTANTIATE

}  // namespace shellmatch
