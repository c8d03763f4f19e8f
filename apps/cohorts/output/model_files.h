#pragma once
/// \file
/// The shape model of a cohort as arrays, meshes and animations.

#include "apps/cohorts/cohort_result.h"

#include <string>

namespace shellmatch {

/// Modes are drawn at so many standard deviations from the mean.
inline constexpr double mode_deviations = 2;

/// points.npy (subjects, vertices, coordinates) in the subjects' own coordinates, the same as points.csv and
/// points.tps where there are at most five million points, aligned.npy after
/// Procrustes analysis, faces.npy, modes.npy (modes, vertices, coordinates), the mean with columns of
/// deviations and of the difference of groups, and meshes of the first modes. \param points Dim * V
/// coordinates of each subject \throws EnvironmentError if a file cannot be written
template <int Dim>
void write_model(const CohortResult<Dim>& result, const Eigen::MatrixXd& points, int n_mode_meshes,
                 const std::string& folder);

/// Writes mode_1.webp, mode_2.webp, ... of the first modes: the shape swings between so many standard
/// deviations on either side of the mean (mode_deviations), with its displacement from the mean as colour.
/// \pre result.model \throws EnvironmentError if a file cannot be written
template <int Dim>
void write_mode_animations(const CohortResult<Dim>& result, int n_modes, const std::string& folder);

}  // namespace shellmatch
