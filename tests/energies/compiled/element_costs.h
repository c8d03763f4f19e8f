#pragma once
/// \file
/// The assembly against Ceres' differentiation of the element costs, for every term.

#include "tests/energies/compiled/element_sums.h"
#include "tests/energies/exact_shapes.h"
#include "energies/terms/term_names.h"

namespace shellmatch::test {

/// A deformation that nearly folds, between two ellipsoids, on a grid with hanging nodes.
template <int Dim>
class ElementCosts : public ::testing::Test {
 protected:
  ProblemOptions options(VolumeDensity volume) const {
    ProblemOptions o;
    o.energy.lambda = 0.7;
    o.energy.mu = 1.3;
    o.energy.volume = volume;
    o.energy.terms.own("fold_threshold") = 0.9;
    return o;
  }
  template <class Add>
  void check(Term term, Add&& add, VolumeDensity volume = VolumeDensity::simplified) {
    check(term, add, options(volume));
  }
  template <class Add>
  void check(Term term, Add&& add, MembraneModel membrane, BendingModel bending) {
    ProblemOptions o = options(VolumeDensity::simplified);
    o.energy.membrane = membrane;
    o.energy.bending = bending;
    check(term, add, o);
  }
  template <class Add>
  void check(Term term, Add&& add, const ProblemOptions& o) {
    const Problem<Dim> problem(grid_, exact_fields<Dim>(grid_, reference_), exact_fields<Dim>(grid_, template_), o);
    ElementSum<Dim> sum{problem, phi_};
    add(sum);
    sum.expect_equal(term);
  }

  const Octree<Dim> grid_ = hanging_grid<Dim>(0.28);
  const ExactShape<Dim> reference_ = sphere<Dim>(0.28);
  const ExactShape<Dim> template_ = ellipsoid<Dim>(Vec<Dim>::LinSpaced(0.33, 0.24));
  const std::vector<Vec<Dim>> phi_ = deformed<Dim>(grid_, 0.04, 7);
};

}  // namespace shellmatch::test

/// The tests of one dimension, in a file of their own to keep compile times short.
#define SHELLMATCH_ELEMENT_COST_TESTS(Dim)                                                                         \
  using ElementCosts##Dim##d = ::shellmatch::test::ElementCosts<Dim>;                                              \
  TEST_F(ElementCosts##Dim##d, Match) { check("match"_term, [](auto& s) { s.template add_band<Match>(); }); }       \
  TEST_F(ElementCosts##Dim##d, Membrane) {                                                                         \
    check("membrane"_term, [](auto& s) { s.template add_band<Membrane>(); });                                       \
  }                                                                                                                \
  TEST_F(ElementCosts##Dim##d, Bending) { check("bending"_term, [](auto& s) { s.template add_band<Bending>(); }); } \
  TEST_F(ElementCosts##Dim##d, MembraneWithoutP2) {                                                                \
    check("membrane"_term, [](auto& s) { s.template add_band<MembraneWithoutP2>(); }, MembraneModel::no_p2,         \
          BendingModel::thin_shell);                                                                               \
  }                                                                                                                \
  TEST_F(ElementCosts##Dim##d, CauchyGreenMembrane) {                                                              \
    check("membrane"_term, [](auto& s) { s.template add_band<CauchyGreenMembrane>(); }, MembraneModel::cauchy_green,\
          BendingModel::thin_shell);                                                                               \
  }                                                                                                                \
  TEST_F(ElementCosts##Dim##d, BendingWithoutP2) {                                                                 \
    check("bending"_term, [](auto& s) { s.template add_band<BendingWithoutP2>(); }, MembraneModel::thin_shell,      \
          BendingModel::no_p2);                                                                                    \
  }                                                                                                                \
  TEST_F(ElementCosts##Dim##d, QuadraticBending) {                                                                 \
    check("bending"_term, [](auto& s) { s.template add_band<QuadraticBending>(); }, MembraneModel::thin_shell,      \
          BendingModel::quadratic);                                                                                \
  }                                                                                                                \
  TEST_F(ElementCosts##Dim##d, SimplifiedVolume) {                                                                 \
    check("volume"_term, [](auto& s) { s.template add_volume<SimplifiedVolume>(); }, VolumeDensity::simplified);    \
  }                                                                                                                \
  TEST_F(ElementCosts##Dim##d, FullVolume) {                                                                       \
    check("volume"_term, [](auto& s) { s.template add_volume<FullVolume>(); }, VolumeDensity::full);                \
  }                                                                                                                \
  TEST_F(ElementCosts##Dim##d, SymmetricDirichletVolume) {                                                         \
    check("volume"_term, [](auto& s) { s.template add_volume<SymmetricDirichletVolume>(); },                        \
          VolumeDensity::symmetric_dirichlet);                                                                     \
  }                                                                                                                \
  TEST_F(ElementCosts##Dim##d, FoldBarrier) { check("barrier"_term, [](auto& s) { s.add_barrier(); }); }
