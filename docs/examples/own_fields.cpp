// Terms that read fields of one's own (docs/examples/own_fields.h): a rotation at the quadrature points, which is made
// anew between minimisations, a map at the nodes and a weight of cells. Value, gradient and Newton's model come with
// the terms. Builds on own_term_with_ceres.
// Sample output:
//   round 1: |Dphi - R|^2 = 0.0100, with the new R 0.0061; |phi - phi0|^2 = 3.5e-03
//   round 2: |Dphi - R|^2 = 0.0062, with the new R 0.0060; |phi - phi0|^2 = 3.0e-03
//   round 3: |Dphi - R|^2 = 0.0060, with the new R 0.0060; |phi - phi0|^2 = 3.0e-03
#include "energies/compiled/compile_term.h"
#include "docs/examples/own_fields.h"
#include "docs/examples/small_problem.h"
#include "matching/level/level_problem.h"
#include "solvers/methods/newton.h"

#include <cstdio>

using namespace shellmatch;

// The polar factors of Dphi at all quadrature points, in the place of those before.
void follow(UserField& rotation, std::span<const Element<2>> elements, const ShapeTable<2>& gauss,
            std::span<const Vec<2>> phi) {
  rotation.values.clear();
  for (const Element<2>& element : elements)
    for (const auto& q : gauss.points) {
      Mat<2> a = Mat<2>::Zero();
      for (int c = 0; c < 4; ++c)
        for (int k = 0; k < 2; ++k) a.col(k) += phi[element.nodes[c]] * q.dn[c][k] / element.side;
      const Vec<2> turn = Vec<2>(a(0, 0) + a(1, 1), a(1, 0) - a(0, 1)).normalized();
      rotation.values.insert(rotation.values.end(), {turn[0], -turn[1], turn[1], turn[0]});
    }
}

int main() {
  example::SmallProblem small(5);
  const LevelEnergy<2> level = small.level();
  const auto elements = level.unknowns.elements();
  const auto rotation = std::make_shared<UserField>(UserField{UserField::Place::points, 4, {}});
  const auto known_map = std::make_shared<UserField>(UserField{UserField::Place::nodes, 2, {}});
  const auto root_of_weight =
      std::make_shared<UserField>(UserField{UserField::Place::cells, 1, std::vector<double>(elements.size(), 0.0)});
  for (const Vec<2>& x : small.identity) known_map->values.insert(known_map->values.end(), {x[0], x[1]});
  for (std::size_t e = 0; e < elements.size(); ++e)  // only far from both shapes is the known map trusted
    if ((elements[e].corner - Vec<2>(0.5, 0.5)).norm() > 0.5) root_of_weight->values[e] = 1;
  const ShapeTable<2> gauss(2);
  follow(*rotation, elements, gauss, small.identity);

  const auto terms = std::make_shared<EnergyTerms<2>>(small.options.energy);
  const Term near_rotation = terms->add(compile_term<example::NearRotation<2>>(), {}, {rotation});
  const Term near_map = terms->add(compile_term<example::NearMap<2>>(), {}, {known_map, root_of_weight});
  const MatchingEnergy<2> energy(level.unknowns, level.geometry, terms, level.sigma, 2);
  EnergyHessian<2> hessian(energy, level.unknowns);
  TermValues weights = small.weights, values;
  weights.extend_to(terms->size());
  weights[near_rotation] = 0.1;
  weights[near_map] = 10;

  std::vector<Vec<2>> phi = small.identity;
  for (int round = 1; round <= 3; ++round) {
    LevelProblem<2> problem(level.unknowns, energy, hessian, weights, level.unknown_mass(), phi);
    std::vector<double> x = problem.unknowns_of(phi);
    Newton(NewtonOptions{}).minimize(problem, x, StopOptions{.max_iterations = 50, .relative_decrease = 1e-6});
    phi = problem.positions(x);
    energy.evaluate(phi, weights, values, {});
    const double before = values[near_rotation];
    follow(*rotation, elements, gauss, phi);
    energy.evaluate(phi, weights, values, {});
    std::printf("round %d: |Dphi - R|^2 = %.4f, with the new R %.4f; |phi - phi0|^2 = %.1e\n", round, before,
                values[near_rotation], values[near_map]);
  }
}
