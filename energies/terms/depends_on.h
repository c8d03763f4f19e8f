#pragma once
/// \file
/// The fields that a term reads at a point x of the domain, by name. A term lists them once, in the order of its
/// functor's arguments: `using Reads = DependsOn<Dphi, TargetNormal, ReferenceNormal>`.

#include "energies/densities/material.h"
#include "energies/fields/coefficients.h"

#include <algorithm>
#include <type_traits>

namespace shellmatch {

/// All that can be read at x, over the scalars T of what depends on phi and P of what does not.
template <int Dim, class T, class P>
struct PointValues {
  using Passive = P;
  SmallVec<T, Dim> phi;
  SmallMat<T, Dim> dphi;
  TargetPoint<Dim, T> y;
  ReferencePoint<Dim, P> x;
  Material<P> material;
  const P* own_fields = nullptr;  ///< the components of the term's own fields, field after field
};

struct Phi {
  static constexpr const auto& of(const auto& at) { return at.phi; }
};
struct Dphi {
  static constexpr const auto& of(const auto& at) { return at.dphi; }
};
struct TargetDistance {  ///< d2 at phi(x)
  static constexpr const auto& of(const auto& at) { return at.y.d2; }
};
struct TargetNormal {  ///< n2 as it is interpolated: renormalised() makes it a unit vector
  static constexpr const auto& of(const auto& at) { return at.y.n2; }
};
struct TargetRoot {  ///< C(S2)^{1/2}
  static constexpr const auto& of(const auto& at) { return at.y.root; }
};
struct TargetShapeOperator {  ///< S2
  static constexpr const auto& of(const auto& at) { return at.y.root; }
};
struct ReferenceDistance {  ///< d1 at x
  static constexpr const auto& of(const auto& at) { return at.x.d1; }
};
struct ReferenceNormal {  ///< n1, a unit vector
  static constexpr const auto& of(const auto& at) { return at.x.n1; }
};
struct ReferenceRoot {  ///< P1 C(S1)^{-1/2} P1
  static constexpr const auto& of(const auto& at) { return at.x.r1; }
};
struct ReferenceShapeOperator {  ///< S1
  static constexpr const auto& of(const auto& at) { return at.x.r1; }
};
struct OwnOptions {  ///< a pointer to the values of the term's own options, in their order
  static constexpr auto of(const auto& at) { return at.material.own; }
};

/// Base of a field of the user's own, with N components, which the functor gets as SmallVec<P, N>. Its values are given
/// with the term (energies/cost/element_fields.h).
template <int N>
struct OwnField {
  static constexpr int n_components = N;
};

template <class Field>
inline constexpr int n_components_of = 0;  ///< of a field that is not the user's own
template <class Field>
requires requires { Field::n_components; }
inline constexpr int n_components_of<Field> = Field::n_components;

template <class... Field>
struct DependsOn {
  template <class One>
  static constexpr bool has_one = (std::is_same_v<Field, One> || ...);
  template <class... One>
  static constexpr bool has = (has_one<One> || ...);
  static constexpr bool has_curvature = has<TargetRoot, TargetShapeOperator, ReferenceRoot, ReferenceShapeOperator>;
  static constexpr bool has_shape_operators = has<TargetShapeOperator, ReferenceShapeOperator>;
  static constexpr bool has_target = has<TargetDistance, TargetNormal, TargetRoot, TargetShapeOperator>;
  static constexpr bool has_reference = has<ReferenceDistance, ReferenceNormal, ReferenceRoot, ReferenceShapeOperator>;
  /// Components of the user's own fields together.
  static constexpr int n_own = (n_components_of<Field> + ... + 0);

  /// The functor of its fields.
  template <class Functor, class Point>
  static constexpr auto call(const Functor& functor, const Point& at) {
    return functor(value_of<Field>(at)...);
  }

 private:
  template <class One>
  static constexpr int first_component() {
    int first = 0;
    bool is_found = false;
    ((is_found = is_found || std::is_same_v<Field, One>, first += is_found ? 0 : n_components_of<Field>), ...);
    return first;
  }
  template <class One, class Point>
  static constexpr decltype(auto) value_of(const Point& at) {
    if constexpr (constexpr int n = n_components_of<One>; n > 0) {
      SmallVec<typename Point::Passive, n> value;
      std::copy_n(at.own_fields + first_component<One>(), n, value.v.begin());
      return value;
    } else {
      return One::of(at);
    }
  }
};

}  // namespace shellmatch
