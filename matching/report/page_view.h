#pragma once
/// \file
/// The first view of shapes in space on a page.

#include "geometry/surface/surface.h"

#include <array>
#include <span>

namespace shellmatch {

/// In the coordinates in which the shapes are shown: what to look at, where up is and where the eye, and half of the
/// height that is seen there (matching/render/surfaces/camera.h).
struct PageView {
  std::array<double, 3> target, up, backward;
  double half_height;
};

/// A view that shows all surfaces whole, and most of them.
/// \pre at least one vertex
PageView page_view(std::span<const Surface<3>* const> surfaces);

}  // namespace shellmatch
