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
double term_modulus(const Material<double>& c) {
  if constexpr (IsCornerTerm<Term>) return Term::scale(1.0, c);
  else return largest_second_derivative<typename Term::Density>(c);
}

}  // namespace detail

template <class Term>
CompiledTerm<Term::dim> compile_term() {
  return {.info = Term::info,
          .own = Term::own,
          .code = detail::term_code<Term>(),
          .cost = element_cost_function<Term>,
          .modulus = detail::term_modulus<Term>};
}

}  // namespace shellmatch
