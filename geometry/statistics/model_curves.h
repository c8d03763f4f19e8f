#pragma once
/// \file
/// How good a shape model is, by the number of its modes M (Davies 2002; Styner et al. 2003).

#include "geometry/statistics/shape_model.h"

#include <vector>

namespace shellmatch {

/// Entry M - 1 is that of M modes. Distances are root mean squares over the surface, in the unit of the shapes. With n
/// shapes, compactness and specificity have n - 1 entries and generalisation n - 2; beyond the modes that there are,
/// entries repeat the last one.
struct ModelCurves {
  /// C(M): share of the total variance in the first M modes. 1 where there is no variance.
  std::vector<double> compactness;
  /// G(M): mean over the shapes of the distance of a shape to its best approximation by M modes of the model of all
  /// others, or by all modes of that model where it has fewer; M up to n - 2.
  std::vector<double> generalisation, generalisation_error;
  /// S(M): mean over random shapes of the model with M modes of the distance to the nearest shape of the cohort.
  std::vector<double> specificity, specificity_error;
};
// The errors are standard errors: the standard deviation over the root of the number of shapes, or of random shapes; 0
// where there is one.

/// From the scores of the model alone: all curves take n^3 operations, and specificity n times the number of modes for
/// each random shape. Shapes are left out after they were aligned with all. The random shapes are those of
/// ShapeModel::sample_scores(), one set for all M: those of M modes are those of all modes with the other scores 0, so
/// that S changes smoothly with M. \param model with all its modes \param n_samples random shapes for each M, at least
/// 1 \param seed of these \throws InputError for fewer than three shapes or one sample, and for a model whose number of
/// modes was limited
ModelCurves model_curves(const ShapeModel& model, int n_samples, std::uint64_t seed);

/// Of the model of these shapes. \throws InputError as above and as fit_shape_model()
ModelCurves model_curves(const PointSets& aligned, const Eigen::VectorXd& weights, int n_samples, std::uint64_t seed);

}  // namespace shellmatch
