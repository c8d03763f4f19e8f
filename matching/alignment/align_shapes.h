#pragma once
/// \file
/// What is found out about two shapes before the cascade: the pose of the reference, and pairs of points.

#include "geometry/surface/placement.h"
#include "matching/experiment/options.h"
#include "matching/experiment/shape_pair.h"
#include "matching/pairs/landmarks.h"
#include "matching/progress/observer.h"
#include "matching/result/match_summary.h"

#include <optional>
#include <vector>

namespace shellmatch {

template <int Dim>
struct Alignment {
  Similarity<Dim> pose;                ///< moves the reference onto the template, user's coordinates; the identity if it stays
  std::vector<Landmark<Dim>> pairs;    ///< found automatically, in the user's coordinates, before the pose
  std::optional<AlignmentSummary> summary;  ///< none with align.mode none
};

/// Aligns shapes as `options.align` asks for and tells the observer in one line what was chosen, and why.
/// \param shapes in the user's coordinates \param landmarks for the mode `landmarks`
/// \throws InputError in the plane, except for the modes none and auto, which leaves the shapes where they are; with fewer
///   than three landmarks, or landmarks on a line
template <int Dim>
Alignment<Dim> align_shapes(const ShapePair<Dim>& shapes, const std::vector<Landmark<Dim>>& landmarks,
                            const ExperimentOptions& options, Observer& observer);

}  // namespace shellmatch
