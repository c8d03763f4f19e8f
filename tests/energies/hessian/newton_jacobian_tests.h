#pragma once
/// \file
/// The derivative J of every band term's argument in Newton's model J^T W''_+ J, by Dphi and by phi, against
/// differences: on two unequal ellipsoids and a deformation, so that no part of J vanishes, with hanging nodes.

#include "energies/compiled/compile_term.h"
#include "energies/hessian/energy_hessian.h"
#include "energies/terms/term_names.h"
#include "tests/energies/exact_shapes.h"
#include "tests/energies/hessian/model_by_differences.h"
#include "tests/energies/terms/term_types.h"

#include <gtest/gtest.h>

#include <random>

namespace shellmatch::test {

/// The square of another term's argument: there the model is 2 J^T J, whatever the other's density.
template <class Other>
struct SquareOf : BandTerm<Other::dim> {
  static constexpr int dim = Other::dim, n = n_arguments_of<typename Other::Density>;
  static constexpr TermInfo info{.name = "square"};
  using Density = SquareDensity<n>;
  using Reads = DependsOn<Dphi, TargetNormal, TargetRoot, ReferenceNormal, ReferenceRoot>;

  template <class T, class P>
  constexpr SmallVec<T, n> operator()(const SmallMat<T, dim>& dphi, const SmallVec<T, dim>& n2,
                                      const SmallSym<T, dim>& root, const SmallVec<P, dim>& n1,
                                      const SmallSym<P, dim>& r1) const {
    return {whole_argument<Other>(TargetPoint<dim, T>{T(0.0), n2, root}, dphi, ReferencePoint<dim, P>{P(0.0), n1, r1},
                                  Material<P>{})
                .v};
  }
};

template <int Dim>
class NewtonJacobian : public ::testing::Test {
 protected:
  /// The term of the list.
  template <class Term>
  void check() {
    const auto problem = problem_with({Term::info});
    const auto own = other_options<Term>();
    expect_model(problem->energy, only(term_named(Term::info.name)), *problem,
                 [&](auto phi, auto v) { return ModelByDifferences<Term>(*problem, own)(phi, v); });
  }
  /// Two at a time, the second with twice the weight.
  template <class One, class Two>
  void check_sum() {
    const auto problem = problem_with({One::info, Two::info});
    TermValues weights = only(term_named(One::info.name));
    weights[term_named(Two::info.name)] = 2;
    expect_model(problem->energy, weights, *problem, [&](auto phi, auto v) {
      return ModelByDifferences<One>(*problem)(phi, v) + 2 * ModelByDifferences<Two>(*problem)(phi, v);
    });
  }
  /// The square of the term's argument, added from outside.
  template <class Term>
  void check_square() {
    const auto problem = problem_with({});
    const auto terms = std::make_shared<EnergyTerms<Dim>>(problem->options);
    const auto square = terms->add(compile_term<SquareOf<Term>>());
    const MatchingEnergy<Dim> energy(problem->unknowns, problem->geometry, terms, problem->sigma, 2);
    TermValues weights(terms->size());
    weights[square] = 1;
    expect_model(energy, weights, *problem,
                 [&](auto phi, auto v) { return ModelByDifferences<SquareOf<Term>>(*problem)(phi, v); });
  }

 private:
  /// With the models of these terms.
  std::unique_ptr<Problem<Dim>> problem_with(std::initializer_list<TermInfo> infos) const {
    ProblemOptions o;
    o.energy.lambda = 0.7;
    o.energy.mu = 1.3;
    set_other_options(o.energy.terms);
    o.smooth = true;  // differences ask for fields without kinks
    for (const TermInfo& info : infos)
      if (!info.model.empty()) o.energy.terms.model(term_named(info.name)) = info.model;
    return std::make_unique<Problem<Dim>>(grid_,
                                          exact_fields<Dim>(grid_, ellipsoid<Dim>(Vec<Dim>::LinSpaced(0.25, 0.32))),
                                          exact_fields<Dim>(grid_, ellipsoid<Dim>(Vec<Dim>::LinSpaced(0.33, 0.24))), o);
  }

  template <class Expected>
  void expect_model(const MatchingEnergy<Dim>& energy, const TermValues& weights, const Problem<Dim>& problem,
                    Expected&& expected) const {
    ASSERT_FALSE(grid_.hanging_nodes().empty());
    const auto phi = deformed<Dim>(grid_, 0.03, 11);
    EnergyHessian<Dim> hessian(energy, problem.unknowns);
    hessian.assemble(phi, weights);
    std::mt19937 random(5);
    std::normal_distribution<double> normal;
    std::vector<double> u(problem.unknowns.size()), hu(u.size());
    const auto smooth = at_nodes<Dim>(grid_, smooth_field<Dim>(3));
    for (const double roughness : {0.0, 1.0}) {
      problem.unknowns.restrict_to(smooth, u);
      for (double& x : u) x += roughness * normal(random);
      std::vector<Vec<Dim>> v(phi.size(), Vec<Dim>::Zero());
      problem.unknowns.expand(u, v);
      hessian.apply(u, hu);
      double model = 0;
      for (std::size_t i = 0; i < u.size(); ++i) model += u[i] * hu[i];
      const double by_differences = expected(std::span<const Vec<Dim>>(phi), std::span<const Vec<Dim>>(v));
      ASSERT_GT(by_differences, 0);
      // The factors of the points' matrices leave out at most 1e-4 (energies/densities/pack_eigen.h), and the
      // elements' matrices are kept in single precision.
      EXPECT_NEAR(model, by_differences, 1e-4 * by_differences) << "roughness " << roughness;
    }
  }

  const Octree<Dim> grid_ = hanging_grid<Dim>(0.28);
};

}  // namespace shellmatch::test

/// The tests of one dimension, in a file of their own to keep compile times short.
#define SHELLMATCH_NEWTON_JACOBIAN_TESTS(Dim)                                                        \
  using NewtonJacobian##Dim##d = ::shellmatch::test::NewtonJacobian<Dim>;                            \
  template <class Term>                                                                              \
  struct NewtonJacobianOf##Dim##d : NewtonJacobian##Dim##d {};                                       \
  TYPED_TEST_SUITE(NewtonJacobianOf##Dim##d, ::shellmatch::test::BandTermTypes<Dim>,                 \
                   ::shellmatch::test::TermTestNames);                                               \
  TYPED_TEST(NewtonJacobianOf##Dim##d, IsThatByDifferences) { this->template check<TypeParam>(); }   \
  TEST_F(NewtonJacobian##Dim##d, SquareOfMembrane) { check_square<Membrane<Dim>>(); }                \
  TEST_F(NewtonJacobian##Dim##d, SquareOfBending) { check_square<Bending<Dim>>(); }                  \
  /* All tangential, and mixed: then the tangential ones are taken to all variables. */              \
  TEST_F(NewtonJacobian##Dim##d, SumOfTangentialTerms) { check_sum<Membrane<Dim>, Bending<Dim>>(); } \
  TEST_F(NewtonJacobian##Dim##d, SumOfTermsOfBothKinds) { check_sum<Membrane<Dim>, BendingWithoutP2<Dim>>(); }
