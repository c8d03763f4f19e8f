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

/// The argument A at a point. That of tangential terms is completed by n2 n1^T.
template <class Term, class T, class P>
constexpr auto argument_at(const PointValues<Term::dim, T, P>& at) {
  if constexpr (requires { requires Term::is_tangential; })
    return plus_outer(Term::Reads::call(Term{}, at), renormalised(at.y.n2), at.x.n1);
  else return Term::Reads::call(Term{}, at);
}

namespace detail {

/// Active inputs: d2, n2, root; Dphi by rows; phi where it is read. Passive inputs: d1, n1, r1; lambda, mu, the term's
/// own options, its own fields. Terms of cells have neither d2, n2, root nor d1, n1, r1.
template <class Term>
struct PointInputs {
  static constexpr int dim = Term::dim;
  static constexpr int n_target = IsBandTerm<Term> ? TargetPoint<dim, double>::size : 0;
  static constexpr int n_reference = IsBandTerm<Term> ? ReferencePoint<dim, double>::size : 0;
  static constexpr bool reads_phi = Term::Reads::template has<Phi>;
  static constexpr int n_own = static_cast<int>(Term::own.size()), n_own_fields = Term::Reads::n_own;
  static constexpr int n_active = n_target + dim * dim + (reads_phi ? dim : 0);
  static constexpr int n_passive = n_reference + 2 + n_own + n_own_fields;
  static_assert(IsBandTerm<Term> || !(Term::Reads::has_target || Term::Reads::has_reference),
                "the shapes' fields are known in the band: terms of cells read Phi, Dphi and fields of their own");

  template <class T, class P>
  static constexpr PointValues<dim, T, P> unpack(const T* active, const P* passive) {
    PointValues<dim, T, P> at;
    if constexpr (IsBandTerm<Term>) {
      at.y.d2 = *active++;
      for (T& e : at.y.n2.v) e = *active++;
      for (T& e : at.y.root.v) e = *active++;
      at.x.d1 = *passive++;
      for (P& e : at.x.n1.v) e = *passive++;
      for (P& e : at.x.r1.v) e = *passive++;
    }
    for (T& e : at.dphi.v) e = *active++;
    if constexpr (reads_phi)
      for (T& e : at.phi.v) e = *active++;
    at.material = {passive[0], passive[1], passive + 2};
    at.own_fields = passive + 2 + n_own;
    return at;
  }
};

}  // namespace detail

/// W(A) of a term of the band or of cells.
template <class Term>
struct PointFunctor : detail::PointInputs<Term> {
  template <class T, class P>
  static constexpr T evaluate(const T* active, const P* passive) {
    const auto at = detail::PointInputs<Term>::template unpack<T, P>(active, passive);
    return Term::Density::template value<T, P>(argument_at<Term, T, P>(at), at.material);
  }
};

/// A of such a term, entry after entry.
template <class Term>
struct PointArgument : detail::PointInputs<Term> {
  static constexpr int n_outputs = n_arguments_of<typename Term::Density>;
  template <class T, class P>
  static constexpr std::array<T, n_outputs> evaluate(const T* active, const P* passive) {
    return argument_at<Term, T, P>(detail::PointInputs<Term>::template unpack<T, P>(active, passive)).v;
  }
};

/// The matrix t2_i . A t1_j of a tangential argument in frames t1, t2 of the tangent planes, by rows. Active inputs:
/// those of PointFunctor with Dphi Q in the place of Dphi, where Q has the columns t1, then n1. Further passive inputs,
/// after those of PointFunctor: t1, then t2, vector after vector.
///
/// The argument is evaluated in the reference coordinates of Q, in which t1 and n1 are unit vectors: A t1_j is then a
/// column of A Q, which depends on few entries of Dphi Q, so that the backward sweeps are a third as long as those
/// through Dphi.
template <IsBandTerm Term>
struct TangentArgument : detail::PointInputs<Term> {
  using Inputs = detail::PointInputs<Term>;
  static constexpr int dim = Term::dim, m = dim - 1;
  static constexpr int n_passive = Inputs::n_passive + 2 * m * dim;
  static constexpr int n_outputs = m * m;
  template <class T, class P>
  static constexpr std::array<T, n_outputs> evaluate(const T* active, const P* passive) {
    auto at = Inputs::template unpack<T, P>(active, passive);
    const P* t1 = passive + Inputs::n_passive;
    const P* t2 = t1 + m * dim;
    at.x = in_frame(at.x, t1);
    const auto aq = Term::Reads::call(Term{}, at);
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

/// Mean of W over the entries of a corner term's argument. Active: the corners' positions, corner after corner;
/// passive: the term's scale, lambda, mu, its own options.
template <IsCornerTerm Term>
struct CornerFunctor {
  static constexpr int n_active = (1 << Term::dim) * Term::dim;
  static constexpr int n_passive = 3 + static_cast<int>(Term::own.size());
  template <class T, class P>
  static constexpr T evaluate(const T* active, const P* passive) {
    const Material<P> c{passive[1], passive[2], passive + 3};
    T sum(0.0);
    for (const T& x : Term{}(active, passive[0])) sum = sum + Term::Density::template value<T, P>(x, c);
    return sum * (1.0 / Term::n_arguments);
  }
};

}  // namespace shellmatch
