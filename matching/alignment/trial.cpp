#include "matching/alignment/trial.h"

#include "base/error.h"
#include "matching/alignment/known_pairs.h"
#include "matching/cascade/cascade.h"
#include "matching/result/deformed_shape.h"
#include "matching/result/figures.h"

#include <algorithm>
#include <cmath>

namespace shellmatch {

namespace {

/// Shows nothing of a trial; what stops the run stops it.
class TrialObserver final : public Observer {
 public:
  explicit TrialObserver(Observer& of_run) : of_run_(of_run) {}
  bool iterated(const LevelStart&, const IterationRecord&) override {
    of_run_.stage("alignment");
    return true;
  }

 private:
  Observer& of_run_;
};

// Wrong starts fight the barrier against folds for hundreds of iterations; their energies are large enough before.
constexpr int most_trial_iterations = 80;

ExperimentOptions trial_options(const ExperimentOptions& options) {
  ExperimentOptions trial = options;
  trial.cascade.max_level = std::min(options.cascade.max_level, options.cascade.min_level + 1);
  trial.coverage.levels = 0;
  trial.check_gradient.every = 0;
  trial.solver.stop.max_iterations = std::min(options.solver.stop.max_iterations, most_trial_iterations);
  trial.solver.stop.relative_decrease = std::max(options.solver.stop.relative_decrease, options.cascade.intermediate_decrease);
  return trial;
}

}  // namespace

template <int Dim>
Trial try_start(const ShapePair<Dim>& shapes, const Alignment<Dim>& start, const std::vector<Landmark<Dim>>& landmarks,
                const ExperimentOptions& options, Observer& observer) {
  const ExperimentOptions trial = trial_options(options);
  ShapePair<Dim> placed = shapes;
  Trial result;
  try {
    const Similarity<Dim> placement = placed.place(trial, start.pose);
    const SignedDistance<Dim> d1(placed.reference.surface), d2(placed.template_shape.surface);
    const std::vector<PairSet<Dim>> pairs = known_pairs<Dim>(landmarks, start, trial, placement, d1, d2);
    TrialObserver silent(observer);
    PhaseSeconds seconds;
    const CascadeResult<Dim> end = run_cascade<Dim>(d1, d2, trial, silent, {}, seconds, {}, pairs);
    const TermValues& terms = end.levels.back().minimised;
    const double with_pairs = terms.sum();
    if (!std::isfinite(with_pairs)) return result;
    result.with_pairs = with_pairs;
    result.energy = with_pairs - (start.pairs.empty() ? 0 : terms[terms.size() - 1]);
    result.uncovered = two_sided_distance(deformed_surface(d1.surface(), end.grid, end.phi), d2).template_to_deformed.mean;
  } catch (const InputError&) {  // no place in the domain, or no finite energy: this start is none
  }
  return result;
}

template Trial try_start<2>(const ShapePair<2>&, const Alignment<2>&, const std::vector<Landmark<2>>&, const ExperimentOptions&, Observer&);
template Trial try_start<3>(const ShapePair<3>&, const Alignment<3>&, const std::vector<Landmark<3>>&, const ExperimentOptions&, Observer&);

}  // namespace shellmatch
