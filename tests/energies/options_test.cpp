// The options of section `energy`: their names differ, and values with which no energy can be computed are refused.

#include "energies/compiled/compile_term.h"
#include "energies/compiled/energy_terms.h"
#include "energies/terms/term_names.h"
#include "docs/examples/normal_alignment.h"
#include "tests/support/expect_input_error.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <string>

namespace shellmatch {
namespace {

TEST(EnergyOptions, NamesDiffer) {
  std::multiset<std::string> names;
  const auto visit = [&](std::string_view name, const auto&, const OptionInfo&) { names.emplace(name); };
  const EnergyOptions options;
  EnergyOptions::describe(options, visit);
  for (const std::string& name : names) EXPECT_EQ(names.count(name), 1u) << name;
  // Those which the compiler's check of the list knows, and those of the terms.
  std::size_t n_of_terms = 0;
  const auto count = [&](auto&&...) { ++n_of_terms; };
  TermOptions::describe_factors(options.terms, count);
  TermOptions::describe_models(options.terms, count);
  EXPECT_EQ(names.size(), general_option_names.size() + n_of_terms);
  for (const std::string_view name : general_option_names) EXPECT_TRUE(names.contains(std::string(name))) << name;
}

template <int N>
struct Named {
  static constexpr std::string_view names[] = {"stretch", "mu", "match_weight", "membrane", "fold_threshold"};
  static constexpr std::array<TermOption, 1> own{{{names[N]}}};
};
static_assert(detail::option_names_differ(TermList<Named<0>, FoldBarrier<3>>{}));
static_assert(!detail::option_names_differ(TermList<Named<0>, Named<0>>{}), "of two terms");
static_assert(!detail::option_names_differ(TermList<Named<1>>{}), "of the section");
static_assert(!detail::option_names_differ(TermList<Named<2>>{}), "a factor");
static_assert(!detail::option_names_differ(TermList<Named<3>>{}), "a choice of models");
static_assert(!detail::option_names_differ(TermList<Named<4>, FoldBarrier<3>>{}), "of a term of the list");

TEST(EnergyOptions, NumbersThatAProgramHasSetAreChecked) {
  const auto refuse = [](auto change, std::initializer_list<std::string> parts) {
    EnergyOptions options;
    EXPECT_NO_THROW(EnergyTerms<3>{options});
    change(options);
    expect_input_error([&] { EnergyTerms<3>{options}; }, parts);
  };
  const double nan = std::nan(""), infinite = std::numeric_limits<double>::infinity();
  refuse([&](EnergyOptions& o) { o.lambda = nan; },
         {"energy.lambda: nan is out of range; expected a finite number, x >= 0"});
  refuse([&](EnergyOptions& o) { o.mu = infinite; },
         {"energy.mu: inf is out of range; expected a finite number, x > 0"});
  refuse([&](EnergyOptions& o) { o.terms.own("fold_threshold") = nan; },
         {"energy.fold_threshold: nan", "0 < x <= 0.9"});
  refuse([&](EnergyOptions& o) { o.terms.factor("match"_term) = -1; }, {"energy.match_weight: -1", "x >= 0"});
}

TEST(EnergyOptions, ThoseOfATermFromElsewhereAreChecked) {
  EnergyTerms<2> terms{EnergyOptions{}};
  const auto alignment = compile_term<example::NormalAlignment<2>>();
  for (const double bad : {std::nan(""), -1.0})
    expect_input_error([&] { terms.add(alignment, {bad}); }, {"energy.normal_stretch:", "x >= 0"});
  // A density whose second derivative is not finite where it should rest.
  auto broken = alignment;
  broken.modulus = [](const Material<double>& c) { return std::sqrt(-c.mu); };
  expect_input_error([&] { terms.add(broken); },
                     {"the stiffness of the term normal_alignment is", "lambda = 1 and mu = 1"});
  EXPECT_EQ(terms.size(), term_names().size()) << "nothing was added";
  EXPECT_NO_THROW(terms.add(alignment, {2.0}));
}

}  // namespace
}  // namespace shellmatch
