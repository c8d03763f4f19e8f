#pragma once
/// \file
/// How the reference is moved before the cascade, and where points of it belong.

#include "matching/alignment/alignment.h"
#include "matching/alignment/alignment_findings.h"
#include "matching/experiment/options.h"
#include "matching/input/shape_pair.h"
#include "matching/progress/observer.h"

#include <vector>

namespace shellmatch {

/// options.align.mode, or none with `auto` where input.placement is as-is: who takes coordinates as they are means that
/// the shapes lie as they belong.
AlignMode align_mode(const ExperimentOptions& options);

/// Aligns shapes as `options.align` asks for and tells the observer in one line what was chosen, and why.
/// \param shapes in the user's coordinates \param landmarks determine the pose with the mode `landmarks`, and take part
/// in search and
///   trials with the others
/// \param findings takes what takes long, and may have some of it \param trials of these shapes
/// \throws InputError for the mode `landmarks` with fewer than three landmarks (two in the plane), or landmarks on a
/// line (in one
///   point)
template <int Dim>
Alignment<Dim> align_shapes(const ShapePair<Dim>& shapes, const std::vector<Landmark<Dim>>& landmarks,
                            const ExperimentOptions& options, Observer& observer, AlignmentFindings<Dim>& findings,
                            Trials<Dim>& trials);
template <int Dim>
Alignment<Dim> align_shapes(const ShapePair<Dim>& shapes, const std::vector<Landmark<Dim>>& landmarks,
                            const ExperimentOptions& options, Observer& observer) {
  AlignmentFindings<Dim> none;
  Trials<Dim> trials(shapes, landmarks, options, observer);
  return align_shapes(shapes, landmarks, options, observer, none, trials);
}

}  // namespace shellmatch
