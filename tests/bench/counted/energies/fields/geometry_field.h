#pragma once
/// \file
/// Stands in the place of the real energies/fields/geometry_field.h when tests/bench/count_flops compiles the energies:
/// the real one makes whole packs of the numbers of one point, which a Pack of one lane cannot hold. Here a
/// shape is functions, and tests/bench/count_flops counts the look-up by hand.

#include "energies/autodiff/pack.h"
#include "energies/fields/coefficients.h"
#include "grid/octree/octree.h"

#include <array>
#include <functional>

namespace shellmatch {

template <int Dim>
class GeometryField {
 public:
  static constexpr int n_values = TargetPoint<Dim, double>::size;
  using Values = std::array<double, n_values>;
  using Pack = autodiff::Pack;
  using Packs = std::array<Pack, n_values>;

  explicit GeometryField(std::function<Values(const Vec<Dim>&)> values) : values_(std::move(values)) {}

  Values value(const Vec<Dim>& y) const { return values_(y); }

  Values value(const Vec<Dim>& y, std::array<Values, Dim>& derivative) const {
    constexpr double step = 1e-5;
    for (int k = 0; k < Dim; ++k) {
      const Values above = values_(y + step * Vec<Dim>::Unit(k)), below = values_(y - step * Vec<Dim>::Unit(k));
      for (int i = 0; i < n_values; ++i) derivative[k][i] = (above[i] - below[i]) / (2 * step);
    }
    return values_(y);
  }

  using LocatedPoints = std::array<Pack, Dim>;
  LocatedPoints find(const std::array<Pack, Dim>& y) const { return y; }
  void look_up(const Pack&, const LocatedPoints& y, Pack* values) const {
    const Values v = values_(place(y));
    for (int i = 0; i < n_values; ++i) values[i][0] = v[i];
  }
  void look_up(const Pack&, const LocatedPoints& y, Pack* values, std::array<Packs, Dim>& derivative) const {
    std::array<Values, Dim> d;
    const Values v = value(place(y), d);
    for (int i = 0; i < n_values; ++i) values[i][0] = v[i];
    for (int k = 0; k < Dim; ++k)
      for (int i = 0; i < n_values; ++i) derivative[k][i][0] = d[k][i];
  }

  template <class T>
  TargetPoint<Dim, T> at(const SmallVec<T, Dim>& y) const {
    Vec<Dim> x;
    for (int k = 0; k < Dim; ++k) x[k] = autodiff::scalar_part(y[k]);
    std::array<Values, Dim> d;
    const Values v = value(x, d);
    std::array<T, n_values> sum;
    for (int i = 0; i < n_values; ++i) {
      sum[i] = T(v[i]);
      for (int k = 0; k < Dim; ++k) sum[i] += d[k][i] * (y[k] - x[k]);
    }
    TargetPoint<Dim, T> p;
    p.d2 = sum[0];
    for (int i = 0; i < Dim; ++i) p.n2[i] = sum[1 + i];
    for (int i = 0; i < n_symmetric<Dim>; ++i) p.root.v[i] = sum[1 + Dim + i];
    return p;
  }

 private:
  static Vec<Dim> place(const std::array<Pack, Dim>& y) {
    Vec<Dim> x;
    for (int k = 0; k < Dim; ++k) x[k] = y[k][0];
    return x;
  }
  std::function<Values(const Vec<Dim>&)> values_;
};

template <int Dim>
struct GeometryPair {
  GeometryField<Dim> reference, target;
  bool root_is_inverse;
};

}  // namespace shellmatch
