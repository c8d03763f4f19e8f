#pragma once
/// \file

#include "energies/autodiff/compiled.h"
#include "energies/densities/bernstein.h"
#include "energies/elements/determinants.h"
#include "energies/terms/term.h"

#include <cmath>

namespace shellmatch {

/// B(x) = (1 - x)^3 / x for 0 < x < 1 and 0 beyond: twice continuously differentiable, infinite as x -> 0, NaN for x <=
/// 0.
struct BarrierDensity {
  template <class T, class P>
  static constexpr T value(const T& x, const Material<P>&) {
    using autodiff::max_of;
    using std::sqrt;
    const T root = sqrt(x);  // NaN for x < 0
    const T gap = max_of(1.0 - x, T(0.0));
    return gap * gap * gap / (root * root);
  }
};

/// A barrier that keeps det Dphi positive throughout every cell: kappa / sqrt(nu) times the mean of B(b / d0) over the
/// Bernstein coefficients b of det Dphi (energies/densities/bernstein.h). What it certifies at the coefficients holds
/// at every point and in every part of the cell. Its weight grows as the match term's does, more slowly: with a
/// constant one either steps crawl along det Dphi = 0 on fine levels or landmarks cannot turn a limb on coarse ones.
template <int Dim>
struct FoldBarrier : CornerTerm<Dim> {
  static constexpr TermInfo info{.name = "barrier",
                                 .meaning = "barrier on the Bernstein coefficients of det Dphi",
                                 .weight = {"fold_barrier",
                                            0.5,
                                            {.unit = "energy/volume sqrt(length^2/energy)",
                                             .min = 0,
                                             .meaning = "kappa: kappa / sqrt(nu) is the weight of the barrier that "
                                                        "keeps det Dphi > 0 throughout every cell; 0 switches it off"}},
                                 .scaled = [](double factor, const TermScales& s) { return factor / std::sqrt(s.nu); },
                                 .forbids_folds = true};
  static constexpr std::array<TermOption, 1> own{
      {{"fold_threshold",
        0.2,
        {.min = 0,
         .max = 0.9,
         .min_excluded = true,
         .meaning = "d0: the barrier acts on cells where a Bernstein coefficient of det Dphi is below this"}}}};
  static constexpr int n_arguments = n_bernstein_total<Dim>;
  using Density = BarrierDensity;

  /// What the coefficients of det(d phi/d xi) are multiplied by: 1 / (d0 side^Dim).
  template <class V>
  static V scale(const V& inverse_side, const Material<double>& c) {
    V s = V{} + 1.0 / c.own[0];
    for (int k = 0; k < Dim; ++k) s *= inverse_side;
    return s;
  }

  template <class T, class P>
  constexpr std::array<T, n_arguments> operator()(const T* corners, const P& factor) const {
    std::array<T, n_arguments> x = bernstein_determinant<Dim>(corners);
    for (T& coefficient : x) coefficient = coefficient * factor;
    return x;
  }

  /// Not 0 in the lanes of elements on which the term does not vanish, at a small part of its cost: most elements are
  /// far from folding.
  static autodiff::Pack may_act(const ElementBatch<Dim>& batch, const Material<double>& c) {
    using autodiff::Pack;
    const Pack is_near = determinant_bound(batch) > c.own[0] ? Pack{} : Pack{} + 1.0;
    if (autodiff::sum_lanes(is_near) == 0) return Pack{};
    const Pack passive = scale(batch.inverse_side, c);
    return autodiff::Compiled<Gap>::value(batch.u.data(), &passive);
  }

 private:
  /// By how much coefficients lie below 1, without roots and divisions. NaN where one of them is.
  struct Gap {
    static constexpr int n_active = n_corners<Dim> * Dim, n_passive = 1;
    template <class T, class P>
    static constexpr T evaluate(const T* active, const P* passive) {
      using autodiff::max_of;
      T gaps(0.0), sum(0.0);
      for (const T& x : FoldBarrier{}(active, passive[0])) {
        gaps = gaps + max_of(1.0 - x, T(0.0));  // 0 for NaN
        sum = sum + x;
      }
      return gaps + (sum - sum);
    }
  };
};

}  // namespace shellmatch
