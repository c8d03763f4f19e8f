#pragma once
/// \file
/// ceres::Jet as a scalar of the energies: the functions that Ceres' automatic differentiation needs besides the
/// standard ones.

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

/// In namespace ceres, so that argument-dependent lookup finds it.
template <class T, int N>
Jet<T, N> max_of(const Jet<T, N>& x, const Jet<T, N>& y) {
  return x.a > y.a ? x : y;
}

}  // namespace ceres
