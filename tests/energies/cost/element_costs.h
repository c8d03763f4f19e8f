#pragma once
/// \file
/// The assembly against Ceres' differentiation of the element costs, for every term.

#include "energies/terms/term_names.h"
#include "tests/energies/cost/element_sums.h"
#include "tests/energies/exact_shapes.h"
#include "tests/energies/terms/term_types.h"

namespace shellmatch::test {

/// A deformation that nearly folds, between two ellipsoids, on a grid with hanging nodes.
template <int Dim>
class ElementCosts : public ::testing::Test {
 protected:
  /// Value and gradient of the energy that has this term alone.
  template <class Term>
  void check() {
    constexpr auto term = term_named(Term::info.name);
    ProblemOptions o;
    o.energy.lambda = 0.7;
    o.energy.mu = 1.3;
    set_other_options(o.energy.terms);
    if (!Term::info.model.empty()) o.energy.terms.model(term) = Term::info.model;
    const auto own = other_options<Term>();
    const Problem<Dim> problem(grid_, exact_fields<Dim>(grid_, reference_), exact_fields<Dim>(grid_, template_), o);
    ElementSum<Dim> sum{problem, phi_};
    sum.template add_term<Term>(own);
    sum.expect_equal(term);
  }

  const Octree<Dim> grid_ = hanging_grid<Dim>(0.28);
  const ExactShape<Dim> reference_ = sphere<Dim>(0.28);
  const ExactShape<Dim> template_ = ellipsoid<Dim>(Vec<Dim>::LinSpaced(0.33, 0.24));
  const std::vector<Vec<Dim>> phi_ = deformed<Dim>(grid_, 0.04, 7);
};

}  // namespace shellmatch::test

/// The tests of one dimension, in a file of their own to keep compile times short.
#define SHELLMATCH_ELEMENT_COST_TESTS(Dim)                                                                       \
  template <class Term>                                                                                          \
  struct ElementCosts##Dim##d : ::shellmatch::test::ElementCosts<Dim> {};                                        \
  TYPED_TEST_SUITE(ElementCosts##Dim##d, ::shellmatch::test::TermTypes<Dim>, ::shellmatch::test::TermTestNames); \
  TYPED_TEST(ElementCosts##Dim##d, SumToTheAssembly) { this->template check<TypeParam>(); }
