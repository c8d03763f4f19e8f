#pragma once
/// \file
/// The least squares problem of one neighbourhood, for grid/fits/local_fit.h.

#include "grid/octree/nodal_values.h"

#include <array>
#include <cmath>

namespace shellmatch {

/// Normal equations of the fit of quadratics, with basis 1, x_i, x_i x_j, to the values of `Fields` functions
/// at the same points. Coordinates should be of order 1. Uses plain aligned arrays instead of Eigen's
/// matrices, whose order of summation depends on the address of the data, so that rounding would differ from
/// one thread's stack to another's.
template <int Dim, int Fields>
class QuadraticFit {
 public:
  static constexpr int n_unknowns = 1 + Dim + Dim * (Dim + 1) / 2;

  void add(const Vec<Dim>& x, const std::array<double, Fields>& values, double weight) {
    const Vector a = monomials(x);
    for (int i = 0; i < n; ++i) {
      const double weighted = weight * a.v[i];
      for (int j = 0; j < n; ++j) matrix_[i].v[j] += weighted * a.v[j];
      for (int f = 0; f < Fields; ++f) right_sides_[f].v[i] += weighted * values[f];
    }
  }

  /// Cholesky factorisation in place. Returns false where the points do not determine a quadratic well, that
  /// is where the squared norm of a monomial's component orthogonal to the previous monomials is below 1e-4
  /// of its squared norm. For regular neighbourhoods the ratio exceeds 1e-3; for degenerate ones it is about
  /// 1e-16.
  bool factorise() {
    constexpr double smallest_share = 1e-4;
    for (int i = 0; i < n; ++i) {
      const double whole = matrix_[i].v[i];
      for (int j = 0; j <= i; ++j) {
        double sum = matrix_[i].v[j];
        for (int k = 0; k < j; ++k) sum -= matrix_[i].v[k] * matrix_[j].v[k];
        matrix_[i].v[j] = i == j ? sum : sum / matrix_[j].v[j];
      }
      if (!(matrix_[i].v[i] > smallest_share * whole)) return false;
      matrix_[i].v[i] = std::sqrt(matrix_[i].v[i]);
    }
    return true;
  }

  /// Second derivatives of the fitted quadratic of a field. \pre factorise() returned true
  SymmetricComponents<Dim> hessian(int field) const {
    Vector c = right_sides_[field];
    for (int i = 0; i < n; ++i) {
      for (int k = 0; k < i; ++k) c.v[i] -= matrix_[i].v[k] * c.v[k];
      c.v[i] /= matrix_[i].v[i];
    }
    for (int i = n - 1; i >= 0; --i) {
      for (int k = i + 1; k < n; ++k) c.v[i] -= matrix_[k].v[i] * c.v[k];
      c.v[i] /= matrix_[i].v[i];
    }
    SymmetricComponents<Dim> s;
    for (int i = 0, m = 0; i < Dim; ++i)
      for (int j = i; j < Dim; ++j, ++m) s[m] = (i == j ? 2 : 1) * c.v[1 + Dim + m];
    return s;
  }

 private:
  static constexpr int n = n_unknowns;
  struct alignas(64) Vector {
    double v[(n + 7) / 8 * 8] = {};
  };

  static Vector monomials(const Vec<Dim>& x) {
    Vector a;
    a.v[0] = 1;
    for (int i = 0, m = 1 + Dim; i < Dim; ++i) {
      a.v[1 + i] = x[i];
      for (int j = i; j < Dim; ++j) a.v[m++] = x[i] * x[j];
    }
    return a;
  }

  std::array<Vector, n> matrix_;
  std::array<Vector, Fields> right_sides_;
};

}  // namespace shellmatch
