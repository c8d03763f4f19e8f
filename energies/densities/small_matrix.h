#pragma once
/// \file
/// Vectors and matrices of 2 or 3 rows over any scalar, usable at compile time. The energies are written with
/// these and not with Eigen, because the same functor runs on numbers, on ceres::Jet and on the recording
/// scalar of energies/autodiff/expression.h during compilation.

#include <array>

namespace shellmatch {

/// Number of independent entries of a symmetric matrix: 3 in the plane, 6 in space.
template <int Dim>
inline constexpr int n_symmetric = Dim*(Dim + 1) / 2;

template <class T, int Dim>
struct SmallVec {
  static constexpr int size = Dim;
  std::array<T, Dim> v{};
  constexpr T& operator[](int i) { return v[i]; }
  constexpr const T& operator[](int i) const { return v[i]; }
};

template <class T, int Dim>
struct SmallMat {
  static constexpr int size = Dim * Dim;
  std::array<T, Dim * Dim> v{};
  constexpr T& operator()(int i, int j) { return v[i * Dim + j]; }
  constexpr const T& operator()(int i, int j) const { return v[i * Dim + j]; }
};

/// Symmetric matrix, upper triangle by rows: xx, xy, xz, yy, yz, zz (plane: xx, xy, yy).
template <class T, int Dim>
struct SmallSym {
  std::array<T, n_symmetric<Dim>> v{};
  static constexpr int slot(int i, int j) {
    const int a = i < j ? i : j, b = i < j ? j : i;
    return a * Dim - a * (a - 1) / 2 + (b - a);
  }
  constexpr const T& operator()(int i, int j) const { return v[slot(i, j)]; }
};

template <class T, class S, int Dim>
constexpr auto dot(const SmallVec<T, Dim>& a, const SmallVec<S, Dim>& b) {
  auto s = a[0] * b[0];
  for (int i = 1; i < Dim; ++i) s = s + a[i] * b[i];
  return s;
}

/// A^T u.
template <class T, class S, int Dim>
constexpr auto transposed_times(const SmallMat<T, Dim>& a, const SmallVec<S, Dim>& u) {
  SmallVec<decltype(a(0, 0) * u[0]), Dim> r;
  for (int j = 0; j < Dim; ++j) {
    auto s = a(0, j) * u[0];
    for (int i = 1; i < Dim; ++i) s = s + a(i, j) * u[i];
    r[j] = s;
  }
  return r;
}

/// A u.
template <class M, class S, int Dim>
constexpr auto times(const M& a, const SmallVec<S, Dim>& u) {
  SmallVec<decltype(a(0, 0) * u[0]), Dim> r;
  for (int i = 0; i < Dim; ++i) {
    auto s = a(i, 0) * u[0];
    for (int j = 1; j < Dim; ++j) s = s + a(i, j) * u[j];
    r[i] = s;
  }
  return r;
}

/// A B, where either may be symmetric or full; Dim is named by the caller.
template <int Dim, class A, class B>
constexpr auto product(const A& a, const B& b) {
  SmallMat<decltype(a(0, 0) * b(0, 0)), Dim> r;
  for (int i = 0; i < Dim; ++i)
    for (int j = 0; j < Dim; ++j) {
      auto s = a(i, 0) * b(0, j);
      for (int k = 1; k < Dim; ++k) s = s + a(i, k) * b(k, j);
      r(i, j) = s;
    }
  return r;
}

/// A + u w^T.
template <class T, class S, class R, int Dim>
constexpr auto plus_outer(SmallMat<T, Dim> a, const SmallVec<S, Dim>& u, const SmallVec<R, Dim>& w) {
  for (int i = 0; i < Dim; ++i)
    for (int j = 0; j < Dim; ++j) a(i, j) = a(i, j) + u[i] * w[j];
  return a;
}

/// P(e) A = A - e (e^T A), for a unit vector e.
template <class T, class S, int Dim>
constexpr auto project_rows(SmallMat<T, Dim> a, const SmallVec<S, Dim>& e) {
  const auto t = transposed_times(a, e);
  for (int i = 0; i < Dim; ++i)
    for (int j = 0; j < Dim; ++j) a(i, j) = a(i, j) - e[i] * t[j];
  return a;
}

/// A P(e) = A - (A e) e^T, for a unit vector e.
template <class T, class S, int Dim>
constexpr auto project_columns(SmallMat<T, Dim> a, const SmallVec<S, Dim>& e) {
  const auto t = times(a, e);
  for (int i = 0; i < Dim; ++i)
    for (int j = 0; j < Dim; ++j) a(i, j) = a(i, j) - t[i] * e[j];
  return a;
}

/// Squared Frobenius norm.
template <class T, int Dim>
constexpr T squared_norm(const SmallMat<T, Dim>& a) {
  T s = a.v[0] * a.v[0];
  for (int i = 1; i < Dim * Dim; ++i) s = s + a.v[i] * a.v[i];
  return s;
}

/// Cofactor matrix, det(A) A^{-T}.
template <class T, int Dim>
constexpr SmallMat<T, Dim> cofactor(const SmallMat<T, Dim>& a) {
  SmallMat<T, Dim> c;
  if constexpr (Dim == 2) {
    c(0, 0) = a(1, 1);
    c(0, 1) = -a(1, 0);
    c(1, 0) = -a(0, 1);
    c(1, 1) = a(0, 0);
  } else {
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j) {
        const int p = (i + 1) % 3, q = (i + 2) % 3, r = (j + 1) % 3, s = (j + 2) % 3;
        c(i, j) = a(p, r) * a(q, s) - a(p, s) * a(q, r);
      }
  }
  return c;
}

template <class T, int Dim>
constexpr T determinant(const SmallMat<T, Dim>& a) {
  if constexpr (Dim == 2) {
    return a(0, 0) * a(1, 1) - a(0, 1) * a(1, 0);
  } else {
    T s = a(0, 0) * (a(1, 1) * a(2, 2) - a(1, 2) * a(2, 1));
    s = s + a(0, 1) * (a(1, 2) * a(2, 0) - a(1, 0) * a(2, 2));
    return s + a(0, 2) * (a(1, 0) * a(2, 1) - a(1, 1) * a(2, 0));
  }
}

}  // namespace shellmatch
