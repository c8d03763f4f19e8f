#pragma once
/// \file
/// What happens to two shapes before a matching: direction, alignment, placement.

#include "matching/alignment/align_shapes.h"
#include "matching/level/deformation.h"

#include <optional>
#include <vector>

namespace shellmatch {

template <int Dim>
struct PreparedPair {
  std::optional<DirectionSummary> direction;  ///< none where nothing had to be found out
  Alignment<Dim> alignment;                   ///< its pose has moved the shape that is deformed
  Similarity<Dim> placement;                  ///< has moved both after that
  Surface<Dim> unbent;                        ///< the reference's surface moved by all but the bend; empty without
  Space space = Space::unsaid;                ///< the frame of the user's coordinates, where the shapes name it

  bool is_backward() const { return direction && direction->backward; }
  MapFrame<Dim> frame() const { return {placement, alignment.pose, is_backward(), space, alignment.bend}; }
};

/// Chooses the direction as options.align.direction asks for, aligns the shape that is deformed with the other one, and
/// moves both surfaces into the unit domain. \param shapes in the user's coordinates, reference first, also afterwards
/// \param findings takes what takes long, and may have some of it from an earlier call
/// \throws InputError as check_landmarks, align_shapes and ShapePair::place
template <int Dim>
PreparedPair<Dim> prepare_pair(ShapePair<Dim>& shapes, const std::vector<Landmark<Dim>>& landmarks,
                               const ExperimentOptions& options, Observer& observer, AlignmentFindings<Dim>& findings);
template <int Dim>
PreparedPair<Dim> prepare_pair(ShapePair<Dim>& shapes, const std::vector<Landmark<Dim>>& landmarks,
                               const ExperimentOptions& options, Observer& observer) {
  AlignmentFindings<Dim> none;
  return prepare_pair(shapes, landmarks, options, observer, none);
}

}  // namespace shellmatch
