#pragma once
/// \file
/// The two shapes of an experiment as they are read, and their common placement in the unit domain.

#include "geometry/distance/surface_bend.h"
#include "geometry/surface/placement.h"
#include "geometry/io/read_shape.h"
#include "matching/experiment/options.h"
#include "matching/input/shape_source.h"
#include "matching/pairs/landmark_file.h"
#include "matching/progress/observer.h"
#include "matching/result/match_summary.h"

#include <algorithm>
#include <array>
#include <variant>

namespace shellmatch {

template <int Dim>
struct ShapePair {
  Shape<Dim> reference, template_shape;
  /// The frame of the reference's file, where the shapes name one; both shapes are then given in the template's,
  /// `original.space`.
  Space reference_file_space = Space::unsaid;

  /// Had so much of a shape to be made up that it may be a part of the other? Spectra are those of whole surfaces.
  bool one_is_part() const { return std::max(reference.invented_share, template_shape.invented_share) > least_of_part; }

  /// Moves the reference's surface by the bend, if there is one, by `pose`, and then both into the unit domain
  /// according to `options.input`. Returns the similarity that does the latter. \throws InputError for placement as-is
  /// of shapes that reach beyond the domain
  Similarity<Dim> place(const ExperimentOptions& options, const Similarity<Dim>& pose = {},
                        const SurfaceBend<Dim>* bend = nullptr);
};

using AnyShapePair = std::variant<ShapePair<2>, ShapePair<3>>;

template <int Dim>
LandmarkSpaces landmark_spaces(const ShapePair<Dim>& shapes) {
  const OriginalShape<Dim>&reference = shapes.reference.original, &template_shape = shapes.template_shape.original;
  return {shapes.reference_file_space, template_shape.space, reference.frame, template_shape.frame};
}

/// Brings the reference into the frame of the template, where both name one and it is not the same; a shape that names
/// none is in the frame of the other. Surfaces are in the user's coordinates. The observer is told.
template <int Dim>
void share_space(ShapePair<Dim>& pair, Observer& observer);

/// Takes parts that lie inside other parts of their shape out of its evidence, unless `input.buried` keeps them. The
/// observer is told.
template <int Dim>
void leave_out_buried(ShapePair<Dim>& pair, const InputOptions& input, Observer& observer);

/// Reads both shapes, brings them into one frame, leaves out what is buried and reports their repairs to the observer.
/// Where meshes name no frame, that of 3D Slicer's points decides in which of both they lie
/// (matching/pairs/point_frame.h). \throws InputError, also for shapes of different dimensions
AnyShapePair open_shape_pair(const InputOptions& input, const LandmarkOptions& landmarks, Observer& observer);

/// The same of shapes that a program has, reference first; the files that `input` names are not read.
AnyShapePair open_shape_pair(std::array<ShapeInput, 2> shapes, const InputOptions& input,
                             const LandmarkOptions& landmarks, Observer& observer);

}  // namespace shellmatch
