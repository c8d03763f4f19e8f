#pragma once
/// \file
/// The list of terms for typed tests, so that no test lists them by hand, and options of theirs that are not the
/// defaults.

#include "energies/energy_options.h"
#include "energies/terms/list.h"
#include "energies/terms/term_functors.h"
#include "tests/energies/terms/band_density.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <string>
#include <type_traits>

namespace shellmatch::test {

namespace term_types {

template <class List, class... More>
struct TypesOf;
template <class... Term, class... More>
struct TypesOf<TermList<Term...>, More...> {
  using type = ::testing::Types<Term..., More...>;
};

template <class Found, class... Term>
struct BandTypes {
  using type = Found;
};
template <class... Found, class Term, class... Rest>
struct BandTypes<::testing::Types<Found...>, Term, Rest...>
    : BandTypes<std::conditional_t<IsBandTerm<Term>, ::testing::Types<Found..., Term>, ::testing::Types<Found...>>,
                Rest...> {};
template <class List>
struct BandTypesOf;
template <class... Term>
struct BandTypesOf<TermList<Term...>> : BandTypes<::testing::Types<>, Term...> {};

}  // namespace term_types

/// Every term of the list, and `More` from elsewhere.
template <int Dim, class... More>
using TermTypes = typename term_types::TypesOf<AllTerms<Dim>, More...>::type;

/// The terms of the list that are integrated over the band.
template <int Dim>
using BandTermTypes = typename term_types::BandTypesOf<AllTerms<Dim>>::type;

/// Names of the typed tests: membrane_no_p2.
struct TermTestNames {
  template <class Term>
  static std::string GetName(int) {
    const std::string name(Term::info.name), model(Term::info.model);
    return model.empty() ? name : name + "_" + model;
  }
};

/// Calls f.operator()<Term>() for every term of the list.
template <class... Term, class F>
void for_each_term(TermList<Term...>, const F& f) {
  (f.template operator()<Term>(), ...);
}

/// A value of the option, within its range, that is not the default.
inline double another_value(const TermOption& option) {
  if (std::isfinite(option.info.max) && option.info.max != option.value) return option.info.max;
  return option.value + 0.5 * (1 + std::abs(option.value));
}

/// The same of all options that a term has of its own.
template <class Term>
std::array<double, Term::own.size()> other_options() {
  std::array<double, Term::own.size()> own{};
  for (std::size_t i = 0; i < own.size(); ++i) own[i] = another_value(Term::own[i]);
  return own;
}

/// Sets these for all terms of the list.
inline void set_other_options(TermOptions& options) {
  for_each_term(AllTerms<3>{}, [&]<class Term>() {
    for (const TermOption& option : Term::own) options.own(option.name) = another_value(option);
  });
}

}  // namespace shellmatch::test
