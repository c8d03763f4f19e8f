#pragma once
/// \file
/// ceres::Jet as a scalar of the energies: what Ceres' own automatic differentiation needs besides the standard
/// functions.

#include <ceres/jet.h>

namespace shellmatch::autodiff {

template <class T>
const T& scalar_part(const T& x) {
  return x;
}
template <class T, int N>
const T& scalar_part(const ceres::Jet<T, N>& x) {
  return x.a;
}

}  // namespace shellmatch::autodiff

namespace ceres {

/// Found by argument-dependent look-up from the energies.
template <class T, int N>
Jet<T, N> max_of(const Jet<T, N>& x, const Jet<T, N>& y) {
  return x.a > y.a ? x : y;
}

}  // namespace ceres
