// A whole small matching from the cost functors of single elements, in Ceres' own terms: each is differentiated by
// ceres::AutoDiffFirstOrderFunction, their sum is minimised by ceres::GradientProblemSolver. Nothing of the compiled
// assembly takes part; it gives the same energy. Builds on own_term_with_ceres.
// Sample output:
//   256 elements, 232 of them in the band
//   energy 8.2115 -> 0.2103
//   the compiled assembly says 0.2103
#include "energies/cost/element_cost.h"
#include "energies/terms/term_names.h"
#include "examples/small_problem.h"

#include <ceres/autodiff_first_order_function.h>
#include <ceres/ceres.h>
#include <cstdio>

using namespace shellmatch;

// The sum of element costs: each reads the positions of the element's four corners, 8 numbers.
struct ElementSum final : ceres::FirstOrderFunction {
  struct Part {
    std::unique_ptr<ceres::FirstOrderFunction> cost;
    std::array<Index, 4> nodes;
  };
  template <class TheTerm>
  void add(const Element<2>& element, const ElementFields<2>& fields, double weight) {
    using Cost = ElementCost<TheTerm>;
    parts.push_back({std::make_unique<ceres::AutoDiffFirstOrderFunction<Cost, Cost::n_dofs>>(new Cost(fields, weight, 1, 1)),
                     element.nodes});
  }
  bool Evaluate(const double* x, double* cost, double* gradient) const override {
    *cost = 0;
    for (int i = 0; gradient && i < n_unknowns; ++i) gradient[i] = 0;
    for (const Part& part : parts) {
      double dofs[8], of_part, by_dofs[8];
      for (int i = 0; i < 8; ++i) dofs[i] = x[2 * part.nodes[i / 2] + i % 2];
      if (!part.cost->Evaluate(dofs, &of_part, gradient ? by_dofs : nullptr)) return false;
      *cost += of_part;
      for (int i = 0; gradient && i < 8; ++i) gradient[2 * part.nodes[i / 2] + i % 2] += by_dofs[i];
    }
    return true;
  }
  int NumParameters() const override { return n_unknowns; }
  int n_unknowns = 0;
  std::vector<Part> parts;
};

int main() {
  example::SmallProblem small(4);
  const LevelEnergy<2> level = small.level();
  TermValues weights = small.weights;
  weights["barrier"_term] = 0;

  auto* sum = new ElementSum;
  sum->n_unknowns = static_cast<int>(2 * small.grid.n_nodes());
  const ShapeTable<2> gauss(2);
  int n_band = 0;
  for (const Element<2>& element : level.unknowns.elements()) {
    const ElementFields<2> fields(element, level.geometry, level.sigma, gauss);
    n_band += !fields.band.empty();
    sum->add<Match<2>>(element, fields, weights["match"_term]);
    sum->add<Membrane<2>>(element, fields, weights["membrane"_term]);
    sum->add<Bending<2>>(element, fields, weights["bending"_term]);
    sum->add<SymmetricDirichletVolume<2>>(element, fields, weights["volume"_term]);
  }
  std::vector<Vec<2>> phi = small.identity;
  ceres::GradientProblemSolver::Options solver;
  solver.logging_type = ceres::SILENT;
  solver.max_num_iterations = 500;
  ceres::GradientProblemSolver::Summary summary;
  const ceres::GradientProblem problem(sum);
  ceres::Solve(solver, problem, phi.front().data(), &summary);
  std::printf("%zu elements, %d of them in the band\n", level.unknowns.elements().size(), n_band);
  std::printf("energy %.4f -> %.4f\n", summary.initial_cost, summary.final_cost);
  TermValues values;
  if (level.energy.evaluate(phi, weights, values, {})) std::printf("the compiled assembly says %.4f\n", values.sum());
}
