#pragma once
/// \file
/// Second derivative of W in tangent frames, made positive semidefinite in closed form, eight points at a time.
///
/// In orthonormal frames of both tangent spaces the argument of W is a matrix Y of one row and column less beside a
/// 1, so that W = mu/2 |Y|^2 + f(det Y) + constant.

#include "energies/autodiff/pack.h"
#include "energies/densities/densities.h"

#include <array>

namespace shellmatch {

using autodiff::Pack;

/// Orthonormal basis of the plane (line) perpendicular to a unit vector; with the vector itself last, of one
/// handedness everywhere. Duff et al., 'Building an orthonormal basis, revisited', JCGT 6(1), 2017.
template <int Dim>
std::array<std::array<Pack, Dim>, Dim - 1> tangent_basis(const std::array<Pack, Dim>& n) {
  if constexpr (Dim == 2) {
    return {{{n[1], -n[0]}}};
  } else {
    const Pack one = Pack{} + 1.0;
    const Pack sign = n[2] >= 0 ? one : -one;
    const Pack a = -1.0 / (sign + n[2]);
    const Pack b = n[0] * n[1] * a;
    return {{{1.0 + sign * n[0] * n[0] * a, sign * b, -sign * n[0]}, {b, sign + n[1] * n[1] * a, -n[1]}}};
  }
}

/// Positive semidefinite part of [[a, c], [c, b]], in place.
inline void clamp_symmetric(Pack& a, Pack& b, Pack& c) {
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

/// Positive semidefinite second derivative of W at Y, by the entries of Y in row order. One number in the plane.
template <int Dim>
std::array<std::array<Pack, (Dim - 1) * (Dim - 1)>, (Dim - 1) * (Dim - 1)> tangent_hessian(
    const std::array<Pack, (Dim - 1) * (Dim - 1)>& y, const Lame<double>& c) {
  const double k = c.mu + 0.5 * c.lambda;
  if constexpr (Dim == 2) {
    return {{{c.mu + 0.5 * c.lambda + k * autodiff::exp_of(1.0 - y[0])}}};
  } else {
    const Pack det = y[0] * y[3] - y[1] * y[2];
    const Pack e = autodiff::exp_of(1.0 - det);
    const Pack f1 = 0.5 * c.lambda * det - k * e, f2 = 0.5 * c.lambda + k * e;
    // Conformal part p and anticonformal part q: det Y = (|p|^2 - |q|^2) / 2, so the second derivative of f(det)
    // is f' on p, -f' on q, plus f'' (p, -q)(p, -q)^T.
    constexpr double r = 0.70710678118654752440;
    std::array<Pack, 2> p = {r * (y[0] + y[3]), r * (y[2] - y[1])}, q = {r * (y[0] - y[3]), r * (y[1] + y[2])};
    const Pack tiny = Pack{} + 1e-150;
    const Pack np = autodiff::max_of(autodiff::root_of(p[0] * p[0] + p[1] * p[1]), tiny);
    const Pack nq = autodiff::max_of(autodiff::root_of(q[0] * q[0] + q[1] * q[1]), tiny);
    // Directions; where a part vanishes any will do.
    const Pack up0 = np > tiny ? p[0] / np : Pack{} + 1.0, up1 = np > tiny ? p[1] / np : Pack{};
    const Pack uq0 = nq > tiny ? q[0] / nq : Pack{} + 1.0, uq1 = nq > tiny ? q[1] / nq : Pack{};
    Pack a = c.mu + f1 + f2 * np * np, b = c.mu - f1 + f2 * nq * nq, m = -f2 * np * nq;
    clamp_symmetric(a, b, m);
    const Pack across_p = autodiff::max_of(c.mu + f1, Pack{}), across_q = autodiff::max_of(c.mu - f1, Pack{});
    // In the coordinates (p0, p1, q0, q1).
    std::array<std::array<Pack, 4>, 4> h;
    h[0][0] = across_p + (a - across_p) * up0 * up0;
    h[0][1] = (a - across_p) * up0 * up1;
    h[1][1] = across_p + (a - across_p) * up1 * up1;
    h[2][2] = across_q + (b - across_q) * uq0 * uq0;
    h[2][3] = (b - across_q) * uq0 * uq1;
    h[3][3] = across_q + (b - across_q) * uq1 * uq1;
    h[0][2] = m * up0 * uq0;
    h[0][3] = m * up0 * uq1;
    h[1][2] = m * up1 * uq0;
    h[1][3] = m * up1 * uq1;
    for (int i = 0; i < 4; ++i)
      for (int j = 0; j < i; ++j) h[i][j] = h[j][i];
    // Back to entries: T^T h T.
    constexpr double t[4][4] = {{r, 0, 0, r}, {0, -r, r, 0}, {r, 0, 0, -r}, {0, r, r, 0}};
    std::array<std::array<Pack, 4>, 4> ht{}, result{};
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

/// Factor L with L L^T = h, h positive semidefinite but for rounding. A column whose pivot is below 1e-8 of the
/// trace is left out: what is left of it is at most 1e-4 of the trace by Cauchy and Schwarz, and divided by such a
/// pivot rounding would come out as stiffness.
template <int M>
std::array<std::array<Pack, M>, M> cholesky(const std::array<std::array<Pack, M>, M>& h) {
  Pack trace{};
  for (int i = 0; i < M; ++i) trace += h[i][i];
  const Pack floor = 1e-8 * trace + 1e-300;
  std::array<std::array<Pack, M>, M> l{};
  for (int j = 0; j < M; ++j) {
    Pack d = h[j][j];
    for (int s = 0; s < j; ++s) d -= l[j][s] * l[j][s];
    const Pack root = autodiff::root_of(autodiff::max_of(d, floor));
    const Pack inverse = d > floor ? 1.0 / root : Pack{};
    l[j][j] = d * inverse;
    for (int i = j + 1; i < M; ++i) {
      Pack v = h[i][j];
      for (int s = 0; s < j; ++s) v -= l[i][s] * l[j][s];
      l[i][j] = v * inverse;
    }
  }
  return l;
}

}  // namespace shellmatch
