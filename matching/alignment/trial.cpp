#include "matching/alignment/trial.h"

#include "alignment/bend/bend_by_pairs.h"
#include "base/error.h"
#include "base/parallel.h"
#include "base/stop.h"
#include "geometry/repair/repair_steps.h"
#include "grid/fields/interpolation.h"
#include "matching/alignment/known_pairs.h"
#include "matching/cascade/cascade.h"
#include "matching/cascade/schedule.h"
#include "matching/experiment/level_solver.h"
#include "matching/level/paired_parts.h"
#include "matching/result/figures.h"
#include "matching/result/reference_map.h"
#include "matching/result/spin_difference.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>

namespace shellmatch {

namespace {

// Steps of a trial for those who wait, by their share of the time: preparing, minimisations, measuring.
constexpr std::size_t steps_before = 2, steps_of_level = 2, steps_after = 4;

/// Shows nothing of a trial but how far it is.
class TrialObserver final : public Observer {
 public:
  TrialObserver(Observer& of_run, Activity& activity) : of_run_(of_run), activity_(activity) {}
  void minimisation_started(const LevelStart& start) override {
    if (start.substep == 1) activity_.next(steps_of_level);
  }
  bool iterated(const LevelStart&, const IterationRecord&) override {
    of_run_.trial_iterated();
    return true;
  }

 private:
  Observer& of_run_;
  Activity& activity_;
};

// Wrong starts fight the barrier against folds for hundreds of iterations; their energies are large enough before.
constexpr int most_trial_iterations = 80;
// Of starts that differ little the distances decide.
constexpr std::size_t n_measured = 100'000;
// A cell of coarse grids is a hundred facets of these wide.
constexpr std::size_t most_tried_facets = 200'000, n_vertices_of_large = 20'000;

ExperimentOptions trial_options(const ExperimentOptions& options) {
  ExperimentOptions trial = options;
  trial.cascade.max_level = std::min(options.cascade.max_level, options.cascade.min_level + 1);
  trial.coverage.levels = 0;
  trial.check_gradient.every = 0;
  for (int level = trial.cascade.min_level; level <= trial.cascade.max_level; ++level) {
    const SolverOptions solver = solver_at_level(options.solver, level);
    LevelOverrides::Entry own{level, level, {}};  // the last entry counts
    own.set("stop.max_iterations", {std::min(solver.stop.max_iterations, most_trial_iterations)});
    own.set("stop.relative_decrease", {relative_decrease(options.cascade, solver, Followed::by_level)});
    trial.solver.levels.entries.push_back(std::move(own));
  }
  return trial;
}

// The file's own vertices and faces take no part in a trial.
template <int Dim>
Shape<Dim> tried_shape(const Shape<Dim>& shape) {
  Shape<Dim> tried;
  tried.source = shape.source;
  tried.surface = shape.surface;
  tried.evidence = shape.evidence;
  tried.invented_share = shape.invented_share;
  tried.buried_share = shape.buried_share;
  if (tried.surface.facets.size() <= most_tried_facets) tried.crossing = shape.crossing;
  if constexpr (Dim == 3)
    for (Surface<3>* surface : {&tried.surface, &tried.evidence.observed, &tried.evidence.unobserved})
      if (surface->facets.size() > most_tried_facets) *surface = simplified(*surface, n_vertices_of_large);
  return tried;
}

// In roots of the area (lengths) of the shape that is not deformed.
constexpr double far = 0.05;

template <int Dim>
double missed_share(const Alignment<Dim>& start, const CascadeResult<Dim>& end, const Similarity<Dim>& placement,
                    const SignedDistance<Dim>& fixed) {
  const MapFrame<Dim> frame{placement, start.pose, false, Space::unsaid, start.bend};
  const double most = far * std::pow(surface_measure(fixed.surface()), 1.0 / (Dim - 1));
  double sum = 0, missed = 0;
  for (const Landmark<Dim>& pair : start.pairs) {
    sum += pair.weight;
    const Vec<Dim> image = evaluate(end.grid, end.phi, frame.to_unit_domain(pair.on_reference));
    if ((image - placement(pair.on_template)).norm() > most) missed += pair.weight;
  }
  return sum > 0 ? missed / sum : 0;
}

}  // namespace

Alignment<3> bent_start(Alignment<3> alignment, const Surface<3>& surface, const std::vector<Landmark<3>>& landmarks) {
  const Similarity<3>& pose = alignment.pose;
  Surface<3> posed = surface;
  for (Vec<3>& x : posed.vertices) x = pose(x);
  std::vector<CorrespondingPoints> pairs;
  for (const auto* list : {&std::as_const(alignment.pairs), &landmarks})
    for (const Landmark<3>& l : *list) pairs.push_back({pose(l.on_reference), l.on_template, l.weight});
  std::vector<Vec<3>> bent = bend_by_pairs(posed, pairs);
  for (Vec<3>& x : bent) x = pose.inverse(x);
  alignment.bend = std::make_shared<const SurfaceBend<3>>(surface, std::move(bent));
  return alignment;
}

template <int Dim>
const ShapePair<Dim>& Trials<Dim>::tried_shapes() const {
  if (!tried_) {
    ShapePair<Dim> tried;
    for_both([&](int s) {
      if (s == 0) tried.reference = tried_shape(shapes_->reference);
      else tried.template_shape = tried_shape(shapes_->template_shape);
    });
    tried_ = std::make_shared<const ShapePair<Dim>>(std::move(tried));
  }
  return *tried_;
}

template <int Dim>
Trials<Dim> Trials<Dim>::of_exchanged_shapes() const {
  Trials others = *this;
  const ShapePair<Dim>& tried = tried_shapes();
  others.shapes_ = nullptr;
  others.tried_ = std::make_shared<const ShapePair<Dim>>(ShapePair<Dim>{tried.template_shape, tried.reference});
  others.landmarks_ = exchanged(landmarks_);
  if (limbs_) others.limbs_ = std::make_shared<const std::array<LimbEnds, 2>>(std::array{(*limbs_)[1], (*limbs_)[0]});
  others.as_they_lie_.reset();
  return others;
}

// Calls measure(result of a cascade with these options, M1, M2, what is known of both, placement), in the unit domain,
// unless this start is none.
template <int Dim>
template <class Measure>
void Trials<Dim>::run(const Alignment<Dim>& searched, const ExperimentOptions& options, const Measure& measure) const {
  const ExperimentOptions trial = trial_options(options);
  Alignment<Dim> start = searched;
  // Energies are comparable only with the same weight of landmarks.
  if (start.landmark_trust) start.landmark_trust = 1;
  ShapePair<Dim> placed = tried_shapes();
  const int n_levels = trial.cascade.max_level - trial.cascade.min_level + 1;
  Activity activity(trials_activity, steps_before + steps_of_level * static_cast<std::size_t>(n_levels) + steps_after);
  activity.next(steps_before);
  try {
    const Similarity<Dim> placement = placed.place(options, start.pose, start.bend.get());
    const SignedDistance<Dim> d1(placed.reference.surface, placed.reference.crossing),
        d2(placed.template_shape.surface, placed.template_shape.crossing);
    const ObservedPair<Dim> observed = observed_pair(placed.reference, placed.template_shape);
    const std::vector<PairSet<Dim>> pairs = known_pairs<Dim>(landmarks_, start, trial, placement, d1, d2);
    TrialObserver silent(observer_, activity);
    PhaseSeconds seconds;
    const ObservedPair<Dim> matched =
        start.is_of_part ? paired_parts(observed, placed.reference, placed.template_shape, pairs) : observed;
    const CascadeResult<Dim> end = run_cascade<Dim>(d1, d2, trial, silent, {}, seconds, {}, pairs, matched);
    activity.next(steps_after);
    if (std::isfinite(end.levels.back().minimised.sum())) measure(end, d1, d2, observed, placement);
  } catch (const InputError&) {  // no place in the domain, or no finite energy
  }
}

template <int Dim>
double Trials<Dim>::limb_disorder(const Alignment<Dim>& start, const CascadeResult<Dim>& end,
                                  const Similarity<Dim>& placement) const {
  if constexpr (Dim == 3) {
    const ShapePair<3>& tried = tried_shapes();
    if (start.is_of_part || tried.one_is_part()) return 0;
    if (!limbs_) {
      std::array<LimbEnds, 2> limbs;
      for_both([&](int s) {
        limbs[static_cast<std::size_t>(s)] =
            limb_ends((s == 0 ? tried.reference : tried.template_shape).surface, options_.align.search);
      });
      limbs_ = std::make_shared<const std::array<LimbEnds, 2>>(std::move(limbs));
    }
    const auto& [reference, template_shape] = *limbs_;
    // The limbs of one component of several say nothing of the others.
    constexpr double least_share = 0.9;
    if (std::min(reference.share, template_shape.share) < least_share) return 0;
    std::vector<Vec<3>> images(reference.vertices.size()), places;
    const MapFrame<3> frame{placement, start.pose, false, Space::unsaid, start.bend};
    parallel_for(images.size(), [&](std::size_t i) {
      images[i] = evaluate(end.grid, end.phi, frame.to_unit_domain(reference.vertices[i]));
    });
    for (const Vec<3>& x : template_shape.vertices) places.push_back(placement(x));
    return shellmatch::limb_disorder(reference, images, template_shape, places);
  } else {
    return 0;
  }
}

template <int Dim>
Trial Trials<Dim>::operator()(const Alignment<Dim>& start) const {
  const auto compute = [&] { return try_start(start); };
  return findings_ != nullptr ? findings_->starts.next(compute) : compute();
}

template <int Dim>
Trial Trials<Dim>::bent(const Alignment<Dim>& start) const {
  if constexpr (Dim == 3)
    if (!start.pairs.empty()) return (*this)(bent_start(start, tried_shapes().reference.surface, landmarks_));
  return (*this)(start);
}

template <int Dim>
DirectionTrial Trials<Dim>::of_direction(const Alignment<Dim>& start, Carried carried) const {
  const auto compute = [&] { return try_direction(start, carried); };
  return findings_ != nullptr ? findings_->directions.next(compute) : compute();
}

template <int Dim>
Trial Trials<Dim>::try_start(const Alignment<Dim>& start) const {
  Trial result;
  // All in the same band: energies with and without pairs are compared.
  run(start, options_,
      [&](const CascadeResult<Dim>& end, const SignedDistance<Dim>& d1, const SignedDistance<Dim>& d2,
          const ObservedPair<Dim>& observed, const Similarity<Dim>& placement) {
        const TermValues& terms = end.levels.back().minimised;
        result.with_pairs = terms.sum();
        const std::vector<std::string>& names = end.levels.back().term_names;
        const auto alignment = static_cast<std::size_t>(std::ranges::find(names, "alignment") - names.begin());
        result.energy = result.with_pairs - (alignment < names.size() ? terms[alignment] : 0);
        const auto deform = [&](const Surface<Dim>& surface) { return deformed_surface(surface, end.grid, end.phi); };
        const ShapePair<Dim>& tried = tried_shapes();
        const Surface<Dim> undeformed =
            start.bend ? transformed(tried.reference.surface, start.pose, placement) : d1.surface();
        result.spin_difference = spin_difference<Dim>(undeformed, deform(d1.surface()), d2.surface(), observed,
                                                      start.is_of_part || tried.one_is_part());
        result.limb_disorder = limb_disorder(start, end, placement);
        result.template_distance =
            two_sided_distance<Dim>(d1.surface(), deform, d2, observed, end.grid.finest_side(), n_measured)
                .figures.template_to_deformed.mean;
      });
  return result;
}

template <int Dim>
DirectionTrial Trials<Dim>::try_direction(const Alignment<Dim>& start, Carried carried) const {
  DirectionTrial result;
  run(start, cascade_options(options_, start),
      [&](const CascadeResult<Dim>& end, const SignedDistance<Dim>& d1, const SignedDistance<Dim>& d2,
          const ObservedPair<Dim>& observed, const Similarity<Dim>& placement) {
        const bool forward = carried == Carried::reference;
        std::optional<InverseCarrier<Dim>> inverse;
        if (!forward) inverse.emplace(d1.surface(), end.grid, end.phi);
        const auto deform = [&](const Surface<Dim>& surface) {
          return inverse ? (*inverse)(surface) : deformed_surface(surface, end.grid, end.phi);
        };
        const SignedDistance<Dim>&carried_shape = forward ? d1 : d2, &other = forward ? d2 : d1;
        const TwoSidedDistance figures =
            two_sided_distance<Dim>(carried_shape.surface(), deform, other, forward ? observed : exchanged(observed),
                                    end.grid.finest_side(), n_measured)
                .figures;
        result.distance = figures.template_to_deformed.mean + figures.deformed_to_template.mean;
        const ShapePair<Dim>& tried = tried_shapes();
        if (start.is_of_part || tried.one_is_part()) {  // the rest of the whole is not reached from either side
          const bool deformed_is_part = tried.reference.invented_share > tried.template_shape.invented_share;
          result.distance =
              2 * (deformed_is_part == forward ? figures.deformed_to_template.mean : figures.template_to_deformed.mean);
        }
        result.energy = end.levels.back().minimised.sum();
        result.missed = 0;
        if (!start.bend && lie_near(d1, d2)) return;
        result.missed = missed_share(start, end, placement, d2);
        result.limb_disorder = limb_disorder(start, end, placement);
      });
  return result;
}

template <int Dim>
const Trial& Trials<Dim>::as_they_lie() {
  if (!as_they_lie_) as_they_lie_ = (*this)({});
  return *as_they_lie_;
}

template class Trials<2>;
template class Trials<3>;

}  // namespace shellmatch
