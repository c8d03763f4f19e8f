// A solver of one's own (docs/examples/barzilai_borwein.h), on the problem of one level, in two metrics. The metric is
// a change of variables around the objective: the method does not know of it. Builds on own_term_with_ceres.
// Sample output:
//   barzilai_borwein in euclidean: 8.3099 -> 0.1451, many steps, stopped by relative_decrease
//   barzilai_borwein in l2: 8.3099 -> 0.1451, many steps, stopped by relative_decrease
//   newton: 8.3099 -> 0.1451, few steps, stopped by relative_decrease
#include "docs/examples/barzilai_borwein.h"
#include "docs/examples/small_problem.h"
#include "grid/fields/mass.h"
#include "matching/level/level_problem.h"
#include "solvers/metric/metric.h"
#include "solvers/methods/newton.h"

#include <cstdio>

using namespace shellmatch;

int main() {
  example::SmallProblem small(5);
  LevelEnergy<2> level = small.level();
  std::vector<double> mass;  // of the unknown nodes: the metric l2
  for (const Index node : level.unknowns.nodes()) mass.push_back(lumped_mass(small.grid)[small.grid.free_index(node)]);
  LevelProblem<2> problem(level.unknowns, level.energy, level.hessian, small.weights, mass, small.identity);
  const StopOptions stop{.max_iterations = 3000, .relative_decrease = 1e-6};
  const auto report = [](const std::string& what, const MinimizerSummary& s) {
    std::printf("%s: %.4f -> %.4f, %s steps, stopped by %s\n", what.c_str(), s.initial_value, s.final_value,
                s.iterations < 50 ? "few" : "many", std::string(enum_name(s.reason)).c_str());
  };
  for (const Metric metric : {Metric::euclidean, Metric::l2}) {
    std::vector<double> x = problem.unknowns_of(small.identity);
    report("barzilai_borwein in " + std::string(enum_name(metric)),
           minimize_in_metric(example::BarzilaiBorwein(), metric, problem, x, stop));
  }
  std::vector<double> x = problem.unknowns_of(small.identity);
  report("newton", Newton(NewtonOptions{}).minimize(problem, x, stop));
}
