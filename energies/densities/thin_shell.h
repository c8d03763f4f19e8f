#pragma once
/// \file
/// W, the density of membrane and bending, and of the simplified volume term.

#include "energies/autodiff/pack.h"
#include "energies/densities/material.h"
#include "energies/densities/pack_eigen.h"
#include "energies/densities/small_matrix.h"

#include <array>
#include <cmath>

namespace shellmatch {

/// How W grows where tangential maps compress and turn over: first and second derivative by 1 - det.
struct GrowthDerivatives {
  autodiff::Pack first, second;
};

/// exp(1 - det) (paper, section 3.1).
struct ExponentialGrowth {
  template <class T>
  static constexpr T value(const T& det) {
    using std::exp;
    return exp(1.0 - det);
  }
  static GrowthDerivatives derivatives(const autodiff::Pack& det) {
    const autodiff::Pack e = autodiff::exp_of(1.0 - det);
    return {e, e};
  }
};

/// exp(1 - det) down to det = -3, and its Taylor polynomial of second degree below: convex, twice differentiable, and
/// the same wherever the surface keeps its orientation. A Newton step lowers an exponent by one, but reaches the
/// minimum of a parabola at once. Energies of invertible solids are extrapolated likewise (A. Stomakhin, R. Howes, C.
/// Schroeder, J. Teran: Energetically consistent invertible elasticity. SCA 2012).
struct ExtrapolatedGrowth {
  static constexpr double start = 4;  ///< of 1 - det
  template <class T>
  static constexpr T value(const T& det) {
    using autodiff::max_of;
    using std::exp;
    const T beyond = max_of((1.0 - start) - det, T(0.0));
    return exp(-max_of(det - 1.0, T(-start))) * (1.0 + beyond + 0.5 * (beyond * beyond));
  }
  static GrowthDerivatives derivatives(const autodiff::Pack& det) {
    using autodiff::Pack;
    const Pack e = autodiff::exp_of(-autodiff::max_of(det - 1.0, Pack{} - start));
    return {e * (1.0 + autodiff::max_of((1.0 - start) - det, Pack{})), e};
  }
};

/// Positive semidefinite part of [[a, c], [c, b]], in place.
inline void clamp_symmetric(autodiff::Pack& a, autodiff::Pack& b, autodiff::Pack& c) {
  using autodiff::Pack;
  const Pack mean = 0.5 * (a + b), half = 0.5 * (a - b);
  const Pack radius = autodiff::root_of(half * half + c * c);
  const Pack low = autodiff::max_of(mean - radius, Pack{}), high = autodiff::max_of(mean + radius, Pack{});
  // high - low times the projector onto the upper eigenvector, plus low.
  const Pack s = 0.5 * (high - low) / autodiff::max_of(radius, Pack{} + 1e-300);
  const Pack m = 0.5 * (high + low);
  a = m + s * half;
  b = m - s * half;
  c = s * c;
}

/// Positive semidefinite second derivative of W at Y, by the entries of Y in row order, in closed form, eight points at
/// a time. One number in the plane. In orthonormal frames of both tangent planes (energies/densities/tangent_frames.h)
/// the argument of W is Y, of one row and column less, beside a 1, so that W = mu/2 |Y|^2 + f(det Y) + constant.
template <int Dim, class Growth>
SquarePack<(Dim - 1) * (Dim - 1)> thin_shell_tangent_hessian(const std::array<autodiff::Pack, (Dim - 1) * (Dim - 1)>& y,
                                                             const Material<double>& c) {
  using autodiff::Pack;
  const double k = c.mu + 0.5 * c.lambda;
  if constexpr (Dim == 2) {
    return {{{c.mu + 0.5 * c.lambda + k * Growth::derivatives(y[0]).second}}};
  } else {
    const Pack det = y[0] * y[3] - y[1] * y[2];
    const auto [g1, g2] = Growth::derivatives(det);
    const Pack f1 = 0.5 * c.lambda * det - k * g1, f2 = 0.5 * c.lambda + k * g2;
    // Conformal part p and anticonformal part q: det Y = (|p|^2 - |q|^2) / 2, so the second derivative of f(det)
    // is f' on p, -f' on q, plus f'' (p, -q)(p, -q)^T.
    constexpr double r = 0.70710678118654752440;
    std::array<Pack, 2> p = {r * (y[0] + y[3]), r * (y[2] - y[1])}, q = {r * (y[0] - y[3]), r * (y[1] + y[2])};
    const Pack tiny = Pack{} + 1e-150;
    const Pack np = autodiff::max_of(autodiff::root_of(p[0] * p[0] + p[1] * p[1]), tiny);
    const Pack nq = autodiff::max_of(autodiff::root_of(q[0] * q[0] + q[1] * q[1]), tiny);
    // Directions; where a part vanishes any will do.
    const Pack up0 = autodiff::where_greater(np, tiny, p[0] / np, Pack{} + 1.0),
               up1 = autodiff::where_greater(np, tiny, p[1] / np);
    const Pack uq0 = autodiff::where_greater(nq, tiny, q[0] / nq, Pack{} + 1.0),
               uq1 = autodiff::where_greater(nq, tiny, q[1] / nq);
    Pack a = c.mu + f1 + f2 * np * np, b = c.mu - f1 + f2 * nq * nq, m = -f2 * np * nq;
    clamp_symmetric(a, b, m);
    // On p and on q perpendicular to their directions.
    const Pack beside_p = autodiff::max_of(c.mu + f1, Pack{}), beside_q = autodiff::max_of(c.mu - f1, Pack{});
    // In the coordinates (p0, p1, q0, q1).
    SquarePack<4> h;
    h[0][0] = beside_p + (a - beside_p) * up0 * up0;
    h[0][1] = (a - beside_p) * up0 * up1;
    h[1][1] = beside_p + (a - beside_p) * up1 * up1;
    h[2][2] = beside_q + (b - beside_q) * uq0 * uq0;
    h[2][3] = (b - beside_q) * uq0 * uq1;
    h[3][3] = beside_q + (b - beside_q) * uq1 * uq1;
    h[0][2] = m * up0 * uq0;
    h[0][3] = m * up0 * uq1;
    h[1][2] = m * up1 * uq0;
    h[1][3] = m * up1 * uq1;
    for (int i = 0; i < 4; ++i)
      for (int j = 0; j < i; ++j) h[i][j] = h[j][i];
    // Back to entries: T^T h T.
    constexpr double t[4][4] = {{r, 0, 0, r}, {0, -r, r, 0}, {r, 0, 0, -r}, {0, r, r, 0}};
    SquarePack<4> ht{}, result{};
    for (int i = 0; i < 4; ++i)
      for (int j = 0; j < 4; ++j)
        for (int s = 0; s < 4; ++s)
          if (t[s][j] != 0) ht[i][j] += h[i][s] * t[s][j];
    for (int i = 0; i < 4; ++i)
      for (int j = 0; j < 4; ++j)
        for (int s = 0; s < 4; ++s)
          if (t[s][i] != 0) result[i][j] += t[s][i] * ht[s][j];
    return result;
  }
}

/// W(A) = mu/2 |A|^2 + lambda/4 (det A)^2 + (mu + lambda/2) g(det A) - (n+2) mu/2 - 3 lambda/4, g the growth.
/// Polyconvex, frame indifferent, isotropic, zero on SO(n), finite everywhere: W(I + tE) = t^2 (mu |sym E|^2 + lambda/2
/// (tr E)^2) + o(t^2). Unit: energy per volume. On tangential maps the positive part of its second derivative has a
/// closed form.
template <int Dim, class Growth>
struct ThinShellOf {
  template <class T>
  using Argument = SmallMat<T, Dim>;
  static constexpr bool is_isotropic = true;

  template <class T, class P>
  static constexpr T value(const SmallMat<T, Dim>& a, const Material<P>& c) {
    const T det = determinant(a);
    return 0.5 * c.mu * squared_norm(a) + 0.25 * c.lambda * (det * det) + (c.mu + 0.5 * c.lambda) * Growth::value(det) -
           (0.5 * (Dim + 2) * c.mu + 0.75 * c.lambda);
  }

  /// Positive part of the second derivative on tangential maps, by the entries of Y.
  template <class Entries>
  static auto positive_tangent_hessian(const Entries& y, const Material<double>& c) {
    return thin_shell_tangent_hessian<Dim, Growth>(y, c);
  }
};

/// The paper's, section 3.1.
template <int Dim>
struct ThinShellDensity : ThinShellOf<Dim, ExponentialGrowth> {};

/// The same for det A >= -3, with quadratic growth below.
template <int Dim>
struct ExtrapolatedThinShellDensity : ThinShellOf<Dim, ExtrapolatedGrowth> {};

}  // namespace shellmatch
