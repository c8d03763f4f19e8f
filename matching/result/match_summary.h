#pragma once
/// \file
/// The figures of a matching: its quality and its cost.

#include "energies/assembly/band_report.h"
#include "energies/assembly/folds.h"
#include "solvers/minimizer.h"

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
  /// Share of the template's area (length) farther than 0.01 from the deformed reference, in [0, 1].
  std::optional<double> uncovered = {};
};

/// Mean and range of a ratio or an angle over the deformed surface, weighted by the reference's area.
struct DistortionSummary {
  double mean = 0, min = 0, max = 0;
  std::optional<double> p5 = {}, p95 = {};  ///< quantiles
};

struct LevelSummary {
  int level = 0;
  double sigma = 0, nu = 0, volume_weight = 0;  ///< of the level's last minimisation
  int n_substeps = 1;
  Index n_nodes = 0, n_free_nodes = 0, n_cells = 0, n_band_cells = 0;
  NamedValues energy_minimised;  ///< by term, with the quadrature that was minimised
  NamedValues energy_reported;   ///< by term, with a finer quadrature
  int iterations = 0;            ///< over all substeps, as are the evaluations
  long value_evaluations = 0, gradient_evaluations = 0;
  long linear_iterations = 0, regularised_systems = 0;  ///< of Newton's method
  double gradient_norm = 0;                             ///< at the end, in the metric of the minimisation
  double l2_gradient_norm = 0;                          ///< at the end, in L2
  std::string solver;                                   ///< method that ended the last substep
  std::string stop_reason, stop_message;  ///< of the last substep; the message is that of the method or library
  std::optional<std::vector<LibraryReport>> library_reports = {};  ///< of Ceres, by minimisation
  std::vector<std::string> fallbacks;  ///< of all substeps: method that gave up, why, and its successor
  FoldReport folds;
  BandReport band;
  std::optional<TwoSidedDistance> distance;
};

/// Share of a surface that was made up to close it from which on the shape may be a part of the other. With more, maps
/// by spectra of whole surfaces that look right are not.
inline constexpr double least_of_part = 0.02;
/// With less, it may still be a part that was cut off where it is thin, as a body at the neck.
inline constexpr double least_of_cut = 0.002;

/// Maps that are clearly the best (alignment/clear_margin.h) and score no more were right.
inline constexpr double nearly_isometric = 0.8;

/// A shape as it was read.
struct ShapeSummary {
  std::string file;
  std::size_t n_vertices = 0, n_facets = 0;      ///< of the closed surface that was matched
  std::vector<std::string> notes;                ///< repairs
  std::optional<std::size_t> n_components = {};  ///< of a thousandth of the area or more
  std::optional<int> genus = {};                 ///< sum over the components; 0 in the plane
  std::optional<double> invented = {};  ///< share of the area that was made up to close it; none where nothing was
  std::optional<double> buried =
      {};  ///< share of the area that was left out as it lies inside other parts; none where nothing was

  std::optional<bool> is_part = {};  ///< true where little was made up, and it was found to be a part of the other

  /// Whether it was found to be a part of the other shape, or so much of it was made up that it may be one.
  bool may_be_part() const { return is_part.value_or(false) || invented.value_or(0) > least_of_part; }
  bool is_measured_everywhere() const { return !invented && !buried; }
};

struct PlacementSummary {
  std::string kind;  ///< "fit" or "as-is"
  double scale = 1;  ///< x -> scale x + offset maps the user's coordinates to the unit domain
  std::vector<double> offset;
};

/// What was found out about the shapes before the cascade.
struct AlignmentSummary {
  std::string mode;             ///< as in align.mode
  double angle = 0, scale = 1;  ///< of the pose taken out of the reference; degrees, at most 180
  bool mirrored = false;
  std::optional<double> score, margin;  ///< of the map found (docs/alignment.md); no margin without a second map
  /// Where landmarks took part: the median distance from where the map takes them, in roots of the area, and the factor
  /// on their weight.
  std::optional<double> landmark_distance = {}, landmark_trust = {};
  int n_tried = 0;                        ///< maps among which trials chose; 0 where the score alone did
  int n_pairs = 0;                        ///< used in the energy or for the pose
  std::optional<double> pair_share = {};  ///< of a surface's samples for which the search found a pair
  bool doubtful = false;                  ///< not clearly the best map, or far from isometric
  bool as_it_lies = false;                ///< nothing is used then: not clearly better than the shapes as they lie
  std::optional<bool> is_of_part = {};    ///< true where one shape was searched as a part of the other
  bool fits_mirrored =
      false;  ///< the mirrored reference would fit far better; searched only where the chosen map is strange
  std::optional<int> n_images = {};  ///< earlier results that it was predicted from, without a search
};

/// How far landmarks end from where they belong, in diagonals of the template.
struct LandmarkSummary {
  std::size_t n = 0;
  double mean = 0, max = 0;
  std::string farthest;       ///< name of that with the largest distance
  std::vector<double> place;  ///< where it belongs; in the coordinates of the template's file
};

/// Which shape was deformed.
struct DirectionSummary {
  bool backward = false;
  /// With align.direction auto: sum of the mean distances both ways after a trial of each direction, in diagonals; none
  /// where it failed.
  std::optional<double> forward_distance = {}, backward_distance = {};
  std::optional<double> forward_energy = {}, backward_energy = {};  ///< at the end of these trials
};

/// Figures that differ between runs of the same experiment.
struct RunFigures {
  std::string compiler;
  int threads = 0;
  double seconds = 0;  ///< wall time of the whole run
  NamedValues phase_seconds;
  std::vector<double> level_seconds;  ///< one entry for each level
  std::uint64_t peak_memory_bytes = 0;
  /// The levels after which a stopped run was resumed; the times are then sums over all parts.
  std::optional<std::vector<int>> resumed_after = {};
  /// One entry for each level, in resident bytes: as expected before it, and the run's peak after it.
  std::optional<std::vector<double>> level_memory_estimates = {}, level_memory_peaks = {};
};

/// One check of derivatives during a run.
struct GradientCheckSummary {
  int level = 0, substep = 0, iteration = 0;
  bool passed = false;
  std::string failed_terms;        ///< separated by commas
  double worst_order = 2;          ///< order of a Taylor remainder that is farthest from 2
  double worst_functor_error = 0;  ///< relative, of gradients against the element functors
};

/// One reason for a verdict.
struct VerdictReason {
  std::string what;           ///< with the figure, as "3.4 % of the template is not reached"
  std::string advice;         ///< what to do
  std::string shape;          ///< "deformed" or "template" where there is a place
  std::vector<double> place;  ///< a point of that shape, where to look; in the coordinates of the template's file
};

/// Whether the shapes match (matching/result/verdict.h).
struct Verdict {
  std::string outcome;                 ///< "matched", "look-here" or "not-matched"
  std::vector<VerdictReason> reasons;  ///< the gravest first; none if matched
};

struct MatchSummary {
  std::string version, profile;
  int dimension = 0;
  bool interrupted = false;  ///< stopped before the last level was finished
  ShapeSummary reference, template_shape;
  PlacementSummary placement;
  std::optional<DirectionSummary> direction;
  std::optional<AlignmentSummary> alignment;
  bool bent = false;                         ///< the reference's surface was bent first: the map is one of the surface
  std::optional<LandmarkSummary> landmarks;  ///< at the end; none without landmarks
  std::optional<std::string> unit;           ///< of the coordinates (input.unit); empty where nobody has said
  std::optional<double> template_diagonal;   ///< of its bounding box, in that unit
  std::optional<Verdict> verdict;
  /// Of the undeformed and of the deformed reference.
  std::optional<TwoSidedDistance> distance_before, distance;
  /// Mean distance from the true positions, relative to the template's diagonal; none where these are unknown.
  std::optional<double> correspondence_error_before, correspondence_error;
  /// Deformed over reference area (length in the plane); 1 means no distortion.
  std::optional<DistortionSummary> area_distortion;
  /// Largest turn of a tangent direction against the principal ones in degrees, half of the largest change of an angle;
  /// 0 means no distortion; none in the plane.
  std::optional<DistortionSummary> angle_distortion;
  /// Number of facets of the deformed surface that face away from the template's.
  std::optional<std::size_t> n_flipped_facets;
  std::optional<double> flipped_share;    ///< of the reference's area (length)
  std::optional<double> spin_difference;  ///< of corresponding points (matching/result/spin_difference.h), 0 to 2
  std::vector<LevelSummary> levels;       ///< from coarse to fine
  /// Only if they were requested.
  std::optional<std::vector<GradientCheckSummary>> gradient_checks;
  RunFigures run;
};

}  // namespace shellmatch
