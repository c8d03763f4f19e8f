#pragma once
/// \file
/// Nodal fields as arrays of doubles: n components per node, node by node.

#include "base/types.h"

#include <array>
#include <span>
#include <vector>

namespace shellmatch {

/// The upper triangle of a symmetric matrix by rows: xx, xy, yy or xx, xy, xz, yy, yz, zz.
template <int Dim>
using SymmetricComponents = std::array<double, Dim*(Dim + 1) / 2>;

template <int Dim>
SymmetricComponents<Dim> pack_symmetric(const Mat<Dim>& a) {
  SymmetricComponents<Dim> s;
  for (int i = 0, n = 0; i < Dim; ++i)
    for (int j = i; j < Dim; ++j) s[n++] = 0.5 * (a(i, j) + a(j, i));
  return s;
}

template <int Dim>
Mat<Dim> unpack_symmetric(const SymmetricComponents<Dim>& s) {
  Mat<Dim> a;
  for (int i = 0, n = 0; i < Dim; ++i)
    for (int j = i; j < Dim; ++j, ++n) a(i, j) = a(j, i) = s[n];
  return a;
}

/// A view of a field as doubles. T consists of doubles only: double, Vec or std::array.
template <class T>
std::span<double> components_of(std::vector<T>& field) {
  static_assert(sizeof(T) % sizeof(double) == 0 && alignof(T) % alignof(double) == 0);
  return {reinterpret_cast<double*>(field.data()), field.size() * (sizeof(T) / sizeof(double))};
}

template <class T>
std::span<const double> components_of(const std::vector<T>& field) {
  return components_of(const_cast<std::vector<T>&>(field));
}

}  // namespace shellmatch
