#pragma once
/// \file
/// A reference on other shapes, where earlier matchings have carried it, and what that says of its pose on one more.

#include "alignment/options.h"
#include "matching/input/shape_pair.h"
#include "matching/prediction/predict_pose.h"
#include "matching/progress/observer.h"

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace shellmatch {

/// Where earlier matchings have carried the vertices of the reference's file: one list for each.
template <int Dim>
using ReferenceImages = std::vector<std::vector<Vec<Dim>>>;

/// Reads the deformed references of output folders. \param n_vertices of the reference's file
/// \throws InputError naming `start.images`, where one cannot be read or has another number of vertices
template <int Dim>
ReferenceImages<Dim> read_reference_images(const std::vector<std::string>& folders, std::size_t n_vertices);

/// None where the images leave it open how the shapes belong together, or do not come near everywhere; the observer is
/// told. Outlines have none: their search takes no longer.
template <int Dim>
std::optional<PredictedPose> clear_pose(const ShapePair<Dim>& shapes, const ReferenceImages<Dim>& images,
                                        const AlignmentOptions& options, Observer& observer);

}  // namespace shellmatch
