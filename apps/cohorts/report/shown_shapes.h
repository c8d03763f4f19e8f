#pragma once
/// \file
/// The shapes that the page of a cohort shows.

#include "apps/cohorts/cohort_result.h"

#include <string>

namespace shellmatch {

/// The shape in the middle of the page, with the facets of the atlas.
template <int Dim>
struct CentralShape {
  Surface<Dim> surface;
  std::string kind;  ///< "mean" of two subjects or more; else the only "subject", or the "atlas" where there is none
};

template <int Dim>
CentralShape<Dim> central_shape(const CohortResult<Dim>& result);

/// The points of a column of coordinates: x, y(, z) of point 0, then those of point 1, and so on.
template <int Dim>
std::vector<Vec<Dim>> points_of(const Eigen::Ref<const Eigen::VectorXd>& column) {
  std::vector<Vec<Dim>> points;
  points.reserve(static_cast<std::size_t>(column.size() / Dim));
  for (Eigen::Index i = 0; i + Dim <= column.size(); i += Dim) points.push_back(column.template segment<Dim>(i));
  return points;
}

/// For cameras and frames: `surface` itself, and for each shape of the statistics one without facets, of fewer points,
/// that reaches as far.
template <int Dim>
std::vector<Surface<Dim>> extents(const CohortResult<Dim>& result, const Surface<Dim>& surface);

}  // namespace shellmatch
