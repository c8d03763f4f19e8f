#pragma once
/// \file
/// The figures of a matching: did it really match, and what did it cost?

#include "energies/assembly/band_report.h"
#include "energies/assembly/folds.h"

#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace shellmatch {

/// Names and values in the order in which they are written.
using NamedValues = std::vector<std::pair<std::string, double>>;

/// Distances from one surface to another, relative to the diagonal of the template's bounding box.
struct OneSidedDistance {
  double mean = 0, p95 = 0, max = 0;
};

struct TwoSidedDistance {
  OneSidedDistance deformed_to_template, template_to_deformed;
};

/// Statistics of a ratio or an angle over the deformed surface, weighted by the reference's area.
struct DistortionSummary {
  double mean = 0, min = 0, max = 0;
};

struct LevelSummary {
  int level = 0;
  double sigma = 0, nu = 0, volume_weight = 0;  ///< of the level's last minimisation
  int n_substeps = 1;
  Index n_nodes = 0, n_free_nodes = 0, n_cells = 0, n_band_cells = 0;
  NamedValues energy_minimised;  ///< by term, with the quadrature that was minimised
  NamedValues energy_reported;   ///< by term, with a finer one
  int iterations = 0;            ///< of all substeps, as the evaluations
  long value_evaluations = 0, gradient_evaluations = 0;
  double gradient_norm = 0;               ///< at the end, in the metric of the minimisation
  double l2_gradient_norm = 0;            ///< at the end, in L2
  std::string solver;                     ///< that ended the last substep
  std::string stop_reason, stop_message;  ///< of the last substep; the message is in the method's or library's words
  std::vector<std::string> fallbacks;     ///< of all substeps: which method gave up, why, and which went on
  FoldReport folds;
  BandReport band;
  std::optional<TwoSidedDistance> distance;
};

/// A shape as it was read.
struct ShapeSummary {
  std::string file;
  std::size_t n_vertices = 0, n_facets = 0;  ///< of the closed surface that was matched
  std::vector<std::string> notes;            ///< what was mended
};

struct PlacementSummary {
  std::string kind;  ///< "fit" or "as-is"
  double scale = 1;  ///< x -> scale x + offset, user's coordinates to unit domain
  std::vector<double> offset;
};

/// All that differs from one run of the same experiment to the next.
struct RunFigures {
  std::string compiler;
  int threads = 0;
  double seconds = 0;  ///< wall time of the whole run
  NamedValues phase_seconds;
  std::vector<double> level_seconds;  ///< one for each level
  std::uint64_t peak_memory_bytes = 0;
  /// The levels after which a run that was stopped was taken up again; seconds are then those of all parts.
  std::optional<std::vector<int>> resumed_after;
};

/// One check of derivatives on the way.
struct GradientCheckSummary {
  int level = 0, substep = 0, iteration = 0;
  bool passed = false;
  std::string failed_terms;      ///< with commas
  double worst_order = 2;        ///< order of a Taylor remainder that is furthest from 2
  double worst_functor_error = 0;  ///< of gradients against the element functors, relative
};

struct MatchSummary {
  std::string version, profile;
  int dimension = 0;
  bool interrupted = false;  ///< stopped before the last level was finished
  ShapeSummary reference, template_shape;
  PlacementSummary placement;
  /// Of the undeformed and of the deformed reference.
  std::optional<TwoSidedDistance> distance_before, distance;
  /// Mean distance from the true positions where they are known, relative to the template's diagonal.
  std::optional<double> correspondence_error_before, correspondence_error;
  /// Deformed over reference area (length in the plane); 1 is none.
  std::optional<DistortionSummary> area_distortion;
  /// Degrees; 0 is none; not in the plane.
  std::optional<DistortionSummary> angle_distortion;
  /// Facets of the deformed surface that face away from the template's.
  std::optional<std::size_t> n_flipped_facets;
  std::vector<LevelSummary> levels;  ///< from coarse to fine
  /// Where they were asked for.
  std::optional<std::vector<GradientCheckSummary>> gradient_checks;
  RunFigures run;
};

}  // namespace shellmatch
