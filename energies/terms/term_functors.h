#pragma once
/// \file
/// A term as functors of flat arrays, for recording (energies/autodiff/expression.h): its value, its argument, and its
/// argument in tangent frames.

#include "energies/terms/term.h"

#include <array>
#include <concepts>
#include <cstddef>
#include <utility>

namespace shellmatch {

template <class T>
concept IsBandTerm = std::derived_from<T, BandTerm<T::dim>>;
template <class T>
concept IsCellTerm = std::derived_from<T, CellTerm<T::dim>>;
template <class T>
concept IsCornerTerm = std::derived_from<T, CornerTerm<T::dim>>;

/// The whole argument of a band term: tangential ones are completed by n2 n1^T.
template <class Term, class T, class P>
constexpr auto whole_argument(const TargetPoint<Term::dim, T>& y, const SmallMat<T, Term::dim>& dphi,
                              const ReferencePoint<Term::dim, P>& x, const Material<P>& c) {
  if constexpr (Term::is_tangential)
    return plus_outer(Term::template argument<T, P>(y, dphi, x, c), renormalised(y.n2), x.n1);
  else
    return Term::template argument<T, P>(y, dphi, x, c);
}

/// Value of a band term at one point.
template <class Term, class T, class P>
constexpr T band_density(const TargetPoint<Term::dim, T>& y, const SmallMat<T, Term::dim>& dphi,
                         const ReferencePoint<Term::dim, P>& x, const Material<P>& c) {
  return Term::Density::template value<T, P>(whole_argument<Term, T, P>(y, dphi, x, c), c);
}

namespace detail {

/// Active inputs: d2, n2, root, Dphi by rows. Passive inputs: d1, n1, r1, lambda, mu, the term's own options.
template <class Term>
struct BandInputs {
  static constexpr int dim = Term::dim;
  static constexpr int n_target = TargetPoint<dim, double>::size, n_reference = ReferencePoint<dim, double>::size;
  static constexpr int n_active = n_target + dim * dim;
  static constexpr int n_passive = n_reference + 2 + static_cast<int>(Term::own.size());

  template <class T, class P>
  struct Unpacked {
    TargetPoint<dim, T> y;
    SmallMat<T, dim> dphi;
    ReferencePoint<dim, P> x;
    Material<P> material;
  };
  template <class T, class P>
  static constexpr Unpacked<T, P> unpack(const T* active, const P* passive) {
    Unpacked<T, P> u;
    u.y.d2 = *active++;
    for (T& e : u.y.n2.v) e = *active++;
    for (T& e : u.y.root.v) e = *active++;
    for (T& e : u.dphi.v) e = *active++;
    u.x.d1 = *passive++;
    for (P& e : u.x.n1.v) e = *passive++;
    for (P& e : u.x.r1.v) e = *passive++;
    u.material = {passive[0], passive[1], passive + 2};
    return u;
  }
};

}  // namespace detail

/// W(A) of a band term.
template <IsBandTerm Term>
struct BandFunctor : detail::BandInputs<Term> {
  template <class T, class P>
  static constexpr T evaluate(const T* active, const P* passive) {
    const auto u = detail::BandInputs<Term>::template unpack<T, P>(active, passive);
    return band_density<Term, T, P>(u.y, u.dphi, u.x, u.material);
  }
};

/// A of a band term, entry after entry.
template <IsBandTerm Term>
struct BandArgument : detail::BandInputs<Term> {
  static constexpr int n_outputs = n_arguments_of<typename Term::Density>;
  template <class T, class P>
  static constexpr std::array<T, n_outputs> evaluate(const T* active, const P* passive) {
    const auto u = detail::BandInputs<Term>::template unpack<T, P>(active, passive);
    return whole_argument<Term, T, P>(u.y, u.dphi, u.x, u.material).v;
  }
};

/// The matrix t2_i . A t1_j of a tangential argument in frames t1, t2 of the tangent planes, by rows. Active inputs: those
/// of BandFunctor with Dphi Q in the place of Dphi, where Q has the columns t1, then n1. Further passive inputs, after those
/// of BandFunctor: t1, then t2, vector after vector.
///
/// The argument is evaluated in the reference coordinates of Q, in which t1 and n1 are unit vectors: A t1_j is then a column of
/// A Q, which depends on few entries of Dphi Q, so that the backward sweeps are a third as long as those through Dphi.
template <IsBandTerm Term>
struct TangentArgument : detail::BandInputs<Term> {
  using Inputs = detail::BandInputs<Term>;
  static constexpr int dim = Term::dim, m = dim - 1;
  static constexpr int n_passive = Inputs::n_passive + 2 * m * dim;
  static constexpr int n_outputs = m * m;
  template <class T, class P>
  static constexpr std::array<T, n_outputs> evaluate(const T* active, const P* passive) {
    const auto u = Inputs::template unpack<T, P>(active, passive);
    const P* t1 = passive + Inputs::n_passive;
    const P* t2 = t1 + m * dim;
    const auto aq = Term::template argument<T, P>(u.y, u.dphi, in_frame(u.x, t1), u.material);
    std::array<T, n_outputs> result;
    for (int j = 0; j < m; ++j)
      for (int i = 0; i < m; ++i) {
        T sum = t2[i * dim] * aq(0, j);
        for (int k = 1; k < dim; ++k) sum = sum + t2[i * dim + k] * aq(k, j);
        result[i * m + j] = sum;
      }
    return result;
  }

 private:
  /// Q^T n1 and Q^T r1 Q.
  template <class P>
  static constexpr ReferencePoint<dim, P> in_frame(const ReferencePoint<dim, P>& x, const P* t1) {
    std::array<SmallVec<P, dim>, dim> q, r1_q;
    for (int j = 0; j < m; ++j)
      for (int k = 0; k < dim; ++k) q[j][k] = t1[j * dim + k];
    q[m] = x.n1;
    for (int j = 0; j < dim; ++j) r1_q[j] = times(x.r1, q[j]);
    ReferencePoint<dim, P> there;
    there.d1 = x.d1;
    for (int i = 0; i < dim; ++i) there.n1[i] = P(i == m ? 1.0 : 0.0);
    for (int i = 0; i < dim; ++i)
      for (int j = i; j < dim; ++j) there.r1.v[SmallSym<P, dim>::slot(i, j)] = dot(q[i], r1_q[j]);
    return there;
  }
};

/// W(Dphi) of a cell term. Active: Dphi by rows; passive: lambda, mu, the term's own options.
template <IsCellTerm Term>
struct CellFunctor {
  static constexpr int n_active = Term::dim * Term::dim;
  static constexpr int n_passive = 2 + static_cast<int>(Term::own.size());
  template <class T, class P>
  static constexpr T evaluate(const T* active, const P* passive) {
    SmallMat<T, Term::dim> dphi;
    for (int i = 0; i < n_active; ++i) dphi.v[i] = active[i];
    return Term::Density::template value<T, P>(dphi, Material<P>{passive[0], passive[1], passive + 2});
  }
};

/// Mean of W over the entries of a corner term's argument. Active: the corners' positions, corner after corner; passive:
/// the term's scale, lambda, mu, its own options.
template <IsCornerTerm Term>
struct CornerFunctor {
  static constexpr int n_active = (1 << Term::dim) * Term::dim;
  static constexpr int n_passive = 3 + static_cast<int>(Term::own.size());
  template <class T, class P>
  static constexpr T evaluate(const T* active, const P* passive) {
    const Material<P> c{passive[1], passive[2], passive + 3};
    T sum(0.0);
    for (const T& x : Term::template argument<T, P>(active, passive[0]))
      sum = sum + Term::Density::template value<T, P>(x, c);
    return sum * (1.0 / Term::n_arguments);
  }
};

}  // namespace shellmatch
