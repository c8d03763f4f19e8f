#pragma once
/// \file
/// The shapes that the page of a cohort shows, and small pictures of them, drawn without a display.

#include "apps/cohorts/cohort_result.h"
#include "geometry/surface/surface.h"
#include "matching/render/canvas/contours.h"
#include "matching/render/canvas/image.h"
#include "matching/render/surfaces/camera.h"

#include <cstddef>
#include <span>
#include <string>
#include <type_traits>
#include <vector>

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

/// Draws shapes with one camera, in the plane one frame.
template <int Dim>
class ShapeDrawer {
 public:
  /// \param all shapes that the pictures have to hold \param size of a picture's side in pixels
  ShapeDrawer(std::span<const Surface<Dim>* const> all, int size);

  /// \param values at the vertices, coloured from 0 to `scale_end`; where that is 0 the shape is plain
  Image draw(const Surface<Dim>& shape, const std::vector<double>& values, double scale_end) const;

 private:
  std::conditional_t<Dim == 3, Camera, Frame> view_;
  int size_;
};

struct SubjectThumbnails {
  std::vector<std::string>
      pictures;                ///< bytes of a PNG for each subject; empty for those not in the statistics or left out
  double scale_end = 0;        ///< of the colours: distance from the mean at their end; 0 where all have one colour
  std::size_t n_left_out = 0;  ///< subjects of the statistics that have none
};

/// The deformed atlas of each subject after Procrustes analysis, all from one camera (in one frame). Colours are
/// distances from `mean`, up to that below which 98 % of all are. \param order subjects; pictures are made of the first
/// `most` of the statistics
template <int Dim>
SubjectThumbnails subject_thumbnails(const CohortResult<Dim>& result, const Surface<Dim>& mean,
                                     const std::vector<std::size_t>& order, std::size_t most);

}  // namespace shellmatch
