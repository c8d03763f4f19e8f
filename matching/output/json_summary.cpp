#include "base/error.h"
#include "matching/json/json_members.h"
#include "matching/output/summary.h"
#include "matching/output/write_file.h"

#include <fstream>

namespace shellmatch {

SHELLMATCH_JSON(OneSidedDistance, mean, p95, max)
SHELLMATCH_JSON(TwoSidedDistance, deformed_to_template, template_to_deformed, uncovered)
SHELLMATCH_JSON(DistortionSummary, mean, min, max, p5, p95)
SHELLMATCH_JSON(FoldReport, min_determinant, (lower_bound, determinant_lower_bound), (n_folded_cells, folded_cells),
                (n_uncertified_cells, uncertified_cells), folded_volume)
SHELLMATCH_JSON(BandReport, normal_angle, folded_share)
SHELLMATCH_JSON(LibraryReport, brief, full)
SHELLMATCH_JSON(LevelSummary, level, sigma, nu, volume_weight, (n_substeps, substeps), (n_nodes, nodes),
                (n_free_nodes, free_nodes), (n_cells, cells), (n_band_cells, band_cells), energy_minimised,
                (energy_reported, energy), iterations, value_evaluations, gradient_evaluations, gradient_norm,
                linear_iterations, regularised_systems, l2_gradient_norm, solver, fallbacks, stop_reason, stop_message,
                library_reports, folds, band, distance)
SHELLMATCH_JSON(GradientCheckSummary, level, substep, iteration, passed, failed_terms, worst_order, worst_functor_error)
SHELLMATCH_JSON(ShapeSummary, file, (n_vertices, vertices), (n_facets, facets), notes, (n_components, components),
                genus, invented, buried, (is_part, part))
SHELLMATCH_JSON(PlacementSummary, kind, scale, offset)
SHELLMATCH_JSON(AlignmentSummary, mode, angle, scale, mirrored, score, margin, (n_tried, tried), (n_pairs, pairs),
                pair_share, doubtful, as_it_lies, (is_of_part, of_part), fits_mirrored, landmark_distance,
                landmark_trust, (n_images, predicted_from))
SHELLMATCH_JSON(LandmarkSummary, (n, count), mean, max, farthest, place)
SHELLMATCH_JSON(DirectionSummary, backward, forward_distance, backward_distance, forward_energy, backward_energy)
SHELLMATCH_JSON(RunFigures, compiler, threads, seconds, phase_seconds, level_seconds, peak_memory_bytes, resumed_after,
                level_memory_estimates, level_memory_peaks)
SHELLMATCH_JSON(VerdictReason, what, advice, shape, place)
SHELLMATCH_JSON(Verdict, outcome, reasons)
SHELLMATCH_JSON(MatchSummary, version, profile, dimension, interrupted, reference, (template_shape, template), unit,
                template_diagonal, verdict, placement, direction, alignment, bent, landmarks, distance_before, distance,
                correspondence_error_before, correspondence_error, area_distortion, angle_distortion,
                (n_flipped_facets, flipped_facets), flipped_share, spin_difference, levels, gradient_checks, run)

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
