#pragma once
/// \file
/// The names of the terms of energies/terms/list.h, known at compile time. energies/energy_options.h has them at run
/// time, without the terms themselves.

#include "energies/terms/list.h"
#include "energies/terms/term_values.h"

#include <array>
#include <cstddef>
#include <string_view>

namespace shellmatch {

namespace detail {

template <class... Term>
constexpr auto infos_of(TermList<Term...>) {
  return std::array<TermInfo, sizeof...(Term)>{Term::info...};
}

}  // namespace detail

/// All terms, in the order of the list.
inline constexpr auto all_term_infos = detail::infos_of(AllTerms<3>{});

/// Number of terms that an energy can have at a time: that of their names.
inline constexpr std::size_t n_all_terms = [] {
  std::size_t n = 0;
  for (std::size_t i = 0; i < all_term_infos.size(); ++i)
    n += i == 0 || all_term_infos[i].name != all_term_infos[i - 1].name;
  return n;
}();

/// Their names, in the order of every list of term values.
inline constexpr auto all_term_names = [] {
  std::array<std::string_view, n_all_terms> names;
  std::size_t n = 0;
  for (std::size_t i = 0; i < all_term_infos.size(); ++i)
    if (i == 0 || all_term_infos[i].name != all_term_infos[i - 1].name) names[n++] = all_term_infos[i].name;
  return names;
}();

namespace detail {

/// Terms of one name stand together, the first of them brings the factor, and no two of them have the same model.
constexpr bool is_good_list() {
  for (std::size_t i = 0; i < all_term_infos.size(); ++i) {
    const bool is_first = i == 0 || all_term_infos[i].name != all_term_infos[i - 1].name;
    if (is_first == all_term_infos[i].weight.name.empty()) return false;
    for (std::size_t j = 0; j < i; ++j)
      if (all_term_infos[j].name == all_term_infos[i].name &&
          (is_first || all_term_infos[j].model == all_term_infos[i].model))
        return false;
  }
  return true;
}
static_assert(is_good_list(),
              "energies/terms/list.h: terms of one name stand together, only the first has a weight, models differ");

}  // namespace detail

/// The names of the options of section `energy` that no term has brought (EnergyOptions::describe).
inline constexpr std::array<std::string_view, 6> general_option_names = {
    "lambda", "mu", "delta", "boundary", "quadrature_order", "evaluator"};

namespace detail {

/// Does no option of section `energy` have the name of another? Options are factors of terms, choices among models,
/// which have the term's name, and the terms' own.
template <class... Term>
constexpr bool option_names_differ(TermList<Term...>) {
  constexpr std::size_t n = general_option_names.size() + 2 * all_term_infos.size() + (Term::own.size() + ... + 0);
  std::array<std::string_view, n> names{};
  std::size_t size = 0;
  for (const std::string_view name : general_option_names) names[size++] = name;
  for (const TermInfo& info : all_term_infos)
    if (!info.weight.name.empty()) names[size++] = info.weight.name;
  for (std::size_t t = 0; t < n_all_terms; ++t) names[size++] = all_term_names[t];
  const auto add = [&](const auto& own) {
    for (const TermOption& option : own) names[size++] = option.name;
  };
  (add(Term::own), ...);
  for (std::size_t i = 0; i < size; ++i)
    for (std::size_t j = 0; j < i; ++j)
      if (names[i] == names[j]) return false;
  return true;
}
static_assert(option_names_differ(AllTerms<3>{}),
              "energies/terms/list.h: two options of section `energy` have one name");

}  // namespace detail

/// The term of this name. \pre there is one; a name that is known at compile time is checked there
constexpr Term term_named(std::string_view name) {
  for (std::size_t i = 0; i < n_all_terms; ++i)
    if (all_term_names[i] == name) return Term{i};
  throw "no such term";
}

namespace literals {

/// "match"_term
consteval Term operator""_term(const char* name, std::size_t length) { return term_named({name, length}); }

}  // namespace literals
using namespace literals;

}  // namespace shellmatch
