#pragma once
/// \file
/// A scalar with its first and second derivatives by N variables, where a small Hessian is needed at a point: one
/// evaluation of the functor gives it. `V` is double or Pack.

#include "energies/autodiff/pack.h"

#include <array>

namespace shellmatch::autodiff {

template <int N, class V = double>
struct SecondOrder {
  V v{};
  std::array<V, N> g{};
  std::array<V, N*(N + 1) / 2> upper{};  ///< upper triangle of the symmetric second derivative, row by row

  SecondOrder() = default;
  SecondOrder(double c) : v(V{} + c) {}  // NOLINT(google-explicit-constructor): constants mix with variables
  /// The variable number i with value c.
  static SecondOrder variable(V c, int i) {
    SecondOrder r;
    r.v = c;
    r.g[i] = V{} + 1.0;
    return r;
  }
  /// Second derivative by variables i and j.
  V h(int i, int j) const { return i <= j ? upper[i * N - i * (i - 1) / 2 + j - i] : h(j, i); }

  /// f(x), given f, f' and f'' at x.v.
  static SecondOrder chain(const SecondOrder& x, V f, V f1, V f2) {
    SecondOrder r;
    r.v = f;
    for (int i = 0, at = 0; i < N; ++i) {
      r.g[i] = f1 * x.g[i];
      for (int j = i; j < N; ++j, ++at) r.upper[at] = f1 * x.upper[at] + f2 * (x.g[i] * x.g[j]);
    }
    return r;
  }
  friend SecondOrder operator-(const SecondOrder& x) { return chain(x, -x.v, V{} - 1.0, V{}); }
  friend SecondOrder operator+(SecondOrder x, const SecondOrder& y) {
    x.v += y.v;
    for (int i = 0; i < N; ++i) x.g[i] += y.g[i];
    for (std::size_t i = 0; i < x.upper.size(); ++i) x.upper[i] += y.upper[i];
    return x;
  }
  friend SecondOrder operator-(const SecondOrder& x, const SecondOrder& y) { return x + (-y); }
  friend SecondOrder operator*(const SecondOrder& x, const SecondOrder& y) {
    SecondOrder r;
    r.v = x.v * y.v;
    for (int i = 0, at = 0; i < N; ++i) {
      r.g[i] = x.v * y.g[i] + y.v * x.g[i];
      for (int j = i; j < N; ++j, ++at)
        r.upper[at] = x.v * y.upper[at] + y.v * x.upper[at] + x.g[i] * y.g[j] + y.g[i] * x.g[j];
    }
    return r;
  }
  friend SecondOrder operator/(const SecondOrder& x, const SecondOrder& y) {
    const V i = 1.0 / y.v;
    return x * chain(y, i, -i * i, 2.0 * i * i * i);
  }
  friend SecondOrder sqrt(const SecondOrder& x) {
    const V r = root_of(x.v);
    return chain(x, r, 0.5 / r, -0.25 / (r * x.v));
  }
  friend SecondOrder exp(const SecondOrder& x) {
    const V e = exp_of(x.v);
    return chain(x, e, e, e);
  }
  friend SecondOrder log(const SecondOrder& x) {
    const V i = 1.0 / x.v;
    return chain(x, log_of(x.v), i, -i * i);
  }
  friend SecondOrder pow(const SecondOrder& x, double c) {
    return chain(x, pow_of(x.v, c), c * pow_of(x.v, c - 1), c * (c - 1) * pow_of(x.v, c - 2));
  }
  /// The larger one with its derivatives, by lane where V is a Pack; y where they are equal.
  friend SecondOrder max_of(const SecondOrder& x, const SecondOrder& y) {
    SecondOrder r;
    r.v = max_of(x.v, y.v);
    for (int i = 0; i < N; ++i) r.g[i] = x.v > y.v ? x.g[i] : y.g[i];
    for (std::size_t i = 0; i < r.upper.size(); ++i) r.upper[i] = x.v > y.v ? x.upper[i] : y.upper[i];
    return r;
  }
};

}  // namespace shellmatch::autodiff
