#pragma once
/// \file
/// A scalar that carries its first and second derivatives by N variables, for the few places where a small
/// Hessian is wanted at a point: one evaluation of the functor gives it.

#include <Eigen/Core>

#include <cmath>

namespace shellmatch::autodiff {

template <int N>
struct SecondOrder {
  double v = 0;
  Eigen::Matrix<double, N, 1> g = Eigen::Matrix<double, N, 1>::Zero();
  Eigen::Matrix<double, N, N> h = Eigen::Matrix<double, N, N>::Zero();

  SecondOrder() = default;
  SecondOrder(double c) : v(c) {}  // NOLINT(google-explicit-constructor): constants mix with variables
  /// Variable number i.
  SecondOrder(double c, int i) : v(c) { g[i] = 1; }

  /// f(x), given f, f' and f'' at x.v.
  static SecondOrder chain(const SecondOrder& x, double f, double f1, double f2) {
    SecondOrder r(f);
    r.g = f1 * x.g;
    r.h = f1 * x.h + f2 * x.g * x.g.transpose();
    return r;
  }
  friend SecondOrder operator-(const SecondOrder& x) { return chain(x, -x.v, -1, 0); }
  friend SecondOrder operator+(SecondOrder x, const SecondOrder& y) {
    x.v += y.v;
    x.g += y.g;
    x.h += y.h;
    return x;
  }
  friend SecondOrder operator-(const SecondOrder& x, const SecondOrder& y) { return x + (-y); }
  friend SecondOrder operator*(const SecondOrder& x, const SecondOrder& y) {
    SecondOrder r(x.v * y.v);
    r.g = x.v * y.g + y.v * x.g;
    r.h = x.v * y.h + y.v * x.h + x.g * y.g.transpose() + y.g * x.g.transpose();
    return r;
  }
  friend SecondOrder operator/(const SecondOrder& x, const SecondOrder& y) {
    const double i = 1 / y.v;
    return x * chain(y, i, -i * i, 2 * i * i * i);
  }
  friend SecondOrder sqrt(const SecondOrder& x) {
    const double r = std::sqrt(x.v);
    return chain(x, r, 0.5 / r, -0.25 / (r * x.v));
  }
  friend SecondOrder exp(const SecondOrder& x) {
    const double e = std::exp(x.v);
    return chain(x, e, e, e);
  }
};

}  // namespace shellmatch::autodiff
