#pragma once
/// \file
/// The compiled code of a band term: value, gradient and Newton's model at eight points.

#include "energies/compiled/compiled_term.h"
#include "energies/autodiff/compiled.h"
#include "energies/densities/positive_hessian.h"
#include "energies/terms/term_functors.h"

#include <algorithm>
#include <array>
#include <utility>

namespace shellmatch::detail {

using autodiff::Pack;

/// body(integral_constant) for 0, ..., N - 1.
template <int N, class Body>
[[gnu::always_inline]] inline void unrolled(Body&& body) {
  [&]<int... I>(std::integer_sequence<int, I...>) __attribute__((always_inline)) {
    (body(std::integral_constant<int, I>{}), ...);
  }
  (std::make_integer_sequence<int, N>{});
}

/// The passive inputs of a functor of `Term`: those of the point, the term's own options and fields, and the frames t1,
/// t2 if it reads these. With constant indices throughout, the compiler keeps them in registers.
template <class Functor, class Term>
[[gnu::always_inline]] inline std::array<Pack, Functor::n_passive> passive_inputs(
    const PointArrays<Term::dim>& p, const double* own, const TangentBasis<Term::dim>* t1 = nullptr,
    const TangentBasis<Term::dim>* t2 = nullptr) {
  constexpr int dim = Term::dim, n_point = PointArrays<dim>::n_passive, n_own = static_cast<int>(Term::own.size());
  constexpr int n_fields = Term::Reads::n_own, n_basis = (dim - 1) * dim, n_without_frames = n_point + n_own + n_fields;
  std::array<Pack, Functor::n_passive> passive;
  unrolled<n_point>([&](auto i) { passive[i] = p.passive[i]; });
  unrolled<n_own>([&](auto i) { passive[n_point + i] = Pack{} + own[i]; });
  unrolled<n_fields>([&](auto i) { passive[n_point + n_own + i] = p.own_fields[i]; });
  if constexpr (Functor::n_passive > n_without_frames)
    unrolled<n_basis>([&](auto i) {
      passive[n_without_frames + i] = (*t1)[i / dim][i % dim];
      passive[n_without_frames + n_basis + i] = (*t2)[i / dim][i % dim];
    });
  return passive;
}

template <class Term, bool WithGradient>
[[gnu::noinline]] Pack apply_band_term(PointArrays<Term::dim>& p, const Pack& seed, const double* own) {
  using Code = autodiff::Compiled<PointFunctor<Term>>;
  constexpr int n_active = PointFunctor<Term>::n_active;
  const auto run = [&](const Pack* passive) -> Pack {
    if constexpr (WithGradient) {
      std::array<Pack, n_active> adjoint;
      const Pack v = Code::gradient(p.active.data(), passive, seed, adjoint.data());
      unrolled<n_active>([&](auto i) {
        if constexpr (Code::reads_active(i)) p.adjoint[i] += adjoint[i];
      });
      return v * seed;
    } else {
      return Code::value(p.active.data(), passive) * seed;
    }
  };
  if constexpr (Term::own.empty() && Term::Reads::n_own == 0) return run(p.passive.data());
  else return run(passive_inputs<PointFunctor<Term>, Term>(p, own).data());
}

/// Lower triangle of h += factor j^T w j, which is what the Cholesky factor is made from; w is symmetric.
template <int NArguments, int NVariables>
[[gnu::always_inline]] inline void add_congruent(double factor, const SquarePack<NArguments>& w,
                                                 const std::array<std::array<Pack, NVariables>, NArguments>& j,
                                                 SquarePack<NVariables>& h) {
  for (int v = 0; v < NVariables; ++v) {
    std::array<Pack, NArguments> wj;
    for (int e = 0; e < NArguments; ++e) {
      wj[e] = w[e][0] * j[0][v];
      for (int f = 1; f < NArguments; ++f) wj[e] += w[e][f] * j[f][v];
      wj[e] *= factor;
    }
    for (int u = v; u < NVariables; ++u) {
      Pack sum = h[u][v];
      for (int e = 0; e < NArguments; ++e) sum += j[e][u] * wj[e];
      h[u][v] = sum;
    }
  }
}

/// Derivative of output `Output` of a functor by the coordinates of phi: through the template's values, and where it
/// reads phi.
template <class Code, int Dim, int Output>
[[gnu::always_inline]] inline std::array<Pack, Dim> by_position(const Pack* derivative, const PointArrays<Dim>& p) {
  std::array<Pack, Dim> sum{};
  unrolled<PointArrays<Dim>::n_target>([&](auto i) {
    if constexpr (Code::depends(Output, i))
      unrolled<Dim>([&](auto a) { sum[a] += derivative[i] * p.derivative[a][i]; });
  });
  if constexpr (Code::n_active > PointArrays<Dim>::n_without_phi)
    unrolled<Dim>([&](auto a) { sum[a] += derivative[PointArrays<Dim>::n_without_phi + a]; });
  return sum;
}

template <class Term>
void add_in_tangent(const BandModelPoint<Term::dim>& at, double weight, const double* own,
                    SquarePack<BandModelPoint<Term::dim>::n_tangent>& h) {
  constexpr int dim = Term::dim, m = dim - 1, n_dphi = PointArrays<dim>::n_target;
  constexpr int n_variables = BandModelPoint<dim>::n_tangent;
  using Functor = std::conditional_t<Term::is_tangential, TangentArgument<Term>, PointArgument<Term>>;
  using Code = autodiff::Compiled<Functor>;
  constexpr int n = Code::n_outputs;
  const auto passive = [&] {
    if constexpr (Term::is_tangential) return passive_inputs<Functor, Term>(at.arrays, own, &at.t1, &at.t2);
    else return passive_inputs<Functor, Term>(at.arrays, own);
  }();
  std::array<Pack, Functor::n_active> active;
  unrolled<Functor::n_active>([&](auto i) { active[i] = at.arrays.active[i]; });
  if constexpr (Term::is_tangential)
    unrolled<dim * dim>([&](auto i) {
      constexpr int k = i / dim, s = i % dim;
      Pack sum{};
      unrolled<dim>([&](auto l) {
        if constexpr (s < m) sum += at.arrays.active[n_dphi + k * dim + l] * at.t1[s][l];
        else sum += at.arrays.active[n_dphi + k * dim + l] * at.arrays.passive[1 + l];  // n1
      });
      active[n_dphi + i] = sum;
    });
  std::array<Pack, n> argument;
  std::array<Pack, n * Functor::n_active> derivative;
  Code::jacobian(active.data(), passive.data(), argument.data(), derivative.data());
  std::array<std::array<Pack, n_variables>, n> j{};
  unrolled<n>([&](auto e) {
    const Pack* row = derivative.data() + e * Functor::n_active;
    if constexpr (Term::is_tangential) {
      // X_rs moves Dphi by t2_r t1_s^T, and thus column s of Dphi Q by t2_r.
      unrolled<m * m>(
          [&](auto x) { unrolled<dim>([&](auto k) { j[e][x] += at.t2[x / m][k] * row[n_dphi + k * dim + x % m]; }); });
    }
    const auto by_phi = by_position<Code, dim, e>(row, at.arrays);
    unrolled<dim>([&](auto a) { j[e][m * m + a] = by_phi[a]; });
  });
  const Material<double> c{at.arrays.passive[PointArrays<dim>::n_reference][0],
                           at.arrays.passive[PointArrays<dim>::n_reference + 1][0], own};
  if constexpr (Term::is_tangential) {
    // Lanes without weight may hold anything: an infinity would outlive the multiplication by zero.
    for (int i = 0; i < n; ++i) argument[i] = at.weight > 0 ? argument[i] : Pack{} + (i % dim == 0 ? 1.0 : 0.0);
    add_congruent<n, n_variables>(weight, positive_tangent_hessian<typename Term::Density, dim>(argument, c), j, h);
  } else {
    typename Term::Density::template Argument<Pack> a;
    for (int i = 0; i < n; ++i) a.v[i] = at.weight > 0 ? argument[i] : Pack{};
    add_congruent<n, n_variables>(weight, positive_hessian<typename Term::Density>(a, c), j, h);
  }
}

/// The same by the entries of Dphi: X_ij = t2_i . Dphi t1_j.
template <class Term>
void add_in_all_by_tangent(const BandModelPoint<Term::dim>& at, double weight, const double* own,
                           SquarePack<BandModelPoint<Term::dim>::n_all>& h) {
  constexpr int dim = Term::dim, m = dim - 1, n_x = m * m, n_tangent = BandModelPoint<dim>::n_tangent;
  constexpr int n_all = BandModelPoint<dim>::n_all;
  SquarePack<n_tangent> of_tangent{};
  add_in_tangent<Term>(at, weight, own, of_tangent);
  for (int i = 0; i < n_tangent; ++i)
    for (int k = 0; k < i; ++k) of_tangent[k][i] = of_tangent[i][k];
  std::array<std::array<Pack, n_all>, n_tangent> j{};
  for (int r = 0; r < m; ++r)
    for (int s = 0; s < m; ++s)
      for (int k = 0; k < dim; ++k)
        for (int l = 0; l < dim; ++l) j[r * m + s][k * dim + l] = at.t2[r][k] * at.t1[s][l];
  for (int a = 0; a < dim; ++a) j[n_x + a][dim * dim + a] = Pack{} + 1.0;
  add_congruent<n_tangent, n_all>(1, of_tangent, j, h);
}

template <class Term>
void add_in_all(const BandModelPoint<Term::dim>& at, double weight, const double* own,
                SquarePack<BandModelPoint<Term::dim>::n_all>& h) {
  constexpr int dim = Term::dim, n_dphi = PointArrays<dim>::n_target, n_variables = BandModelPoint<dim>::n_all;
  using Functor = PointArgument<Term>;
  using Code = autodiff::Compiled<Functor>;
  constexpr int n = Code::n_outputs;
  const auto passive = passive_inputs<Functor, Term>(at.arrays, own);
  typename Term::Density::template Argument<Pack> argument;
  std::array<Pack, n * Functor::n_active> derivative;
  Code::jacobian(at.arrays.active.data(), passive.data(), argument.v.data(), derivative.data());
  std::array<std::array<Pack, n_variables>, n> j{};
  unrolled<n>([&](auto e) {
    const Pack* row = derivative.data() + e * Functor::n_active;
    for (int i = 0; i < dim * dim; ++i) j[e][i] = row[n_dphi + i];
    const auto by_phi = by_position<Code, dim, e>(row, at.arrays);
    for (int a = 0; a < dim; ++a) j[e][dim * dim + a] = by_phi[a];
  });
  constexpr bool is_matrix = n == dim * dim;
  for (int i = 0; i < n; ++i)
    argument.v[i] = at.weight > 0 ? argument.v[i] : Pack{} + (is_matrix && i % (dim + 1) == 0 ? 1.0 : 0.0);
  const Material<double> c{at.arrays.passive[PointArrays<dim>::n_reference][0],
                           at.arrays.passive[PointArrays<dim>::n_reference + 1][0], own};
  add_congruent<n, n_variables>(weight, positive_hessian<typename Term::Density>(argument, c), j, h);
}

template <class Term>
BandCode<Term::dim> band_code() {
  constexpr int dim = Term::dim;
  using Reads = typename Term::Reads;
  constexpr bool reads_dphi = Reads::template has<Dphi>;
  BandCode<dim> code{.value = apply_band_term<Term, false>,
                     .gradient = apply_band_term<Term, true>,
                     .add_in_tangent = nullptr,
                     .add_in_all = nullptr,
                     .reads_target = Reads::has_target,
                     .reads_phi = Reads::template has<Phi>,
                     .reads_dphi = reads_dphi,
                     .reads_curvature = Reads::has_curvature,
                     .reads_shape_operators = Reads::has_shape_operators};
  if constexpr (Term::is_tangential || !reads_dphi) code.add_in_tangent = add_in_tangent<Term>;
  if constexpr (Term::is_tangential) code.add_in_all = add_in_all_by_tangent<Term>;
  else code.add_in_all = add_in_all<Term>;
  return code;
}

}  // namespace shellmatch::detail
