// A term of one's own (docs/examples/normal_alignment.h), added to those of the energy and minimised by Ceres'
// GradientProblemSolver. Value, gradient, vector code and Newton's model are made from its type.
// Builds on match_two_meshes.
// Sample output:
//   without it: |Dphi n1 - n2|^2 = 0.145, match 1.3e-06
//   with it:    |Dphi n1 - n2|^2 = 0.017, match 3.2e-06
#include "energies/assembly/ceres_problem.h"
#include "energies/compiled/compile_term.h"
#include "energies/terms/term_names.h"
#include "docs/examples/normal_alignment.h"
#include "docs/examples/small_problem.h"

#include <ceres/ceres.h>
#include <cstdio>

using namespace shellmatch;

int main() {
  example::SmallProblem small(5);
  const LevelEnergy<2> level = small.level();
  const auto terms = std::make_shared<EnergyTerms<2>>(small.options.energy);
  const Term own = terms->add(compile_term<example::NormalAlignment<2>>());
  const MatchingEnergy<2> energy(level.unknowns, level.geometry, terms, level.sigma, 2);
  TermValues weights(terms->size()), probe = weights;
  for (std::size_t t = 0; t < small.weights.size(); ++t) weights[t] = small.weights[t];
  probe[own] = probe["match"_term] = 1;
  for (const double weight : {0.0, 1.0}) {
    weights[own] = weight;
    std::vector<double> x(level.unknowns.size());
    level.unknowns.restrict_to(small.identity, x);
    ceres::GradientProblemSolver::Summary summary;
    ceres::GradientProblemSolver::Options solver;
    solver.logging_type = ceres::SILENT;
    solver.max_num_iterations = 300;
    const ceres::GradientProblem problem(new EnergyFunction<2>(energy, level.unknowns, weights, small.identity));
    ceres::Solve(solver, problem, x.data(), &summary);
    std::vector<Vec<2>> phi = small.identity;
    TermValues values;
    level.unknowns.expand(x, phi);
    energy.evaluate(phi, probe, values, {});
    std::printf("%s |Dphi n1 - n2|^2 = %.3f, match %.1e\n", weight > 0 ? "with it:   " : "without it:", values[own],
                values["match"_term]);
  }
}
