#pragma once
/// \file
/// Makes a CompiledTerm from a term's type: compile_term<Membrane<3>>().

#include "energies/compiled/band_term_code.h"
#include "energies/compiled/cell_term_code.h"
#include "energies/compiled/compiled_term.h"
#include "energies/cost/element_cost.h"

namespace shellmatch {

namespace detail {

template <class Term>
auto term_code() {
  if constexpr (IsBandTerm<Term>) return band_code<Term>();
  else if constexpr (IsCellTerm<Term>) return cell_code<Term>();
  else return corner_code<Term>();
}

template <class Term>
inline constexpr int n_own_fields_of = 0;
template <class Term>
requires requires { typename Term::Reads; }
inline constexpr int n_own_fields_of<Term> = Term::Reads::n_own;

template <class Term>
auto residuals_of() -> decltype(CompiledTerm<Term::dim>::residuals) {
  if constexpr (is_square<Term>) return element_residual_function<Term>;
  else return nullptr;
}

template <class Term>
double term_modulus(const Material<double>& c) {
  if constexpr (IsCornerTerm<Term>) return Term::scale(1.0, c);
  else return largest_second_derivative<typename Term::Density>(c);
}

}  // namespace detail

template <class Term>
CompiledTerm<Term::dim> compile_term() {
  return {.info = Term::info,
          .own = Term::own,
          .n_own_fields = detail::n_own_fields_of<Term>,
          .code = detail::term_code<Term>(),
          .cost = element_cost_function<Term>,
          .residuals = detail::residuals_of<Term>(),
          .modulus = detail::term_modulus<Term>};
}

}  // namespace shellmatch
