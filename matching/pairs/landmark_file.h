#pragma once
/// \file
/// Landmarks from CSV files (docs/landmarks.md).

#include "matching/pairs/landmarks.h"

#include <vector>

namespace shellmatch {

/// Reads the landmarks that the options name: one file with columns `x1,y1[,z1]` or `vertex1` and `x2,y2[,z2]` or
/// `vertex2`, or two files with columns `name` and `x,y[,z]` or `vertex` each; a column `weight` or `sd` of the first
/// file weighs them, and `name` names them. None where the options name no file.
/// \param reference, template_shape vertices as in the files of the shapes, to which indices from 0 refer
/// \throws InputError with file and line
template <int Dim>
std::vector<Landmark<Dim>> read_landmarks(const LandmarkOptions& options, const std::vector<Vec<Dim>>& reference,
                                          const std::vector<Vec<Dim>>& template_shape);

}  // namespace shellmatch
