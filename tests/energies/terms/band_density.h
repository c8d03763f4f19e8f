#pragma once
/// \file
/// Argument and value of a band term at one point, from its fields.

#include "energies/terms/term_functors.h"

namespace shellmatch {

template <class Term, class T, class P>
constexpr auto whole_argument(const TargetPoint<Term::dim, T>& y, const SmallMat<T, Term::dim>& dphi,
                              const ReferencePoint<Term::dim, P>& x, const Material<P>& c) {
  return argument_at<Term>(PointValues<Term::dim, T, P>{.phi = {}, .dphi = dphi, .y = y, .x = x, .material = c});
}

template <class Term, class T, class P>
constexpr T band_density(const TargetPoint<Term::dim, T>& y, const SmallMat<T, Term::dim>& dphi,
                         const ReferencePoint<Term::dim, P>& x, const Material<P>& c) {
  return Term::Density::template value<T, P>(whole_argument<Term>(y, dphi, x, c), c);
}

}  // namespace shellmatch
