// A solver of one's own, on the problem of one level, in two metrics: steps along the gradient of the length of Barzilai
// and Borwein (IMA J. Numer. Anal. 8, 1988). The metric is a change of variables around the objective: the method does
// not know of it. Builds on own_term_with_ceres.
// Sample output:
//   barzilai_borwein in euclidean: 8.3099 -> 0.1451, many steps, stopped by relative_decrease
//   barzilai_borwein in l2: 8.3099 -> 0.1451, many steps, stopped by relative_decrease
//   newton: 8.3099 -> 0.1451, few steps, stopped by gradient_norm
#include "examples/small_problem.h"
#include "grid/fields/mass.h"
#include "matching/level/level_problem.h"
#include "solvers/metric/metric.h"
#include "solvers/methods/newton.h"
#include "solvers/minimization_run.h"
#include "solvers/vector_ops.h"

#include <cmath>
#include <cstdio>
#include <utility>

using namespace shellmatch;

class BarzilaiBorwein final : public Minimizer {
 public:
  std::string name() const override { return "barzilai_borwein"; }
  MinimizerSummary minimize(Objective& objective, std::vector<double>& x, const StopOptions& stop,
                            const IterationCallback& callback = {}) const override {
    MinimizationRun run(objective, stop, callback);
    std::vector<double> g(run.size()), trial(run.size()), trial_g(run.size()), s(run.size()), y(run.size());
    if (!run.start(x, g)) return run.summary();
    double value = run.start_value(), length = 0.01 / run.start_gradient_norm();
    while (!run.over()) {
      Evaluation at;
      for (int halvings = 0; halvings < 40; ++halvings, length /= 2) {
        add_scaled(x, -length, g, trial);
        at = run.evaluate(trial, trial_g);  // not feasible: a fold, or anything not finite
        if (at.feasible && at.value < value) break;
      }
      if (!(at.feasible && at.value < value)) {
        run.finish(StopReason::no_descent);
        break;
      }
      const PairProducts pair = difference_pair(x, trial, g, trial_g, s, y);
      std::swap(x, trial);
      std::swap(g, trial_g);
      value = at.value;
      run.accept(at, std::sqrt(pair.s_s));
      if (pair.s_y > 0) length = pair.s_s / pair.s_y;
    }
    return run.summary();
  }
};

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
    report("barzilai_borwein in " + std::string(enum_name(metric)), minimize_in_metric(BarzilaiBorwein(), metric, problem, x, stop));
  }
  std::vector<double> x = problem.unknowns_of(small.identity);
  report("newton", Newton(NewtonOptions{}).minimize(problem, x, stop));
}
