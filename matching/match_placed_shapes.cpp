#include "matching/match_placed_shapes.h"

#include "base/stop.h"
#include "geometry/distance/surface_distance.h"
#include "geometry/surface/topology.h"
#include "matching/alignment/known_pairs.h"
#include "matching/level/paired_parts.h"
#include "matching/progress/process_info.h"
#include "matching/result/deformed_shape.h"
#include "matching/result/figures.h"
#include "matching/result/own_limb.h"
#include "matching/result/reference_map.h"
#include "matching/result/spin_difference.h"
#include "matching/result/verdict.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace shellmatch {

namespace {

/// Smaller components are crumbs of closing and repairs.
constexpr double least_component = 1e-3;
/// In diagonals of the template: what ends farther from a part is not in it.
constexpr double beside_part = 0.03;

template <int Dim>
ShapeSummary shape_summary(const Shape<Dim>& shape) {
  const Topology parts = topology(shape.surface, least_component);
  return {shape.source,
          shape.surface.vertices.size(),
          shape.surface.facets.size(),
          shape.notes,
          parts.n_components,
          parts.genus,
          shape.invented_share > 0 ? std::optional(shape.invented_share) : std::nullopt,
          shape.buried_share > 0 ? std::optional(shape.buried_share) : std::nullopt};
}

void add_level_figure(std::optional<std::vector<double>>& list, double entry) {
  if (!list) list.emplace();
  list->push_back(entry);
}

/// One matching, from the shapes in the unit domain to the result.
template <int Dim>
class Matching {
 public:
  Matching(MatchInputs<Dim> inputs, const ExperimentOptions& options, Recorder& recorder, RunClock& clock)
      : inputs_(std::move(inputs)),
        options_(cascade_options(options, inputs_.prepared.alignment)),
        recorder_(recorder),
        clock_(clock),
        observed_(observed_pair(moving_, fixed_)),
        parts_(observed_of_result().reference, reference_.surface, observed_of_result().template_shape),
        d1_(distance_of(moving_)),
        d2_(distance_of(fixed_)) {}

  MatchResult<Dim> run() {
    summary_.reference = shape_summary(reference_);
    summary_.template_shape = shape_summary(template_);
    summary_.unit = unit();
    summary_.template_diagonal =
        bounding_box(template_.surface.vertices).diagonal() /
        (inputs_.prepared.placement.scale * (is_backward_ ? inputs_.prepared.alignment.pose.scale : 1));
    const auto as_it_lies = [](const Surface<Dim>& surface) { return surface; };
    summary_.distance_before = two_sided_distance<Dim>(unbent_, as_it_lies, template_distance_, observed_of_result(),
                                                       std::ldexp(1.0, -options_.cascade.min_level), on_the_way)
                                   .figures;
    summary_.alignment = inputs_.prepared.alignment.summary;
    if (summary_.alignment && summary_.alignment->is_of_part.value_or(false))
      for (ShapeSummary* shape : {&summary_.reference, &summary_.template_shape})
        if (shape->invented.value_or(0) > least_of_cut) shape->is_part = true;
    if (const std::optional<std::string> warning = far_apart_warning(summary_)) recorder_.warn(*warning);
    std::vector<PairSet<Dim>> pairs = inputs_.pairs;
    for (PairSet<Dim>& set : known_pairs(is_backward_ ? exchanged(inputs_.landmarks) : inputs_.landmarks,
                                         inputs_.prepared.alignment, options_, inputs_.prepared.placement, d1_, d2_))
      pairs.push_back(std::move(set));
    for (const PairSet<Dim>& set : pairs) recorder_.history.term_names.push_back(set.name);
    if (has_coverage(options_)) recorder_.history.term_names.emplace_back("coverage");
    else if (options_.coverage.levels > 0)
      recorder_.note(
          "coverage acts on no level, as cascade.min_level is cascade.max_level: the match is one-sided "
          "(docs/landmarks.md)");
    std::optional<FinishedLevel<Dim>> finished = resume();
    recorder_.stage("matching");
    auto result = run_cascade<Dim>(
        d1_, d2_, options_, recorder_,
        [&](const LevelResult& level, const LevelState<Dim>& state) { finish_level(level, state); }, clock_.phases,
        std::move(finished), pairs, matched_parts(pairs));
    summary_.interrupted = result.interrupted;
    recorder_.stage("measuring");
    PhaseClock phase(clock_.phases);
    phase.start("output");
    MatchResult<Dim> complete = make_result(std::move(result));
    phase.stop();
    complete.summary = summary_so_far();
    complete.summary.verdict = judge(complete.summary, places_);
    complete.history = std::move(recorder_.history);
    return complete;
  }

 private:
  static SignedDistance<Dim> distance_of(const Shape<Dim>& shape) {
    return SignedDistance<Dim>(shape.surface, shape.crossing);
  }

  // Restores history, checks, times and levels of an earlier matching, which become part of this one's result.
  std::optional<FinishedLevel<Dim>> resume() {
    if (!inputs_.checkpoint) return std::move(inputs_.start);
    MatchSummary& s = inputs_.checkpoint->summary;
    const int level = s.levels.back().level;
    recorder_.history = std::move(inputs_.checkpoint->history);
    recorder_.gradient_checks = s.gradient_checks.value_or(std::vector<GradientCheckSummary>{});
    clock_.add_earlier(s.run);
    summary_.levels = std::move(s.levels);
    summary_.run = std::move(s.run);
    summary_.run.resumed_after = summary_.run.resumed_after.value_or(std::vector<int>{});
    summary_.run.resumed_after->push_back(level);
    if (options_.report) levels_ = std::move(inputs_.checkpoint->levels);
    return FinishedLevel<Dim>{level, std::move(inputs_.checkpoint->map)};
  }

  void finish_level(const LevelResult& level, const LevelState<Dim>& state) {
    const auto& rows = recorder_.history.rows;
    LevelSummary s = level_summary(level, rows.empty() ? IterationRecord{} : rows.back().record);
    const ReferenceMap<Dim> carry = reference_map(state.grid, state.phi);
    const Surface<Dim> deformed = carry(reference_.surface);
    if (options_.report) levels_.push_back({s.level, deformed.vertices});
    const bool is_last = s.level == options_.cascade.max_level;
    if (is_last || options_.report) s.distance = measure_distance(carry, is_last ? all_points : on_the_way);
    summary_.levels.push_back(std::move(s));
    summary_.run.level_seconds.push_back(level.seconds);
    if (const std::optional<std::string> warning = stuck_warning(summary_.levels)) recorder_.warn(*warning);
    add_level_figure(summary_.run.level_memory_estimates, level.memory_estimate);
    add_level_figure(summary_.run.level_memory_peaks, level.memory_peak);
    if (inputs_.finished)
      inputs_.finished({level, state, inputs_.shapes, inputs_.prepared, deformed, vertex_distances(deformed),
                        summary_so_far(), recorder_.history, levels_});
  }

  ReferenceMap<Dim> reference_map(const Octree<Dim>& grid, const std::vector<Vec<Dim>>& phi) const {
    return {is_backward_ ? &d1_.surface() : nullptr, grid, phi};
  }

  // The distances, and where they are greatest.
  TwoSidedDistance measure_distance(const ReferenceMap<Dim>& carry, std::size_t most_points) {
    const LocatedDistance<Dim> distance = two_sided_distance<Dim>(
        reference_.surface, [&](const Surface<Dim>& surface) { return carry(surface); }, template_distance_,
        observed_of_result(), carry.finest_side(), most_points);
    places_.deformed = coordinates_of_template(distance.farthest_of_deformed);
    places_.template_shape = coordinates_of_template(distance.farthest_of_template);
    return distance.figures;
  }

  // What the energy is of.
  ObservedPair<Dim> matched_parts(const std::vector<PairSet<Dim>>& pairs) const {
    return inputs_.prepared.alignment.is_of_part ? paired_parts(observed_, moving_, fixed_, pairs) : observed_;
  }

  // Of the surface that is carried, and of the template.
  ObservedPair<Dim> observed_of_result() const { return is_backward_ ? exchanged(observed_) : observed_; }

  // The user's word, or that of the files.
  std::string unit() const {
    if (!options_.input.unit.empty()) return options_.input.unit;
    const std::string &a = reference_.unit, &b = template_.unit;
    if (!a.empty() && !b.empty() && a != b)
      recorder_.warn(fmt::format("{} is in {}, {} in {}: they are matched as if the units were the same",
                                 reference_.source, a, template_.source, b));
    if (!b.empty() || a.empty()) return b;
    // Results are in the coordinates of the template. Shapes of one kind that differ as units do are not in one.
    const double ratio =
        bounding_box(template_.original.vertices).diagonal() / bounding_box(reference_.original.vertices).diagonal();
    if (ratio > 0.1 && ratio < 10) return a;
    recorder_.warn(fmt::format("{} is in {}; {} names no unit and is {:.3g} times as large: results are in its unit",
                               reference_.source, a, template_.source, ratio));
    return "";
  }

  static void leave_out(std::vector<double>& distances, const std::vector<char>& measured) {
    for (std::size_t v = 0; v < measured.size(); ++v)
      if (!measured[v]) distances[v] = std::numeric_limits<double>::quiet_NaN();
  }

  // Of the deformed vertices; NaN where a shape has no data.
  std::vector<double> vertex_distances(const Surface<Dim>& deformed) const {
    std::vector<double> distances = distances_to(deformed.vertices, template_distance_);
    leave_out(distances, parts_.of_deformed(deformed));
    return distances;
  }

  // Tells the vertices of both results at which the other shape has data from those at which it was made up.
  void add_observed(OriginalShape<Dim>& moved, OriginalShape<Dim>& covered, const Deformation<Dim>& map,
                    const Surface<Dim>& deformed) const {
    // A result that is used as a reference has those of its own matching.
    std::erase_if(moved.attributes, [](const VertexAttribute& a) { return a.name == "template_observed"; });
    std::erase_if(covered.attributes, [](const VertexAttribute& a) { return a.name == "deformed_observed"; });
    if (parts_.is_all()) return;
    const auto add = [&](OriginalShape<Dim>& shape, const std::string& name, const auto& is_observed) {
      VertexAttribute attribute{name, "uchar", std::vector<double>(shape.vertices.size())};
      for (std::size_t v = 0; v < shape.vertices.size(); ++v) attribute.values[v] = is_observed(v) ? 1 : 0;
      set_attribute(shape, std::move(attribute));
    };
    const ObservedPart<Dim> of_template = observed_of_result().template_shape;
    const auto unit = [&](const Vec<Dim>& y) {
      return map.placement(is_backward_ ? inputs_.prepared.alignment.pose(y) : y);
    };
    add(moved, "template_observed", [&](std::size_t v) { return of_template.contains(unit(moved.vertices[v])); });
    std::vector<Vec<Dim>> points;
    for (const Vec<Dim>& y : covered.vertices) points.push_back(unit(y));
    const std::vector<char> observed = parts_.near_observed(points, deformed);
    add(covered, "deformed_observed", [&](std::size_t v) { return observed[v] != 0; });
  }

  std::vector<double> coordinates_of_template(const Vec<Dim>& in_unit_domain) const {
    Vec<Dim> y = inputs_.prepared.placement.inverse(in_unit_domain);
    if (is_backward_) y = inputs_.prepared.alignment.pose.inverse(y);  // it has moved the template
    return {y.begin(), y.end()};
  }

  // With the distances of the deformed vertices.
  void add_distortions(const Surface<Dim>& deformed, const std::vector<double>& distances) {
    std::vector<char> facets = parts_.of_facets(reference_.surface, deformed);
    if (summary_.template_shape.may_be_part()) {
      const double most = beside_part * bounding_box(template_.surface.vertices).diagonal();
      for (std::size_t f = 0; f < facets.size(); ++f)
        if (std::ranges::any_of(deformed.facets[f], [&](Index v) { return distances[v] > most; })) facets[f] = 0;
    }
    const Surface<Dim> undeformed = measured_facets(unbent_, facets), after = measured_facets(deformed, facets);
    add_distortion(summary_, undeformed, after, template_distance_);
    places_.distorted = coordinates_of_template(most_distorted_place(undeformed, after));
  }

  void add_correspondence_error(const OriginalShape<Dim>& moved) {
    if (inputs_.truth.empty()) return;
    const double diagonal = bounding_box(template_.original.vertices).diagonal();
    summary_.correspondence_error_before = correspondence_error(inputs_.truth, reference_.original.vertices) / diagonal;
    summary_.correspondence_error = correspondence_error(inputs_.truth, moved.vertices) / diagonal;
  }

  // In the direction in which phi was solved.
  void add_landmark_distances(const Deformation<Dim>& map) {
    if (inputs_.landmarks.empty()) return;
    const double diagonal = *summary_.template_diagonal * (is_backward_ ? inputs_.prepared.alignment.pose.scale : 1);
    LandmarkSummary& s = summary_.landmarks.emplace();
    s.n = inputs_.landmarks.size();
    s.max = -1;
    for (const Landmark<Dim>& l : inputs_.landmarks) {
      const Vec<Dim>&from = is_backward_ ? l.on_template : l.on_reference,
            &to = is_backward_ ? l.on_reference : l.on_template;
      const double distance = (map.apply(from) - to).norm() / diagonal;
      s.mean += distance / static_cast<double>(s.n);
      if (distance <= s.max) continue;
      s.max = distance;
      s.farthest = l.name;
      s.place.assign(l.on_template.begin(), l.on_template.end());
    }
  }

  // The vertices of the file, moved onto the template, on their own limbs.
  std::vector<Vec<Dim>> carried_original(const ReferenceMap<Dim>& carry, const Deformation<Dim>& map) {
    const std::vector<Vec<Dim>>& as_read = reference_.original.vertices;
    std::vector<Vec<Dim>> carried = carry.carried(as_read, map, reference_.surface);
    if constexpr (Dim == 3) {
      const std::size_t n = lay_on_own_limbs(inputs_.prepared.frame(), inputs_.prepared.alignment.pairs,
                                             {unbent_, template_.surface}, as_read, carried);
      if (n > 0)
        recorder_.note(
            fmt::format("{:.2g} % of the vertices lay next to another limb than their own, which deformed.ply corrects",
                        100.0 * static_cast<double>(n) / static_cast<double>(as_read.size())));
    }
    return carried;
  }

  // The result without summary and history.
  MatchResult<Dim> make_result(CascadeResult<Dim> cascade) {
    Activity measuring("measuring", 6);
    measuring.next();
    Deformation<Dim> map{inputs_.prepared.frame(), std::move(cascade.grid), std::move(cascade.phi)};
    const ReferenceMap<Dim> carry =
        reference_map(map.grid, map.phi);  // not to be used once the map moves into the result
    Surface<Dim> deformed = carry(reference_.surface);
    summary_.distance = summary_.levels.back().distance;
    if (!levels_.empty()) levels_.pop_back();  // the last one is `deformed`
    // An earlier run had done all levels, and keeps no places; one that is stopped without a page has no distance yet.
    if (places_.deformed.empty()) {
      const TwoSidedDistance measured = measure_distance(carry, all_points);
      if (!summary_.distance) summary_.distance = measured;
    }
    std::vector<double> distance = vertex_distances(deformed);
    add_distortions(deformed, distance);
    add_landmark_distances(map);
    measuring.next(3);
    summary_.spin_difference =
        spin_difference<Dim>(unbent_, deformed, template_.surface, observed_of_result(),
                             summary_.reference.may_be_part() || summary_.template_shape.may_be_part());
    measuring.next();
    OriginalShape<Dim> moved =
        deformed_original(reference_.original, carried_original(carry, map), map, template_distance_);
    moved.space = map.space;
    add_correspondence(moved, template_.original, map.placement);
    add_correspondence_error(moved);
    measuring.next();
    const SignedDistance<Dim> deformed_distance(deformed);
    OriginalShape<Dim> covered = template_with_distance(template_.original, map, deformed_distance);
    add_observed(moved, covered, map, deformed);
    std::vector<double> template_distance = distances_to(template_.surface.vertices, deformed_distance);
    leave_out(template_distance, parts_.of_template(template_.surface.vertices, deformed));
    return {.map = std::move(map),
            .deformed = std::move(moved),
            .template_shape = std::move(covered),
            .summary = {},
            .history = {},
            .surfaces = {unbent_, template_.surface, std::move(deformed), std::move(distance),
                         std::move(template_distance)},
            .levels = std::move(levels_),
            .moving_fields = std::move(cascade.moving_fields),
            .target_fields = std::move(cascade.target_fields)};
  }

  MatchSummary summary_so_far() const {
    MatchSummary s = summary_;
    s.version = program_version();
    s.profile = enum_name(options_.profile);
    s.dimension = Dim;
    s.placement = {std::string(enum_name(options_.input.placement)),
                   inputs_.prepared.placement.scale,
                   {inputs_.prepared.placement.offset.begin(), inputs_.prepared.placement.offset.end()}};
    s.direction = inputs_.prepared.direction;
    s.bent = inputs_.prepared.alignment.bend != nullptr;
    if (options_.check_gradient.every > 0) s.gradient_checks = recorder_.gradient_checks;
    clock_.state(s.run);
    return s;
  }

  static constexpr std::size_t all_points = std::numeric_limits<std::size_t>::max();

  MatchInputs<Dim> inputs_;
  const Shape<Dim>&reference_ = inputs_.shapes.reference, &template_ = inputs_.shapes.template_shape;
  const Surface<Dim>& unbent_ = inputs_.prepared.alignment.bend ? inputs_.prepared.unbent : reference_.surface;
  const ExperimentOptions options_;
  Recorder& recorder_;
  RunClock& clock_;
  const bool is_backward_ = inputs_.prepared.is_backward();
  const Shape<Dim>&moving_ = is_backward_ ? template_ : reference_,  // phi deforms it
      &fixed_ = is_backward_ ? reference_ : template_;
  const ObservedPair<Dim> observed_;  // of moving_ and fixed_
  const MeasuredParts<Dim> parts_;
  SignedDistance<Dim> d1_, d2_;  // of moving_ and fixed_
  const SignedDistance<Dim>& template_distance_ = is_backward_ ? d1_ : d2_;
  MatchSummary summary_;
  std::vector<LevelVertices<Dim>> levels_;
  VerdictPlaces places_;  ///< after the last level
};

}  // namespace

template <int Dim>
MatchResult<Dim> match_placed_shapes(MatchInputs<Dim> inputs, const ExperimentOptions& options, Recorder& recorder,
                                     RunClock& clock) {
  return Matching<Dim>(std::move(inputs), options, recorder, clock).run();
}

SHELLMATCH_2D_3D(match_placed_shapes);

}  // namespace shellmatch
