#pragma once
/// \file
/// What a matching gives back: values, which stand by themselves. matching/write_result.h makes files of them.

#include "geometry/surface/surface.h"
#include "grid/fits/curvature.h"
#include "matching/level/deformation.h"
#include "matching/result/history.h"
#include "matching/result/match_summary.h"

#include <variant>
#include <vector>

namespace shellmatch {

/// The closed surfaces that were matched, in the unit domain.
template <int Dim>
struct MatchedSurfaces {
  Surface<Dim> reference, template_shape;
  Surface<Dim> deformed;         ///< vertex by vertex the image of `reference`
  std::vector<double> distance;  ///< of each vertex of `deformed` to `template_shape`, >= 0
};

template <int Dim>
struct MatchResult {
  /// The map phi: `map.apply(x)` moves any point, in the coordinates of the shapes that were given.
  Deformation<Dim> map;
  /// The reference as it was given, each of its vertices moved, in their order; with the attributes
  /// distance_to_template (unit of the shapes) and area_ratio (length_ratio in the plane) besides its own.
  OriginalShape<Dim> deformed;
  /// Distances both ways, folds, distortion, energies and costs of every level. Where `summary.interrupted` an observer
  /// has stopped the matching, and all the rest is what was reached until then.
  MatchSummary summary;
  History history;  ///< every accepted step
  MatchedSurfaces<Dim> surfaces;
  /// Distance, normal and classified shape operator of both shapes at the nodes of `map.grid`.
  CoefficientFields<Dim> reference_fields, template_fields;
};

/// What the finished levels of a matching have given: from here another one of the same shapes and options goes on.
template <int Dim>
struct MatchProgress {
  Deformation<Dim> map;
  History history;
  MatchSummary summary;  ///< `levels`, `gradient_checks` and `run`, with the times until then
};

using AnyMatchResult = std::variant<MatchResult<2>, MatchResult<3>>;

inline const MatchSummary& summary_of(const AnyMatchResult& result) {
  return std::visit([](const auto& r) -> const MatchSummary& { return r.summary; }, result);
}

}  // namespace shellmatch
