#include "matching/experiment/options.h"

#include "energies/terms/term_names.h"

namespace shellmatch {

ExperimentOptions profile_defaults(Profile profile) {
  ExperimentOptions options;
  options.profile = profile;
  options.solver.name = "newton";
  // Newton's method takes few, expensive steps; it stops at the first one that gains little. The others have more.
  // Nothing builds on the last minimisation, which may stop before those that others begin from
  // (cascade.intermediate_decrease), and sooner where its steps are restrained.
  options.solver.stop.relative_decrease = 3e-3;
  options.solver.stop.restrained_factor = 3;
  options.solver.stop.decrease_window = 0;
  options.solver.stop.max_iterations = 300;
  if (profile == Profile::paper) {
    // Section 6: nu is divided by ten and c_vol by two once per refinement, in one step.
    options.cascade.nu = 0.002;
    options.cascade.nu_factor = 0.1;
    options.cascade.nu_substeps = 1;
    options.cascade.volume = 0.025;
    options.cascade.volume_factor = 0.5;
    options.cascade.coarse_sigma_cells = options.cascade.sigma_cells;
    options.cascade.negligible_start_rise = options.cascade.negligible_rise = 0;
    options.cascade.intermediate_decrease = options.cascade.substep_decrease = 0;
    // Section 5: distances by fast marching, roots by Franca's method.
    options.coefficients.distance = DistanceMethod::fast_marching;
    options.coefficients.root = RootMethod::franca;
    // Section 5: the plain least-squares fit over the r nearest free nodes, its Hessian used without correction, and
    // the root C(S1)^(-1/2) interpolated directly.
    options.coefficients.fit_weight = 0;
    options.coefficients.max_curvature_times_h = 0;
    options.coefficients.invert_at_point = false;
    options.coefficients.interpolation = FieldInterpolation::multilinear;
    options.cascade.refine = RefineWhere::both;
    options.coefficients.normal_mass = MassKind::consistent;
    options.coefficients.classification = Classification::absolute;
    options.coefficients.tau = 1;
    // All of the shapes counts; they begin as they lie, and nothing but the match pulls.
    options.input.buried = Burial::kept;
    options.align.mode = AlignMode::none;
    options.align.direction = MatchDirection::forward;
    options.coverage.levels = 0;
    // Section 3.1: W as it stands there.
    options.energy.terms.model("bending"_term) = "thin_shell";
    // Section 6: the simplified volume term, no other term against folds, natural boundary conditions.
    options.energy.terms.model("volume"_term) = "simplified";
    options.energy.terms.factor("barrier"_term) = 0;
    options.energy.boundary = BoundaryCondition::neumann;
    // Section 5: Fletcher-Reeves in L2 without additional restarts; alpha is halved until Armijo's rule holds and is
    // the first trial of the next iteration.
    options.solver.name = "fletcher_reeves";
    options.solver.metric = Metric::l2;
    options.solver.stop = {};
    // Bending's exponential may make the first gradient huge, so that a tolerance relative to it means nothing. The
    // decrease of the energy alone decides.
    options.solver.stop.gradient_norm = 0;
    FletcherReevesOptions& method = options.solver.fletcher_reeves;
    method.update = ConjugateUpdate::fletcher_reeves;
    method.interpolation = Interpolation::halving;
    method.initial_step = InitialStep::memory;
    method.step_growth = 1;
    method.least_cosine = 0;
    method.curvature = 0;
    method.orthogonality = 0;
    method.restart_every = 0;
  }
  return options;
}

}  // namespace shellmatch
