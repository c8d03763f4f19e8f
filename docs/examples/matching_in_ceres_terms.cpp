// A whole matching by Ceres: every term on every element is a ceres::CostFunction, differentiated by ceres::Jet, and
// their sum is minimised by ceres::GradientProblemSolver. Hanging nodes and the barrier against folds are included;
// nothing of the compiled code takes part, which gives the same energy. The terms that are squares also make a
// ceres::Problem. Builds on own_term_with_ceres.
// Sample output:
//   energy 8.3397 -> 0.1465, by the compiled code at the start 8.3397
//   match is 1024 residuals, cost 1.5e-03; 4 terms are no squares
#include "energies/assembly/ceres_problem.h"
#include "docs/examples/small_problem.h"

#include <ceres/ceres.h>
#include <cstdio>

using namespace shellmatch;

int main() {
  example::SmallProblem small(4);
  small.refine();  // at the shapes: nodes hang
  TermValues by_compiled_code;
  small.level().energy.evaluate(small.identity, small.weights, by_compiled_code, {});
  small.options.energy.evaluator = Evaluator::ceres;
  const LevelEnergy<2> level = small.level();

  auto* energy = new EnergyFunction<2>(level.energy, level.unknowns, small.weights, small.identity);
  std::vector<double> x(level.unknowns.size());
  level.unknowns.restrict_to(small.identity, x);
  ceres::GradientProblemSolver::Options solver;
  solver.logging_type = ceres::SILENT;
  solver.max_num_iterations = 300;
  ceres::GradientProblemSolver::Summary summary;
  ceres::Solve(solver, ceres::GradientProblem(energy), x.data(), &summary);
  std::printf("energy %.4f -> %.4f, by the compiled code at the start %.4f\n", summary.initial_cost, summary.final_cost,
              by_compiled_code.sum());

  ceres::Problem squares;
  const auto left_out = add_residuals<2>(level.energy, level.unknowns, small.weights, small.identity, x, squares);
  double cost = 0;
  squares.Evaluate({}, &cost, nullptr, nullptr, nullptr);
  std::printf("match is %d residuals, cost %.1e; %zu terms are no squares\n", squares.NumResiduals(), cost,
              left_out.size());
}
