#include "base/error.h"
#include "matching/json/json_members.h"
#include "matching/output/summary.h"
#include "matching/output/write_file.h"

#include <fstream>

namespace shellmatch {

template <class S, class Member>
requires std::is_same_v<std::remove_const_t<S>, OneSidedDistance>
static void describe(S& s, Member&& member) {
  member("mean", s.mean);
  member("p95", s.p95);
  member("max", s.max);
}

template <class S, class Member>
requires std::is_same_v<std::remove_const_t<S>, TwoSidedDistance>
static void describe(S& s, Member&& member) {
  member("deformed_to_template", s.deformed_to_template);
  member("template_to_deformed", s.template_to_deformed);
  member("uncovered", s.uncovered);
}

template <class S, class Member>
requires std::is_same_v<std::remove_const_t<S>, DistortionSummary>
static void describe(S& s, Member&& member) {
  member("mean", s.mean);
  member("min", s.min);
  member("max", s.max);
  member("p5", s.p5);
  member("p95", s.p95);
}

template <class S, class Member>
requires std::is_same_v<std::remove_const_t<S>, FoldReport>
static void describe(S& s, Member&& member) {
  member("min_determinant", s.min_determinant);
  member("determinant_lower_bound", s.lower_bound);
  member("folded_cells", s.n_folded_cells);
  member("uncertified_cells", s.n_uncertified_cells);
  member("folded_volume", s.folded_volume);
}

template <class S, class Member>
requires std::is_same_v<std::remove_const_t<S>, BandReport>
static void describe(S& s, Member&& member) {
  member("normal_angle", s.normal_angle);
  member("folded_share", s.folded_share);
}

template <class S, class Member>
requires std::is_same_v<std::remove_const_t<S>, LibraryReport>
static void describe(S& s, Member&& member) {
  member("brief", s.brief);
  member("full", s.full);
}

template <class S, class Member>
requires std::is_same_v<std::remove_const_t<S>, LevelSummary>
static void describe(S& s, Member&& member) {
  member("level", s.level);
  member("sigma", s.sigma);
  member("nu", s.nu);
  member("volume_weight", s.volume_weight);
  member("substeps", s.n_substeps);
  member("nodes", s.n_nodes);
  member("free_nodes", s.n_free_nodes);
  member("cells", s.n_cells);
  member("band_cells", s.n_band_cells);
  member("energy_minimised", s.energy_minimised);
  member("energy", s.energy_reported);
  member("iterations", s.iterations);
  member("value_evaluations", s.value_evaluations);
  member("gradient_evaluations", s.gradient_evaluations);
  member("gradient_norm", s.gradient_norm);
  member("linear_iterations", s.linear_iterations);
  member("regularised_systems", s.regularised_systems);
  member("l2_gradient_norm", s.l2_gradient_norm);
  member("solver", s.solver);
  member("fallbacks", s.fallbacks);
  member("stop_reason", s.stop_reason);
  member("stop_message", s.stop_message);
  member("library_reports", s.library_reports);
  member("folds", s.folds);
  member("band", s.band);
  member("distance", s.distance);
}

template <class S, class Member>
requires std::is_same_v<std::remove_const_t<S>, GradientCheckSummary>
static void describe(S& s, Member&& member) {
  member("level", s.level);
  member("substep", s.substep);
  member("iteration", s.iteration);
  member("passed", s.passed);
  member("failed_terms", s.failed_terms);
  member("worst_order", s.worst_order);
  member("worst_functor_error", s.worst_functor_error);
}

template <class S, class Member>
requires std::is_same_v<std::remove_const_t<S>, ShapeSummary>
static void describe(S& s, Member&& member) {
  member("file", s.file);
  member("vertices", s.n_vertices);
  member("facets", s.n_facets);
  member("notes", s.notes);
  member("components", s.n_components);
  member("genus", s.genus);
  member("invented", s.invented);
  member("buried", s.buried);
}

template <class S, class Member>
requires std::is_same_v<std::remove_const_t<S>, PlacementSummary>
static void describe(S& s, Member&& member) {
  member("kind", s.kind);
  member("scale", s.scale);
  member("offset", s.offset);
}

template <class S, class Member>
requires std::is_same_v<std::remove_const_t<S>, AlignmentSummary>
static void describe(S& s, Member&& member) {
  member("mode", s.mode);
  member("angle", s.angle);
  member("scale", s.scale);
  member("mirrored", s.mirrored);
  member("score", s.score);
  member("margin", s.margin);
  member("tried", s.n_tried);
  member("pairs", s.n_pairs);
  member("doubtful", s.doubtful);
  member("as_it_lies", s.as_it_lies);
  member("fits_mirrored", s.fits_mirrored);
  member("landmark_distance", s.landmark_distance);
  member("landmark_trust", s.landmark_trust);
  member("predicted_from", s.n_images);
}

template <class S, class Member>
requires std::is_same_v<std::remove_const_t<S>, LandmarkSummary>
static void describe(S& s, Member&& member) {
  member("count", s.n);
  member("mean", s.mean);
  member("max", s.max);
  member("farthest", s.farthest);
  member("place", s.place);
}

template <class S, class Member>
requires std::is_same_v<std::remove_const_t<S>, DirectionSummary>
static void describe(S& s, Member&& member) {
  member("backward", s.backward);
  member("forward_distance", s.forward_distance);
  member("backward_distance", s.backward_distance);
  member("forward_energy", s.forward_energy);
  member("backward_energy", s.backward_energy);
}

template <class S, class Member>
requires std::is_same_v<std::remove_const_t<S>, RunFigures>
static void describe(S& s, Member&& member) {
  member("compiler", s.compiler);
  member("threads", s.threads);
  member("seconds", s.seconds);
  member("phase_seconds", s.phase_seconds);
  member("level_seconds", s.level_seconds);
  member("peak_memory_bytes", s.peak_memory_bytes);
  member("resumed_after", s.resumed_after);
  member("level_memory_estimates", s.level_memory_estimates);
  member("level_memory_peaks", s.level_memory_peaks);
}

template <class S, class Member>
requires std::is_same_v<std::remove_const_t<S>, VerdictReason>
static void describe(S& s, Member&& member) {
  member("what", s.what);
  member("advice", s.advice);
  member("shape", s.shape);
  member("place", s.place);
}

template <class S, class Member>
requires std::is_same_v<std::remove_const_t<S>, Verdict>
static void describe(S& s, Member&& member) {
  member("outcome", s.outcome);
  member("reasons", s.reasons);
}

template <class S, class Member>
requires std::is_same_v<std::remove_const_t<S>, MatchSummary>
static void describe(S& s, Member&& member) {
  member("version", s.version);
  member("profile", s.profile);
  member("dimension", s.dimension);
  member("interrupted", s.interrupted);
  member("reference", s.reference);
  member("template", s.template_shape);
  member("unit", s.unit);
  member("template_diagonal", s.template_diagonal);
  member("verdict", s.verdict);
  member("placement", s.placement);
  member("direction", s.direction);
  member("alignment", s.alignment);
  member("bent", s.bent);
  member("landmarks", s.landmarks);
  member("distance_before", s.distance_before);
  member("distance", s.distance);
  member("correspondence_error_before", s.correspondence_error_before);
  member("correspondence_error", s.correspondence_error);
  member("area_distortion", s.area_distortion);
  member("angle_distortion", s.angle_distortion);
  member("flipped_facets", s.n_flipped_facets);
  member("flipped_share", s.flipped_share);
  member("spin_difference", s.spin_difference);
  member("levels", s.levels);
  member("gradient_checks", s.gradient_checks);
  member("run", s.run);
}

std::string summary_json(const MatchSummary& summary) { return json_text(json_of(summary)); }

void write_summary(const MatchSummary& summary, const std::string& path) { write_file(path, summary_json(summary)); }

MatchSummary read_summary(const std::string& path) {
  std::ifstream in(path);
  if (!in) throw_input_error("{}: cannot be read; give the summary.json of an output folder", path);
  MatchSummary summary;
  try {
    set_from_json(parse_json(in), summary);
  } catch (const Json::exception& e) {
    throw_input_error("{}: no summary of a run, or damaged ({})", path, e.what());
  }
  return summary;
}

}  // namespace shellmatch
