#pragma once
/// \file
/// The energy's gradient the slow way: every element's cost functor differentiated by ceres::Jet on its own degrees
/// of freedom, summed over the elements at the nodes and taken to the free nodes by C^T of grid/octree/constraints.h.

#include "energies/cost/element_cost.h"
#include "grid/octree/constraints.h"
#include "tests/energies/matching_problem.h"

#include <gtest/gtest.h>

namespace shellmatch::test {

/// Sum of element costs with the derivative at the nodes.
template <int Dim>
struct ElementSum {
  const Problem<Dim>& problem;
  const std::vector<Vec<Dim>>& phi;
  double value = 0;
  std::vector<Vec<Dim>> nodal = std::vector<Vec<Dim>>(phi.size(), Vec<Dim>::Zero());

  template <class Cost>
  void add(const Element<Dim>& element, const Cost& cost) {
    constexpr int n = n_corners<Dim> * Dim;
    using Jet = ceres::Jet<double, n>;
    std::array<Jet, n> dofs;
    for (int i = 0; i < n; ++i) dofs[i] = Jet(phi[element.nodes[i / Dim]][i % Dim], i);
    Jet energy;
    EXPECT_TRUE(cost(dofs.data(), &energy));
    value += energy.a;
    for (int i = 0; i < n; ++i) nodal[element.nodes[i / Dim]][i % Dim] += energy.v[i];
  }

  /// The term on every element, with weight 1.
  template <class Term>
  void add_term(std::array<double, Term::own.size()> own = {}) {
    for (const Element<Dim>& e : problem.unknowns.elements())
      add(e, ElementCost<Term>(ElementFields<Dim>(e, problem.geometry, problem.sigma, problem.energy.shape()), 1,
                               problem.options.lambda, problem.options.mu, own));
  }

  /// C^T of the derivative at the nodes, in the order of the grid's free nodes.
  std::vector<double> gradient() const {
    std::vector<double> g(problem.grid.free_nodes().size() * Dim);
    Constraints<Dim>(problem.grid).condense(components_of(nodal), g, Dim);
    return g;
  }

  /// Against value and gradient of the assembly. \pre natural boundary
  void expect_equal(Term term) const {
    const auto expected = gradient();
    const auto found = problem.gradient(phi, only(term));
    ASSERT_EQ(found.size(), expected.size());
    ASSERT_GT(value, 0);
    EXPECT_NEAR(problem.value(phi, term), value, 1e-12 * value);
    double size = 0, error = 0;
    for (std::size_t i = 0; i < found.size(); ++i) {
      const Index free = problem.grid.free_index(problem.unknowns.nodes()[i / Dim]);
      const double entry = expected[static_cast<std::size_t>(free) * Dim + i % Dim];
      size = std::max(size, std::abs(entry));
      error = std::max(error, std::abs(found[i] - entry));
    }
    EXPECT_LT(error, 1e-12 * size);
  }
};

}  // namespace shellmatch::test
