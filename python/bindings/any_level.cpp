#include "python/bindings/any_level.h"

#include "base/error.h"
#include "matching/experiment/level_solver.h"
#include "matching/experiment/yaml_options.h"
#include "solvers/methods/fallback.h"

#include <utility>

namespace shellmatch::python {

namespace {

template <int Dim>
class LevelOf final : public AnyLevel {
 public:
  LevelOf(ShapePair<Dim> shapes, std::vector<Landmark<Dim>> landmarks, const ExperimentOptions& options, int level,
          bool from_coarser, Observer& observer)
      : level_(std::move(shapes), std::move(landmarks), options, level, observer),
        phi_(from_coarser ? level_.coarser_result(observer) : level_.identity()),
        problem_(level_.problem(solver_at_level(options.solver, level), phi_)) {
    level_.energy().refresh(phi_);
  }

  std::vector<double> start() override { return problem_.unknowns_of(phi_); }
  std::vector<double> mass() override { return {problem_.lumped_mass().begin(), problem_.lumped_mass().end()}; }
  bool evaluate(const std::vector<double>& x, double& value, std::span<double> gradient) override {
    return problem_.evaluate(x, value, gradient);
  }
  std::vector<std::string> term_names() override { return problem_.term_names(); }
  std::vector<double> term_values() override { return problem_.term_values(); }

  std::vector<double> model_times(const std::vector<double>& x, const std::vector<double>& v) override {
    if (x != model_at_) {
      double value = 0;
      model_at_.clear();
      if (!problem_.evaluate(x, value, {}))
        throw_input_error("the energy cannot be evaluated at x: {}", problem_.what_is_not_finite(x));
      problem_.prepare_second_derivative(x, {});
      model_at_ = x;
    }
    std::vector<double> product(v.size());
    problem_.apply_second_derivative(v, product);
    return product;
  }

  Map map(const std::vector<double>& x) override {
    return Map(std::make_shared<const Deformation<Dim>>(level_.map(problem_.positions(x))));
  }

  Minimum minimise(std::vector<double> x, const OptionTexts& texts, PythonObserver& observer) override {
    ExperimentOptions options = level_.options();
    for (const auto& [key, value, origin] : texts) apply_override(options, Override{key, value, origin});
    check_experiment(options);
    const SolverOptions solver = solver_at_level(options.solver, level_.number());
    LevelProblem<Dim> problem = level_.problem(solver, problem_.positions(x));
    model_at_.clear();  // Newton's method uses the same matrix
    Minimum minimum;
    minimum.summary = minimize_with_fallback(
        solver, problem, x, solver.stop,
        [&](const IterationRecord& record) {
          minimum.records.push_back(record);
          return observer.iterated(record);
        },
        [&](const std::string& change) { observer.note(change); });
    if (minimum.summary.reason == StopReason::cannot_evaluate_start)
      throw_input_error("the energy cannot be evaluated at x0: {}", minimum.summary.message);
    minimum.x = std::move(x);
    return minimum;
  }

  const std::vector<LevelSize>& sizes() const override { return level_.sizes(); }
  int number() const override { return level_.number(); }

 private:
  PairLevel<Dim> level_;
  std::vector<Vec<Dim>> phi_;
  LevelProblem<Dim> problem_;
  std::vector<double> model_at_;  ///< where the second derivative has been prepared
};

}  // namespace

template <int Dim>
std::unique_ptr<AnyLevel> make_level(ShapePair<Dim> shapes, std::vector<Landmark<Dim>> landmarks,
                                     const ExperimentOptions& options, int level, bool from_coarser,
                                     Observer& observer) {
  return std::make_unique<LevelOf<Dim>>(std::move(shapes), std::move(landmarks), options, level, from_coarser,
                                        observer);
}

SHELLMATCH_2D_3D(make_level);

}  // namespace shellmatch::python
