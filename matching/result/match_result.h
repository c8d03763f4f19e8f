#pragma once
/// \file
/// The result of a matching, as values that refer to nothing else. matching/write_result.h writes them to files.

#include "geometry/surface/surface.h"
#include "grid/fits/curvature.h"
#include "matching/level/deformation.h"
#include "matching/result/match_summary.h"
#include "solvers/minimizer.h"

#include <string>
#include <variant>
#include <vector>

namespace shellmatch {

/// One accepted step. `substep` counts the minimisations of a level, with decreasing nu, from 1.
struct HistoryRow {
  int level = 0, substep = 0;
  double nu = 0;
  IterationRecord record;
};

/// All steps; `term_names` are the names of IterationRecord::terms.
struct History {
  std::vector<std::string> term_names;
  std::vector<HistoryRow> rows;
};

/// The closed surfaces that were matched, in the unit domain.
template <int Dim>
struct MatchedSurfaces {
  Surface<Dim> reference, template_shape;
  Surface<Dim> deformed;  ///< vertex by vertex the image of `reference`
  std::vector<double>
      distance;  ///< of each vertex of `deformed` to `template_shape`, >= 0; NaN where a shape has no data
  std::vector<double> template_distance;  ///< the same of each vertex of `template_shape` to `deformed`
};

/// The deformed reference at the end of a level but the last.
template <int Dim>
struct LevelVertices {
  int level = 0;
  std::vector<Vec<Dim>> vertices;  ///< of MatchedSurfaces::reference, in the unit domain
};

template <int Dim>
struct MatchResult {
  /// The map phi. PointMap(map, Toward::template_shape) carries points of the reference, in the coordinates of the
  /// given shapes; it is `map.apply(x)` unless the matching was solved backward (align.direction).
  Deformation<Dim> map;
  /// The reference as it was given, with all its vertices moved, in their order, those beside another limb onto their
  /// own (matching/result/own_limb.h), and the additional attributes
  /// distance_to_template (unit of the shapes), area_ratio (length_ratio in the plane), and those of the nearest point
  /// of the template (matching/result/deformed_shape.h).
  OriginalShape<Dim> deformed;
  /// The template as it was given, with the additional attribute distance_to_deformed (unit of the shapes).
  OriginalShape<Dim> template_shape;
  /// Distances in both directions, folds, distortion, energies and costs of every level. `summary.interrupted` says
  /// that an observer stopped the matching; the result is then that of the last step.
  MatchSummary summary;
  History history;  ///< every accepted step
  MatchedSurfaces<Dim> surfaces;
  std::vector<LevelVertices<Dim>> levels;  ///< from coarse to fine, if options.report asks for them
  /// Distance, normal and classified shape operator at the nodes of `map.grid`, of the shape that phi deforms and of
  /// the other one.
  CoefficientFields<Dim> moving_fields, target_fields;
};

/// The result of the finished levels, from which a matching of the same shapes and options can be resumed.
template <int Dim>
struct MatchProgress {
  Deformation<Dim> map;
  History history;
  MatchSummary summary;                    ///< `levels`, `gradient_checks` and `run`, whose times are those until then
  std::vector<LevelVertices<Dim>> levels;  ///< those finished, as far as their runs were asked for a report
};

using AnyMatchResult = std::variant<MatchResult<2>, MatchResult<3>>;

inline const MatchSummary& summary_of(const AnyMatchResult& result) {
  return std::visit([](const auto& r) -> const MatchSummary& { return r.summary; }, result);
}

}  // namespace shellmatch
