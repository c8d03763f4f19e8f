// The options of section `energy`: their names differ, and values with which no energy can be computed are refused.

#include "energies/compiled/compile_term.h"
#include "energies/compiled/energy_terms.h"
#include "energies/terms/term_names.h"
#include "examples/normal_alignment.h"
#include "tests/matching/experiment/expect_input_error.h"

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

TEST(EnergyOptions, AMaterialWithoutAStiffnessIsRefused) {
  const double nan = std::nan(""), infinite = std::numeric_limits<double>::infinity();
  EnergyOptions options;
  EXPECT_NO_THROW(EnergyTerms<3>{options});
  options.lambda = nan;
  expect_input_error([&] { EnergyTerms<3>{options}; }, {"the stiffness of the term membrane (thin_shell) is nan", "lambda = nan"});
  options.lambda = 1;
  options.mu = infinite;
  expect_input_error([&] { EnergyTerms<2>{options}; }, {"the stiffness of the term", "mu = inf"});
  options.mu = 1;
  options.terms.own("fold_threshold") = nan;
  expect_input_error([&] { EnergyTerms<3>{options}; }, {"energy.fold_threshold: nan is out of range", "0 < x <= 0.9"});
}

TEST(EnergyOptions, ThoseOfATermFromElsewhereAreChecked) {
  EnergyTerms<2> terms{EnergyOptions{}};
  const auto alignment = compile_term<example::NormalAlignment<2>>();
  for (const double bad : {std::nan(""), -1.0})
    expect_input_error([&] { terms.add(alignment, {bad}); }, {"energy.normal_stretch:", "x >= 0"});
  EXPECT_EQ(terms.size(), term_names().size()) << "nothing was added";
  EXPECT_NO_THROW(terms.add(alignment, {2.0}));
}

}  // namespace
}  // namespace shellmatch
