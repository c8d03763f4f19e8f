#pragma once
/// \file
/// Small pictures of shapes of a cohort that are to be compared.

#include "geometry/surface/surface.h"
#include "matching/render/canvas/contours.h"
#include "matching/render/canvas/image.h"
#include "matching/render/surfaces/camera.h"

#include <span>
#include <type_traits>
#include <vector>

namespace shellmatch {

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

}  // namespace shellmatch
